// SPDX-License-Identifier: MIT
#include "io/draw_modes.h"

#include "io/draw_cells.h"

#include <fmt/format.h>

namespace polydec {

void write_vtu(const std::filesystem::path& path, const Discretization& discretization,
               const Spectrum& spectrum) {
    const int k = spectrum.side == Side::primal ? spectrum.degree
                                                : discretization.dimension() - spectrum.degree;
    auto grid = draw_cells(discretization, k);
    for (Index i = 0; i < spectrum.modes.cols(); ++i)
        add_form(grid, discretization, fmt::format("mode_{}", i),
                 {spectrum.side, spectrum.degree, spectrum.modes.col(i)});
    write_vtu(path, grid);
}

} // namespace polydec
