// SPDX-License-Identifier: MIT
//
// The code on docs/products.md: wedges, interior product, Lie derivative, upwinding.
#include <cstdlib>
#include <iostream>
#include <polydec.h>

namespace {

polydec::SmoothForm constant(double x, double y) {
    return polydec::circulation_form([x, y](const polydec::Vector&) {
        return polydec::Vector{{x, y}};
    });
}

void wedge_on_a_square() {
    const auto square = polydec::discretize(polydec::grid(1, 1));
    const auto dx = polydec::de_rham(square, 1, constant(1, 0));
    const auto dy = polydec::de_rham(square, 1, constant(0, 1));
    std::cout << "dx ^ dy over the unit square: " << polydec::wedge(square, dx, dy).values[0]
              << '\n';

    // the same with zero on the removed diagonal, which is no cochain map
    const auto on_triangles = polydec::wedge(square.input(), polydec::to_input(square, dx),
                                             polydec::to_input(square, dy));
    std::cout << "with 0 on the diagonal: " << polydec::to_merged(square, on_triangles).values[0]
              << '\n';
}

void leibniz() {
    const auto mesh = polydec::discretize(polydec::hexagons(8));
    const auto& P = mesh.complex();
    const auto product = [&](const polydec::Cochain& a, const polydec::Cochain& b) {
        return polydec::wedge(mesh, a, b);
    };
    const polydec::Cochain f{polydec::Side::primal, 0, polydec::Vector::Random(P.size(0))};
    const polydec::Cochain w{polydec::Side::primal, 1, polydec::Vector::Random(P.size(1))};
    const auto defect =
        polydec::d(P, product(f, w)) - product(polydec::d(P, f), w) - product(f, polydec::d(P, w));
    std::cout << "d(f ^ w) - df ^ w - f ^ dw = " << (defect.values.norm() < 1e-12 ? "0" : "not 0")
              << '\n';
}

void energy() {
    const auto mesh = polydec::discretize(polydec::grid(4, 4));
    const auto& P = mesh.complex();
    const auto w = polydec::de_rham(mesh, 1, constant(3, 4));
    const auto density = polydec::primal_dual_wedge(P, w, polydec::star({P, mesh.volumes()}, w));
    std::cout << "integral of w ^ star w: " << density.sum() << ", inner product "
              << polydec::inner_product({P, mesh.volumes()}, w, w) << '\n';
}

void dual_product() {
    const auto mesh = polydec::discretize(polydec::grid(4, 4));
    const auto dx = polydec::dual_de_rham(mesh, 1, constant(1, 0));
    const auto dy = polydec::dual_de_rham(mesh, 1, constant(0, 1));
    std::cout << "dx ^ dy over all dual cells: " << polydec::dual_wedge(mesh, dx, dy).values.sum()
              << '\n';
}

void contraction() {
    const auto mesh = polydec::discretize(polydec::grid(4, 4));
    const polydec::Points X = polydec::Vector{{2, 5}}.transpose().replicate(25, 1);
    const polydec::SparseMatrix i_X =
        polydec::interior_product(mesh, X, 1, polydec::Sampling::centered);
    const auto dx = polydec::de_rham(mesh, 1, constant(1, 0));
    const polydec::Vector values = i_X * dx.values;
    std::cout << "i_X dx lies in " << values.minCoeff() << " .. " << values.maxCoeff() << '\n';
}

void transport() {
    const auto torus = polydec::discretize(polydec::torus(32, 16));
    polydec::Points X = polydec::Points::Zero(torus.points().rows(), 3);
    X.col(0) = -torus.points().col(1);
    X.col(1) = torus.points().col(0); // around the axis

    const polydec::Vector hot = (torus.points().col(0).array() > 1).cast<double>();
    for (const auto sampling : {polydec::Sampling::centered, polydec::Sampling::upwind}) {
        const polydec::SparseMatrix L = polydec::lie_derivative(torus, X, 0, sampling);
        polydec::Vector u = hot;
        for (int step = 0; step < 50; ++step)
            u -= 0.05 * (L * u);
        std::cout << (sampling == polydec::Sampling::upwind ? "upwind" : "centered")
                  << ": values from " << u.minCoeff() << " to " << u.maxCoeff() << '\n';
    }
}

} // namespace

int main() {
    std::srand(1);
    wedge_on_a_square();
    leibniz();
    energy();
    dual_product();
    contraction();
    transport();
}
