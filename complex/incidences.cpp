// SPDX-License-Identifier: MIT
#include "complex/incidences.h"

#include <numeric>
#include <utility>

namespace polydec {

Incidences::Incidences(IncidenceMatrix&& matrix)
    : rows_(static_cast<Index>(matrix.rows())),
      cols_(static_cast<Index>(matrix.cols())),
      matrix_(std::make_shared<Lazy<IncidenceMatrix>>()) {
    const IncidenceMatrix& own = matrix_->get([&] {
        IncidenceMatrix result;
        result.swap(matrix); // Eigen would copy it where one moves it
        result.makeCompressed();
        return result;
    });
    faces_ = own.innerIndexPtr();
    begins_ = own.outerIndexPtr();
    signs_ = own.valuePtr();
}

Incidences::Incidences(std::shared_ptr<const Simplices> faces, Index cols,
                       std::shared_ptr<const Signs> signs)
    : rows_(static_cast<Index>(faces->rows())),
      cols_(cols),
      width_(static_cast<Index>(faces->cols())),
      faces_(faces->data()),
      signs_(signs ? signs->data() : nullptr),
      table_(std::move(faces)),
      turns_(std::move(signs)),
      matrix_(std::make_shared<Lazy<IncidenceMatrix>>()) {}

Incidences Incidences::with_signs(std::shared_ptr<const Signs> signs) const {
    return {table_, cols_, std::move(signs)};
}

int Incidences::sign(Index cell, Index face) const {
    for (const auto& [own, sign] : (*this)[cell])
        if (own == face)
            return sign;
    return 0;
}

template <class Scalar>
Eigen::SparseMatrix<Scalar, Eigen::RowMajor, Index> Incidences::make() const {
    Eigen::SparseMatrix<Scalar, Eigen::RowMajor, Index> result(rows_, cols_);
    result.resizeNonZeros(size());
    Index place = 0;
    for (Index cell = 0; cell < rows_; ++cell) {
        for (const auto& [face, sign] : (*this)[cell]) {
            result.innerIndexPtr()[place] = face;
            result.valuePtr()[place++] = static_cast<Scalar>(sign);
        }
        result.outerIndexPtr()[cell + 1] = place;
    }
    return result;
}

const IncidenceMatrix& Incidences::matrix() const& {
    return matrix_->get([this] { return make<std::int8_t>(); });
}

SparseMatrix Incidences::real_matrix() const {
    return make<double>();
}

IncidenceMatrix Incidences::transposed() const {
    IncidenceMatrix result(cols_, rows_);
    result.resizeNonZeros(size());
    // each row's place stands one ahead, and moves to where the next begins
    Index* const places = result.outerIndexPtr();
    for (Index e = 0; e < size(); ++e)
        if (faces_[e] + 2 <= cols_)
            ++places[faces_[e] + 2];
    std::partial_sum(places, places + cols_ + 1, places);
    for (Index cell = 0; cell < rows_; ++cell)
        for (const auto& [face, sign] : (*this)[cell]) {
            const Index place = places[face + 1]++;
            result.innerIndexPtr()[place] = cell;
            result.valuePtr()[place] = static_cast<std::int8_t>(sign);
        }
    return result;
}

} // namespace polydec
