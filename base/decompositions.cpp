// SPDX-License-Identifier: MIT
#include "base/decompositions.h"

namespace Eigen {

template class PartialPivLU<polydec::DenseMatrix>;
template class HouseholderQR<polydec::DenseMatrix>;
template class ColPivHouseholderQR<polydec::DenseMatrix>;
template class LLT<polydec::DenseMatrix>;
template class SelfAdjointEigenSolver<polydec::DenseMatrix>;
template class GeneralizedSelfAdjointEigenSolver<polydec::DenseMatrix>;

} // namespace Eigen
