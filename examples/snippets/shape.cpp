// SPDX-License-Identifier: MIT
//
// The code on docs/what-is-proved.md: eigenvalues of the unit square, enclosed.
#include <iomanip>
#include <iostream>
#include <polydec.h>

namespace {

polydec::Shape square_shape(int n) {
    const auto mesh =
        polydec::discretize(polydec::kuhn(2, n), {.criterion = polydec::MergeCriterion::none});
    return polydec::shape_of(mesh, {polydec::BoundaryCondition::essential});
}

} // namespace

int main() {
    const auto found = polydec::shape_spectrum(square_shape(16), {.count = 3});
    const auto count = polydec::count_below(square_shape(16), 25);
    std::cout << std::setprecision(6) << "2 pi^2 = 19.7392 lies in [" << found.lower[0] << ", "
              << found.upper[0] << "]\nbelow 25: at least " << count.at_least << ", at most "
              << *count.at_most << '\n';
}
