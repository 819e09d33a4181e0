// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/spectra/spectrum.h"

namespace polydec {

/// Smallest eigenpairs of delta d on coexact primal k-forms, e.g. curl curl on divergence-free
/// fields (k = 1: the modes of a cavity, whose walls are essential). delta d alone has a
/// kernel as large as the rank of d_(k-1); so the certified spectrum of the Laplacian is computed,
/// in which exact and coexact forms stand beside each other, and the coexact ones are taken out.
/// Under natural conditions nothing flows through the boundary: the normal part is 0 there (for k =
/// 0 Neumann's condition); under essential ones the tangential part is 0 (Dirichlet).
/// The certificate is that of the Laplacian: it counts the exact and harmonic forms too.
///
/// The count of the options is that of coexact pairs; found is told of vectors of the Laplacian, of
/// which start goes on.
/// Throws like spectrum, and InvalidInput, before any work, for dual forms, for Robin's condition
/// and if there are fewer coexact forms than asked for; of degree n there are none.
Spectrum coexact_spectrum(const FormSpace& space, const SpectrumOptions& options = {});

} // namespace polydec
