// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"

#include <utility>

namespace polydec {

/// The largest eigenvalue of A >= 0 and its vector. Often many oscillations of the smallest cells
/// have nearly this frequency, more on finer meshes, and Lanczos alone would take longer on each.
std::pair<double, Vector> largest_pair(const SymmetricOperator& A);

} // namespace polydec
