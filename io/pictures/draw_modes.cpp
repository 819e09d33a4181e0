// SPDX-License-Identifier: MIT
#include "io/pictures/draw_modes.h"

#include "io/pictures/draw_cells.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

/// 1 or -1, by the first value that is, but for rounding, the largest.
double sign_of(const Vector& values) {
    const double most = values.size() == 0 ? 0 : values.cwiseAbs().maxCoeff();
    for (const double value : values)
        if (std::abs(value) >= (1 - 1e-6) * most)
            return value < 0 ? -1 : 1;
    return 1;
}

} // namespace

Cochain shown_mode(const Discretization& discretization, const Spectrum& spectrum, Index i) {
    const int n = discretization.dimension();
    const int k = cell_degree(discretization.complex(), spectrum.side, spectrum.degree);
    // stars of k-forms are unit^(n-2k) times as large in the units of the input
    const bool primal =
        spectrum.side == Side::primal || (!discretization.passage().is_identity() && k < n);
    const double half_power = (n - 2 * k) / 2.0;
    const Vector mode = spectrum.modes.col(i);
    return {spectrum.side, spectrum.degree,
            in_input_units(sign_of(mode) * mode, discretization.unit(),
                           primal ? -half_power : half_power, fmt::format("mode {}", i))};
}

VtuGrid draw_modes(const Discretization& discretization, const Spectrum& spectrum) {
    auto grid = draw_cells(discretization,
                           cell_degree(discretization.complex(), spectrum.side, spectrum.degree));
    for (Index i = 0; i < spectrum.modes.cols(); ++i)
        add_form(grid, discretization, fmt::format("mode_{}", i),
                 shown_mode(discretization, spectrum, i));
    return grid;
}

} // namespace polydec
