// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "io/pictures/vtu.h"
#include "solvers/spectra/spectrum.h"

namespace polydec {

/// Writes the modes of a spectrum on the merged cells they live on, as arrays mode_0, mode_1, ..:
/// point data for forms on vertices, else cell data. Throws like draw_cells and write_vtu.
void write_vtu(const std::filesystem::path& path, const Discretization& discretization,
               const Spectrum& spectrum);

} // namespace polydec
