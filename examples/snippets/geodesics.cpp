// SPDX-License-Identifier: MIT
//
// The code on docs/geodesics.md: distance and parallel transport from lengths alone.
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

struct Sphere {
    polydec::Mesh mesh;
    polydec::GluedSurface surface;
    polydec::Vector lengths;
};

Sphere sphere(int frequency) {
    const polydec::Mesh mesh = polydec::icosphere(frequency);
    const polydec::GluedSurface surface(polydec::SimplicialComplex(mesh.simplices));
    polydec::Vector lengths(surface.edges());
    for (polydec::Index e = 0; e < surface.edges(); ++e)
        lengths[e] =
            (mesh.points.row(surface.first_vertex(e)) - mesh.points.row(surface.last_vertex(e)))
                .norm();
    return {mesh, surface, lengths};
}

void distances() {
    for (const int frequency : {16, 32, 64}) {
        const auto [mesh, surface, lengths] = sphere(frequency);
        const std::vector<polydec::Index> source{0};
        const polydec::Vector exact = polydec::geodesic_distance(surface, lengths, source);
        polydec::GeodesicDistance smoothed(surface, lengths,
                                           {.method = polydec::DistanceMethod::heat});
        const polydec::Vector heat = smoothed.to(source).values;

        const polydec::Vector cosine =
            (mesh.points * mesh.points.row(0).transpose()).cwiseMax(-1).cwiseMin(1);
        const polydec::Vector arc = cosine.array().acos();
        std::cout << surface.vertices() << " vertices: mean error "
                  << (exact - arc).cwiseAbs().mean() << ", of heat "
                  << (heat - arc).cwiseAbs().mean() << '\n';
    }
}

void gluing() {
    // a square cut in two, with opposite sides glued: one vertex, three edges that are loops
    const polydec::GluedSurface torus({{{{0, 1}, {1, 1}, {2, -1}}}, {{{2, 1}, {0, -1}, {1, -1}}}});
    const polydec::Vector lengths{{1, 1, std::numbers::sqrt2}};
    const auto frames = polydec::tangent_frames(torus, lengths);
    std::cout << torus.vertices() << " vertex with angles of " << frames.sums[0] / std::numbers::pi
              << " pi around it\n";
}

void transport() {
    const auto [mesh, surface, lengths] = sphere(32);
    polydec::ParallelTransport solver(surface, lengths);
    const polydec::TangentFrames& frames = solver.frames();

    const polydec::Index h = frames.reference[0];
    const std::complex<double> along = 2.0 * frames.direction(h);
    const polydec::TangentVectors vectors =
        solver.extend(std::vector<polydec::Index>{0}, polydec::TangentVectors{{along}});
    const polydec::Index v = surface.head(h);
    const std::complex<double> carried = frames.carried(h) * along;
    std::cout << "length " << std::abs(vectors[v]) << ", angle to the edge "
              << std::abs(std::arg(vectors[v] / carried)) << '\n';
}

} // namespace

int main() {
    distances();
    gluing();
    transport();
}
