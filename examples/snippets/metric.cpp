// SPDX-License-Identifier: MIT
//
// The code on docs/metric.md: signed duals, stars, codifferential, Laplacians, inner products.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <polydec.h>

namespace {

void law_of_volumes() {
    const polydec::Mesh box = polydec::kuhn(3, 2);
    const polydec::SimplicialComplex K(box.simplices);
    const auto volumes = polydec::circumcentric_volumes(K, box.points);
    for (int k = 0; k <= 3; ++k)
        std::cout << volumes.primal(k).dot(volumes.dual(k)) << ' ';
    std::cout << "= binomials times volume 1\n";
}

void signs_of_dual_edges() {
    polydec::Mesh pair;
    pair.simplices.resize(2, 3);
    pair.simplices << 0, 1, 2, 0, 3, 1; // two triangles at the edge 0, 1 of length 2
    pair.points.resize(4, 2);
    for (const double height : {1.5, 1.0, 0.5}) {
        pair.points << -1, 0, 1, 0, 0, height, 0, -height;
        const polydec::SimplicialComplex K(pair.simplices);
        const auto volumes = polydec::circumcentric_volumes(K, pair.points);
        std::cout << "height " << height << ": dual edge " << volumes.dual(1)[0] << ", star_1 "
                  << polydec::star(volumes, 1).diagonal()[0] << '\n';
    }
}

void flat_torus() {
    polydec::LengthMesh flat = polydec::length_mesh(polydec::torus(12, 8));
    flat.lengths.setOnes(); // six equilateral triangles around every vertex
    const auto mesh = polydec::discretize(flat);
    const polydec::Vector star = polydec::star(mesh, 0).diagonal();
    std::cout << "area " << mesh.volumes().primal(2).sum() << ", star_0 from " << star.minCoeff()
              << " to " << star.maxCoeff() << '\n';
}

void adjoint() {
    const auto mesh = polydec::discretize(polydec::goldberg(4));
    const auto& P = mesh.complex();
    const polydec::Cochain f{polydec::Side::primal, 0, polydec::Vector::Random(P.size(0))};
    const polydec::Cochain w{polydec::Side::primal, 1, polydec::Vector::Random(P.size(1))};
    const double left = polydec::inner_product(mesh, polydec::d(P, f), w);
    const double right = polydec::inner_product(mesh, f, polydec::codifferential(mesh, w));
    std::cout << "<df, w> - <f, delta w> = " << (std::abs(left - right) < 1e-12 ? "0" : "not 0")
              << '\n';
    const auto twice = polydec::star(mesh, polydec::star(mesh, w));
    std::cout << "star star w = " << twice.values[0] / w.values[0] << " w\n";
}

void laplacian_of_a_parabola() {
    const auto mesh = polydec::discretize(polydec::grid(8, 8));
    const polydec::Vector u = mesh.points().rowwise().squaredNorm(); // x^2 + y^2
    const polydec::Vector Lu = polydec::laplacian(mesh, 0) * u;
    const polydec::Index middle = 4 * 9 + 4;
    std::cout << "Delta(x^2 + y^2) in the middle: " << Lu[middle] << '\n';

    const polydec::SparseMatrix A = polydec::symmetric_laplacian(mesh, 0);
    std::cout << "stencil: " << A.coeff(middle, middle) << " and " << A.coeff(middle, middle + 1)
              << ", along the diagonal " << A.coeff(middle, middle + 10) << '\n';
}

void kinds_of_stars() {
    auto input = polydec::grid(8, 8);
    input.points.col(0) += 0.6 * input.points.col(1); // which makes triangles obtuse
    const auto mesh = polydec::discretize(input);
    const auto chosen = mesh.with_stars(polydec::StarKind::automatic).chosen_stars();
    const polydec::HodgeStar star = polydec::star(chosen.stars, 1);
    const polydec::Vector x = polydec::Vector::Random(star.size());
    std::cout << polydec::star(mesh, 1).negatives().size() << " negative duals; "
              << polydec::name(chosen.kind) << ", " << 100 * chosen.galerkin_share()
              << " % of the cells by Galerkin, and " << (x.dot(star * x) > 0 ? "" : "not ")
              << "positive\n";
}

void other_centers() {
    for (const auto& centers : {polydec::Centers(), polydec::Centers::centroids()}) {
        const auto mesh = polydec::discretize(polydec::grid(8, 8), {.centers = centers});
        const polydec::Vector u = mesh.points().rowwise().prod(); // xy, which is harmonic
        const polydec::Vector Lu = polydec::laplacian({mesh.complex(), mesh.volumes()}, 0) * u;
        std::cout << mesh.complex().size(2) << " cells, smallest star_1 "
                  << polydec::star(mesh, 1).diagonal().minCoeff() << ", Delta xy in the middle "
                  << std::round(1e6 * Lu[4 * 9 + 4]) / 1e6 << '\n';
    }
}

} // namespace

int main() {
    std::srand(1);
    law_of_volumes();
    signs_of_dual_edges();
    flat_torus();
    adjoint();
    laplacian_of_a_parabola();
    kinds_of_stars();
    other_centers();
}
