// SPDX-License-Identifier: MIT
#include "tests/support/decompositions.h"

namespace Eigen {

template class FullPivLU<polydec::DenseMatrix>;
template class CompleteOrthogonalDecomposition<polydec::DenseMatrix>;
template class JacobiSVD<polydec::DenseMatrix>;

} // namespace Eigen
