// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/vtu.h"
#include "solvers/spectra/spectrum.h"

namespace polydec {

/// A mode of a spectrum as a form of norm 1 in the units of the input. Its arbitrary sign makes the
/// largest value positive; of several, the first one.
Cochain shown_mode(const Discretization& discretization, const Spectrum& spectrum, Index i);

/// Adds the certificate of a spectrum to the field data: eigenvalues, their radii and residuals,
/// the certificate by shift, below_shift, returned_below_shift and complete (1 or 0), and degree
/// and is_dual (1 or 0) of the forms.
void add_spectrum(VtuGrid& grid, const Spectrum& spectrum);

/// The modes of a spectrum on their merged cells, as arrays mode_0, mode_1, ..: point data for
/// forms on vertices, else cell data; with add_vectors and add_spectrum. Throws like draw_cells.
VtuGrid draw_modes(const Discretization& discretization, const Spectrum& spectrum);

} // namespace polydec
