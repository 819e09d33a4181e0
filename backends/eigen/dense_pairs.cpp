// SPDX-License-Identifier: MIT
#include "backends/eigen/dense_pairs.h"

#include "backends/blas.h"

#include <algorithm>

namespace polydec::builtin {

namespace {

constexpr Index panel_width = 32;

} // namespace

EigenPairs dense_pairs(const SymmetricOperator& A, Index count, const std::string& engine) {
    DenseMatrix entries(A.size, A.size);
    DenseMatrix units, images;
    for (Index first = 0; first < A.size; first += panel_width) {
        const Index width = std::min(panel_width, A.size - first);
        units = DenseMatrix::Zero(A.size, width);
        units.middleRows(first, width).setIdentity();
        A.apply_to_columns(units, images);
        entries.middleCols(first, width) = images;
    }
    const auto [values, vectors] =
        symmetric_pairs(DenseMatrix(0.5 * (entries + entries.transpose())), engine);
    return {values.reverse().head(count), vectors.rowwise().reverse().leftCols(count), count,
            A.size};
}

} // namespace polydec::builtin
