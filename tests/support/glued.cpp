// SPDX-License-Identifier: MIT
#include "tests/support/glued.h"

#include "tests/support/families.h"
#include "tests/support/merged.h"

#include <algorithm>
#include <random>

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
