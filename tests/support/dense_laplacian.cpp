// SPDX-License-Identifier: MIT
#include "tests/support/dense_laplacian.h"

namespace polydec::test {

template DenseOf<double> dense_laplacian<double>(const CellComplex&, const HodgeStars&, int);
template DenseOf<long double> dense_laplacian<long double>(const CellComplex&, const HodgeStars&,
                                                           int);
template Eigen::Matrix<double, Eigen::Dynamic, 1> dense_eigenvalues<double>(const CellComplex&,
                                                                            const HodgeStars&, int);
template Eigen::Matrix<long double, Eigen::Dynamic, 1>
dense_eigenvalues<long double>(const CellComplex&, const HodgeStars&, int);

} // namespace polydec::test
