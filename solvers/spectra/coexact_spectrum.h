// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/spectra/spectrum.h"

namespace polydec {

/// Smallest eigenpairs of delta d on coexact primal k-forms, e.g. curl curl on divergence-free
/// fields (k = 1: the modes of a cavity with essential walls). The kernel of delta d alone is as
/// large as the rank of d_(k-1). So the solver computes the certified spectrum of the Laplacian,
/// with exact and coexact forms, and selects the coexact ones. Under natural conditions nothing
/// flows through the boundary: the normal part is 0 there (for k = 0 the Neumann condition). Under
/// essential conditions the tangential part is 0 (Dirichlet). The certificate is for the Laplacian:
/// it also counts exact and harmonic forms.
///
/// The option `count` counts coexact pairs; `found` receives vectors of the Laplacian, from which
/// `start` resumes. Throws like spectrum, and InvalidInput, before any work, for dual forms, a
/// Robin condition, or too few coexact forms; degree n has none.
Spectrum coexact_spectrum(const FormSpace& space, const SpectrumOptions& options = {});

} // namespace polydec
