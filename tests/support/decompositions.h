// SPDX-License-Identifier: MIT
#pragma once

#include "base/decompositions.h"

#include <Eigen/SVD>

/// More of them, compiled once for all tests.
namespace Eigen {

extern template class FullPivLU<polydec::DenseMatrix>;
extern template class CompleteOrthogonalDecomposition<polydec::DenseMatrix>;
extern template class JacobiSVD<polydec::DenseMatrix>;

} // namespace Eigen
