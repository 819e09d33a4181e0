// SPDX-License-Identifier: MIT
#include "complex/incidence_rows.h"
#include "tests/support/test.h"

namespace polydec::test {

using Triangles = std::vector<std::array<GluedSurface::SignedEdge, 3>>;

// sides a and b of the square, and its diagonal c
GluedSurface square_torus() {
    return GluedSurface({{{{0, 1}, {1, 1}, {2, -1}}}, {{{2, 1}, {0, -1}, {1, -1}}}});
}

GluedSurface square_klein() {
    return GluedSurface({{{{0, 1}, {1, 1}, {2, -1}}}, {{{2, 1}, {0, -1}, {1, 1}}}});
}

GluedSurface two_sided_plane() {
    return GluedSurface({{{{0, 1}, {1, 1}, {2, -1}}}, {{{2, 1}, {0, 1}, {1, 1}}}});
}

GluedSurface folded_triangle() {
    return GluedSurface(Triangles{{{{0, 1}, {0, -1}, {1, 1}}}});
}

GluedSurface moebius_triangle() {
    return GluedSurface(Triangles{{{{0, 1}, {0, 1}, {1, 1}}}});
}

void flip_at_random(GluedSurface& surface, unsigned seed,
                    const std::function<void(Index)>& before) {
    std::mt19937 random(seed);
    for (Index i = 0; i < 2 * surface.edges(); ++i) {
        const Index e = static_cast<Index>(random() % static_cast<unsigned>(surface.edges()));
        if (!surface.can_flip(e))
            continue;
        if (!surface.is_coherent(e))
            surface.reverse(GluedSurface::triangle(surface.halfedges(e)[1]));
        before(e);
        surface.flip(e);
    }
}

CellComplex cell_complex(const GluedSurface& surface) {
    IncidenceRows edges(surface.edges(), surface.vertices(), surface.edges() * 2);
    for (Index e = 0; e < surface.edges(); ++e) {
        edges.add(surface.first_vertex(e), -1);
        edges.add(surface.last_vertex(e), 1);
        edges.end_cell();
    }
    IncidenceRows triangles(surface.triangles(), surface.edges(), surface.triangles() * 3);
    for (Index h = 0; h < 3 * surface.triangles(); ++h) {
        triangles.add(surface.edge(h), surface.sign(h));
        if (h % 3 == 2)
            triangles.end_cell();
    }
    std::vector<Coboundary> coboundaries;
    coboundaries.push_back(edges.finish());
    coboundaries.push_back(triangles.finish());
    return {CellComplex::Unchecked{}, std::move(coboundaries)};
}

std::vector<std::string> names_of_surfaces() {
    std::vector<std::string> names;
    for (const auto& name : names_of_meshes()) {
        const auto& K = merged(name).K();
        if (K.dimension() != 2)
            continue;
        const auto& counts = K.coface_counts(1);
        if (*std::max_element(counts.begin(), counts.end()) <= 2)
            names.push_back(name);
    }
    return names;
}

Mesh shaken(Mesh mesh, double amplitude, unsigned seed) {
    const SimplicialComplex K(mesh.simplices);
    double sum = 0;
    for (Index e = 0; e < K.size(1); ++e)
        sum +=
            (mesh.points.row(K.simplices(1)(e, 1)) - mesh.points.row(K.simplices(1)(e, 0))).norm();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> offset(-amplitude * sum / K.size(1),
                                                  amplitude * sum / K.size(1));
    for (double& coordinate : mesh.points.reshaped())
        coordinate += offset(random);
    return mesh;
}

} // namespace polydec::test
