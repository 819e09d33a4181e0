// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

/// Eigen's decompositions of dense matrices, compiled once: each file that uses one would take
/// seconds more to compile.
namespace Eigen {

extern template class PartialPivLU<polydec::DenseMatrix>;
extern template class HouseholderQR<polydec::DenseMatrix>;
extern template class ColPivHouseholderQR<polydec::DenseMatrix>;
extern template class LLT<polydec::DenseMatrix>;
extern template class SelfAdjointEigenSolver<polydec::DenseMatrix>;
extern template class GeneralizedSelfAdjointEigenSolver<polydec::DenseMatrix>;

} // namespace Eigen
