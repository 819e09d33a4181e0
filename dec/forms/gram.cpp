// SPDX-License-Identifier: MIT
#include "dec/forms/gram.h"

#include "base/errors.h"
#include "base/parallel.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace polydec {

namespace {

/// So many rows are one piece of work.
constexpr Index part_size = 1 << 13;

/// A row that takes terms: columns ascending, terms of equal column added up. Most terms lie on the
/// diagonal or come in ascending runs, so the search begins where the last one went.
class RowSum {
public:
    /// There is room for all entries behind the pointers.
    RowSum(Index row, Index* columns, double* values)
        : row_(row), columns_(columns), values_(values) {}

    void add(Index column, double value) {
        if (column == row_) {
            diagonal_ += value;
            has_diagonal_ = true;
        } else if (size_ == 0 || columns_[size_ - 1] < column) {
            last_ = size_;
            put(size_, column, value);
        } else {
            add_between(column, value);
        }
    }

    /// Number of entries, when all terms have come.
    Index finish() {
        if (has_diagonal_)
            put(static_cast<Index>(std::lower_bound(columns_, columns_ + size_, row_) - columns_),
                row_, diagonal_);
        return size_;
    }

private:
    void add_between(Index column, double value) {
        while (last_ < size_ && columns_[last_] < column)
            ++last_;
        while (last_ > 0 && columns_[last_ - 1] >= column)
            --last_;
        if (columns_[last_] == column)
            values_[last_] += value;
        else
            put(last_, column, value);
    }

    void put(Index place, Index column, double value) {
        for (Index i = size_++; i > place; --i) {
            columns_[i] = columns_[i - 1];
            values_[i] = values_[i - 1];
        }
        columns_[place] = column;
        values_[place] = value;
    }

    Index row_;
    Index* columns_;
    double* values_;
    Index size_ = 0, last_ = 0;
    double diagonal_ = 0;
    bool has_diagonal_ = false;
};

/// Writes a row of the product behind the pointers; the number of its entries.
Index sum_row(const IncidenceMatrix& A, const IncidenceMatrix& transposed, const Vector& weights,
              Index row, Index* columns, double* values) {
    const Index *begin = A.outerIndexPtr(), *across = A.innerIndexPtr();
    const Index *first = transposed.outerIndexPtr(), *column = transposed.innerIndexPtr();
    RowSum sum(row, columns, values);
    for (Index e = begin[row]; e < begin[row + 1]; ++e) {
        const Index c = across[e];
        const double weight = A.valuePtr()[e] * weights[c];
        for (Index f = first[c]; f < first[c + 1]; ++f)
            sum.add(column[f], transposed.valuePtr()[f] * weight);
    }
    return sum.finish();
}

/// Where the rows of the product begin: each is summed once for its length alone.
void find_rows(const IncidenceMatrix& A, const IncidenceMatrix& transposed, const Vector& weights,
               SparseMatrix& product) {
    const Index *begin = A.outerIndexPtr(), *first = transposed.outerIndexPtr();
    Index* const rows = product.outerIndexPtr();
    for_each_part(static_cast<Index>(A.rows()), part_size, [&](Index from, Index to) {
        std::vector<Index> columns;
        std::vector<double> values;
        for (Index row = from; row < to; ++row) {
            std::size_t terms = 0;
            for (Index e = begin[row]; e < begin[row + 1]; ++e)
                terms += first[A.innerIndexPtr()[e] + 1] - first[A.innerIndexPtr()[e]];
            if (terms > columns.size()) {
                columns.resize(2 * terms);
                values.resize(2 * terms);
            }
            rows[row + 1] = sum_row(A, transposed, weights, row, columns.data(), values.data());
        }
    });
    std::int64_t count = 0;
    for (Index row = 1; row <= product.rows(); ++row) {
        count += rows[row];
        if (count > std::numeric_limits<Index>::max())
            throw InvalidInput("a Laplacian has more than 2^31 - 1 entries");
        rows[row] = static_cast<Index>(count);
    }
    product.resizeNonZeros(count);
}

} // namespace

SparseMatrix gram(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                  const Vector& weights) {
    SparseMatrix product(A.rows(), A.rows());
    find_rows(A, transposed, weights, product);
    for_each_part(static_cast<Index>(A.rows()), part_size, [&](Index begin, Index end) {
        for (Index row = begin; row < end; ++row) {
            const Index place = product.outerIndexPtr()[row];
            sum_row(A, transposed, weights, row, product.innerIndexPtr() + place,
                    product.valuePtr() + place);
        }
    });
    return product;
}

} // namespace polydec
