// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"
#include "solvers/spectra/spectrum.h"

namespace polydec {

/// Collective: see the function of one process; by circumcentric stars (see check_stars), under the
/// conditions that hold where nothing is done about the boundary. The modes have the values of own
/// cells. The iteration is SLEPc's, factors are MUMPS' (options.linear_solver and eigen_solver do
/// not matter). Throws InvalidInput, naming the cells, also for stars that are not positive;
/// BackendUnavailable without SLEPc or MUMPS.
Spectrum spectrum(const Ranks& ranks, const DistributedMesh& mesh, Side side, int degree,
                  const SpectrumOptions& options = {});

} // namespace polydec
