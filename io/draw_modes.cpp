// SPDX-License-Identifier: MIT
#include "io/draw_modes.h"

#include "io/draw_cells.h"

#include <fmt/format.h>

namespace polydec {

void write_vtu(const std::filesystem::path& path, const Discretization& discretization,
               const Spectrum& spectrum) {
    const int k = spectrum.side == Side::primal ? spectrum.degree
                                                : discretization.dimension() - spectrum.degree;
    auto grid = draw_cells(discretization.merging, discretization.points, k);
    for (Index i = 0; i < spectrum.modes.cols(); ++i)
        add_cochain(grid, discretization.merging, k, fmt::format("mode_{}", i),
                    spectrum.modes.col(i));
    write_vtu(path, grid);
}

} // namespace polydec
