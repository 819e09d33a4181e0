// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/spectrum.h"

namespace polydec {

/// Smallest eigenpairs of delta d on coexact primal k-forms, e.g. curl curl on divergence-free
/// fields (k = 1: the modes of a cavity, on the complex relative to its walls). delta d alone has a
/// kernel as large as the rank of d_(k-1); so the certified spectrum of the Laplacian is computed,
/// in which exact and coexact forms stand beside each other, and the coexact ones are taken out.
/// On the whole complex nothing flows through the boundary: the normal part is 0 there (for k = 0
/// Neumann's condition); on that relative to the boundary the tangential part is 0 (Dirichlet).
/// The certificate is that of the Laplacian: it counts the exact and harmonic forms too.
///
/// Of the options the side must be primal; count is that of coexact pairs; found is told of vectors
/// of the Laplacian, of which start goes on.
/// Throws like spectrum, and InvalidInput, before any work, if there are fewer coexact forms than
/// asked for; of degree n there are none.
Spectrum coexact_spectrum(const Cells& cells, const SpectrumOptions& options);

} // namespace polydec
