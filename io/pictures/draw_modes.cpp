// SPDX-License-Identifier: MIT
#include "io/pictures/draw_modes.h"

#include "io/pictures/draw_cells.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

namespace polydec {

VtuGrid draw_modes(const Discretization& discretization, const Spectrum& spectrum) {
    const int k = spectrum.side == Side::primal ? spectrum.degree
                                                : discretization.dimension() - spectrum.degree;
    auto grid = draw_cells(discretization, k);
    // of norm 1 in the units of the input too; stars of k-forms are there unit^(n-2k) times as
    // large
    const bool primal = spectrum.side == Side::primal ||
                        (!discretization.passage().is_identity() && k < discretization.dimension());
    const double half_power = (discretization.dimension() - 2 * k) / 2.0;
    for (Index i = 0; i < spectrum.modes.cols(); ++i) {
        const Vector mode =
            in_input_units(spectrum.modes.col(i), discretization.unit(),
                           primal ? -half_power : half_power, fmt::format("mode {}", i));
        add_form(grid, discretization, fmt::format("mode_{}", i),
                 {spectrum.side, spectrum.degree, mode});
    }
    return grid;
}

} // namespace polydec
