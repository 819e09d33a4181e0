// SPDX-License-Identifier: MIT
//
// The right column of docs/coming-from/geometry-central.md.
#include <iostream>
#include <polydec.h>

namespace {

void mesh_and_operators(const polydec::Discretization& mesh) {
    const auto vertices = mesh.complex().size(0);
    const auto& positions = mesh.points();
    const auto betti = polydec::betti_numbers(mesh.complex());
    const auto& lengths = mesh.volumes().primal(1);
    const auto& areas = mesh.volumes().primal(2);
    const polydec::SparseMatrix d0 = polydec::derivative(mesh.complex(), 0);
    const polydec::Vector star1 = polydec::star(mesh, 1).diagonal();
    const polydec::Vector inverse = polydec::star(mesh, 1).inverse();
    const polydec::SparseMatrix L = polydec::symmetric_laplacian(mesh, 0).matrix();

    const double difference = (L - d0.transpose() * star1.asDiagonal() * d0).norm() +
                              (star1.cwiseProduct(inverse).array() - 1).matrix().norm();
    std::cout << vertices << " vertices, Betti numbers " << betti[0] << ' ' << betti[1] << ' '
              << betti[2] << ", area " << areas.sum() << ", longest edge " << lengths.maxCoeff()
              << ", highest vertex " << positions.col(2).maxCoeff() << '\n'
              << "the cotangent Laplacian is d^T star d: " << (difference < 1e-12 ? "yes" : "no")
              << '\n';
}

void solves(const polydec::Discretization& mesh) {
    const polydec::Vector z = mesh.points().col(2);
    const polydec::PoissonSolver solver({mesh, polydec::Side::primal, 0});
    const polydec::Cochain u = solver.solve({polydec::Side::primal, 0, z}).form;
    const auto modes = polydec::spectrum({mesh, polydec::Side::primal, 0}, {.count = 4});
    const auto parts = polydec::hodge_decomposition({mesh, polydec::Side::primal, 1},
                                                    polydec::d(mesh.complex(), u));

    std::cout << "u / z " << u.values.dot(z) / z.squaredNorm() << ", eigenvalue "
              << modes.eigenvalues[1] << ", coexact part of du "
              << (polydec::norm(mesh, parts.coexact) < 1e-9 ? "none" : "some") << '\n';
    polydec::write_page("modes.html", polydec::draw_page(mesh, modes));
}

void surfaces(const polydec::Discretization& mesh) {
    const std::vector<polydec::Index> source{0};
    const polydec::Vector exact = polydec::geodesic_distance(mesh, source);
    const polydec::GeodesicDistance heat(mesh, {.method = polydec::DistanceMethod::heat});
    const polydec::Vector smoothed = heat.to(source).values;
    const polydec::SurfacePaths paths(mesh, source);
    const double length = paths.from(1).length;

    const polydec::GluedSurface surface(mesh.input());
    const polydec::Vector sides = polydec::length_mesh(polydec::icosphere(8)).lengths;
    const polydec::ParallelTransport transport(surface, sides);
    const polydec::TangentVectors along{{transport.frames().direction(0)}};
    const polydec::TangentVectors carried = transport.extend(source, along);

    std::cout << "farthest " << exact.maxCoeff() << ", by heat " << smoothed.maxCoeff()
              << ", path as long: " << (std::abs(length - exact[1]) < 1e-12 ? "yes" : "no")
              << ", carried " << std::abs(carried[1]) << '\n';
}

} // namespace

int main() {
    polydec::write_mesh("sphere.obj", polydec::icosphere(8));
    const polydec::Mesh input = polydec::read_mesh("sphere.obj");
    const auto mesh = polydec::discretize(input);
    const auto delaunay = polydec::discretize(input, {.delaunay = polydec::Delaunay::flips});

    mesh_and_operators(mesh);
    solves(mesh);
    surfaces(mesh);
    std::cout << "edges of the Delaunay triangulation: " << delaunay.complex().size(1) << '\n';
}
