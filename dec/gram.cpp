// SPDX-License-Identifier: MIT
#include "dec/gram.h"

#include "base/errors.h"
#include "base/parallel.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace polydec {

namespace {

/// So many rows are one piece of work.
constexpr Index part_size = 1 << 13;

/// Consecutive rows of a matrix; there is room for more entries.
struct Rows {
    std::vector<Index> lengths, columns;
    std::vector<double> values;
};

/// A row that takes terms: columns ascending, terms of equal column added up. Most terms lie on the
/// diagonal or come in ascending runs, so the search begins where the last one went.
class RowSum {
public:
    /// There is room for all terms behind the pointers.
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

Rows product_rows(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                  const Vector& weights, Index begin, Index end) {
    const Index *start = A.outerIndexPtr(), *across = A.innerIndexPtr();
    const Index *first = transposed.outerIndexPtr(), *column = transposed.innerIndexPtr();
    Rows rows;
    rows.lengths.reserve(end - begin);
    std::size_t used = 0;
    for (Index row = begin; row < end; ++row) {
        std::size_t terms = 0;
        for (Index e = start[row]; e < start[row + 1]; ++e)
            terms += first[across[e] + 1] - first[across[e]];
        if (used + terms > rows.columns.size()) {
            rows.columns.resize(2 * rows.columns.size() + terms + part_size);
            rows.values.resize(rows.columns.size());
        }
        RowSum sum(row, &rows.columns[used], &rows.values[used]);
        for (Index e = start[row]; e < start[row + 1]; ++e) {
            const Index c = across[e];
            const double weight = A.valuePtr()[e] * weights[c];
            for (Index f = first[c]; f < first[c + 1]; ++f)
                sum.add(column[f], transposed.valuePtr()[f] * weight);
        }
        rows.lengths.push_back(sum.finish());
        used += rows.lengths.back();
    }
    return rows;
}

/// Where the rows of the product begin.
void add_up_lengths(const std::vector<Rows>& parts, SparseMatrix& product) {
    std::int64_t count = 0;
    Index* end = product.outerIndexPtr();
    for (const Rows& rows : parts)
        for (const Index length : rows.lengths) {
            count += length;
            if (count > std::numeric_limits<Index>::max())
                throw InvalidInput("a Laplacian has more than 2^31 - 1 entries");
            *++end = static_cast<Index>(count);
        }
    product.resizeNonZeros(count);
}

} // namespace

SparseMatrix gram(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                  const Vector& weights) {
    SparseMatrix product(A.rows(), A.rows());
    const auto count = static_cast<Index>(A.rows());
    std::vector<Rows> parts((std::size_t(count) + part_size - 1) / part_size);
    for_each_part(count, part_size, [&](Index begin, Index end) {
        parts[begin / part_size] = product_rows(A, transposed, weights, begin, end);
    });
    add_up_lengths(parts, product);
    for_each_part(count, part_size, [&](Index begin, Index end) {
        const Rows& rows = parts[begin / part_size];
        const Index place = product.outerIndexPtr()[begin];
        const Index entries = product.outerIndexPtr()[end] - place;
        std::copy_n(rows.columns.begin(), entries, product.innerIndexPtr() + place);
        std::copy_n(rows.values.begin(), entries, product.valuePtr() + place);
    });
    return product;
}

} // namespace polydec
