// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"

#include <string>

namespace polydec::builtin {

/// Below this size all eigenpairs of a dense matrix cost less than any iteration.
constexpr Index dense_size = 40;

/// The `count` largest eigenpairs of an operator, as EigenSolver passes it to engines, from all
/// entries of its matrix. Throws SolverFailure in the name of the engine if it fails.
EigenPairs dense_pairs(const SymmetricOperator& A, Index count, const std::string& engine);

} // namespace polydec::builtin
