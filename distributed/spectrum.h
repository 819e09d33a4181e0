// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"
#include "solvers/spectra/spectrum.h"

namespace polydec {

/// Collective: spectrum as in one process, with circumcentric stars (see check_stars) and default
/// boundary conditions. The modes have the values of own cells. SLEPc iterates, MUMPS factorizes;
/// options.linear_solver and eigen_solver are ignored. Throws InvalidInput, naming the cells, also
/// for stars that are not positive; BackendUnavailable without SLEPc or MUMPS.
Spectrum spectrum(const Ranks& ranks, const DistributedMesh& mesh, Side side, int degree,
                  const SpectrumOptions& options = {});

} // namespace polydec
