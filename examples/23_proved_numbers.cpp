// SPDX-License-Identifier: MIT
//
// Numbers of a shape, not of its mesh: two proved bounds of the smallest eigenvalue of an L, on
// triangles refined where the bounds are far apart, and the error of a Poisson solution.
#include <iomanip>
#include <iostream>
#include <polydec.h>

namespace {

/// Three unit squares around a reentrant corner.
polydec::Mesh l_shape(int cells) {
    polydec::Mesh mesh = polydec::kuhn({2 * cells, 2 * cells}, {2.0, 2.0});
    polydec::Index kept = 0;
    for (polydec::Index t = 0; t < mesh.simplices.rows(); ++t) {
        const auto corners = mesh.points(mesh.simplices.row(t), Eigen::indexing::all);
        if ((corners.colwise().mean().array() < 1).any())
            mesh.simplices.row(kept++) = mesh.simplices.row(t).eval();
    }
    mesh.simplices.conservativeResize(kept, Eigen::NoChange);
    return mesh;
}

} // namespace

int main() {
    const auto mesh = polydec::discretize(l_shape(8), {.criterion = polydec::MergeCriterion::none});
    const auto shape = polydec::shape_of(mesh, {polydec::BoundaryCondition::essential});
    std::cout << std::setprecision(9);
    for (const double width : {1e-2, 1e-4}) {
        const auto found =
            polydec::shape_spectrum(shape, {.count = 1, .width = width, .max_triangles = 3000});
        const double low = found.lower[0], high = found.upper[0];
        std::cout << "the first eigenvalue, 9.63972384, is proved to lie between " << low << " and "
                  << high << ": " << (low < 9.63972384 && 9.63972385 < high ? "it does" : "wrong")
                  << '\n';
    }

    // u with -div grad u = 1, and u = 0 on the boundary
    const polydec::PoissonSolver solver({mesh, polydec::Side::primal, 0, {}});
    const polydec::Vector f = polydec::Vector::Ones(mesh.complex().size(0));
    const polydec::Vector u = solver.solve({polydec::Side::primal, 0, f}).form.values;
    const auto error =
        polydec::poisson_error({shape, polydec::DenseMatrix::Ones(shape.pieces.size(2), 1)}, u);
    std::cout << std::setprecision(3) << "the gradient is off by at most "
              << 100 * error.energy / error.size << " %\n";
}
