// SPDX-License-Identifier: MIT
#include "io/pictures/draw_modes.h"

#include "io/pictures/draw_cells.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

namespace polydec {

Cochain shown_mode(const Discretization& discretization, const Spectrum& spectrum, Index i) {
    const int n = discretization.dimension();
    const int k = cell_degree(discretization.complex(), spectrum.side, spectrum.degree);
    // stars of k-forms are unit^(n-2k) times as large in the units of the input
    const bool primal =
        spectrum.side == Side::primal || (!discretization.passage().is_identity() && k < n);
    const double half_power = (n - 2 * k) / 2.0;
    return {spectrum.side, spectrum.degree,
            in_input_units(spectrum.modes.col(i), discretization.unit(),
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
