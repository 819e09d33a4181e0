// SPDX-License-Identifier: MIT
//
// The code on docs/what-is-proved.md: eigenvalues of the unit square, enclosed, and an error.
#include <iomanip>
#include <iostream>
#include <polydec.h>

namespace {

polydec::Shape square_shape(int n) {
    const auto mesh =
        polydec::discretize(polydec::kuhn(2, n), {.criterion = polydec::MergeCriterion::none});
    return polydec::shape_of(mesh, {polydec::BoundaryCondition::essential});
}

polydec::PoissonProblem torsion(int n) {
    const auto shape = square_shape(n);
    return {shape, polydec::DenseMatrix::Ones(shape.pieces.size(2), 1)};
}

} // namespace

int main() {
    const auto found = polydec::shape_spectrum(square_shape(16), {.count = 3});
    const auto count = polydec::count_below(square_shape(16), 25);
    std::cout << std::setprecision(6) << "2 pi^2 = 19.7392 lies in [" << found.lower[0] << ", "
              << found.upper[0] << "]\nbelow 25: at least " << count.at_least << ", at most "
              << *count.at_most << '\n';

    const auto problem = torsion(16); // f = 1, u = 0 on the boundary
    const polydec::Vector zero = polydec::Vector::Zero(problem.shape.pieces.size(0));
    const auto error = polydec::poisson_error(problem, zero);
    const auto goal = polydec::goal_interval(problem, zero, problem.source);
    std::cout << "|grad u| = 0.187468 is at most " << error.energy
              << ", of u = 0\nits square .0351443 "
              << "lies in [" << goal.lower << ", " << goal.upper << "]\n";
}
