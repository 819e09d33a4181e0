// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "io/pictures/vtu.h"
#include "solvers/spectra/spectrum.h"

namespace polydec {

/// The modes of a spectrum on the merged cells they live on, as arrays mode_0, mode_1, ..: point
/// data for forms on vertices, else cell data. Throws like draw_cells.
VtuGrid draw_modes(const Discretization& discretization, const Spectrum& spectrum);

} // namespace polydec
