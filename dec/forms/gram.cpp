// SPDX-License-Identifier: MIT
#include "dec/forms/gram.h"

#include "base/errors.h"
#include "base/parallel.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace polydec {

namespace {

/// Number of rows in one piece of work.
constexpr Index part_size = 1 << 13;

/// A row that accumulates terms: ascending columns, terms of equal column added. Most terms are on
/// the diagonal or come in ascending runs, so the search starts at the previous position.
class RowSum {
public:
    /// The arrays must have room for all entries.
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

    /// Number of entries, after the last term.
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
        values_[place] = value + 0.0; // -0 becomes 0
    }

    Index row_;
    Index* columns_;
    double* values_;
    Index size_ = 0, last_ = 0;
    double diagonal_ = 0;
    bool has_diagonal_ = false;
};

/// Writes a row of the product to the arrays; returns the number of its entries.
template <class Rows, class Transposed>
Index sum_row(const Rows& A, const Transposed& transposed, const Vector& weights, Index row,
              Index* columns, double* values) {
    RowSum sum(row, columns, values);
    A.for_each(row, 1, [&](Index c, double sign) {
        transposed.for_each(c, sign * weights[c],
                            [&](Index column, double value) { sum.add(column, value); });
    });
    return sum.finish();
}

/// Allocates rows whose sizes are stored one position later in the row pointers.
void make_room(SparseMatrix& matrix) {
    std::int64_t count = 0;
    for (Index row = 1; row <= matrix.rows(); ++row) {
        count += matrix.outerIndexPtr()[row];
        if (count > std::numeric_limits<Index>::max())
            throw InvalidInput("a Laplacian has more than 2^31 - 1 entries");
        matrix.outerIndexPtr()[row] = static_cast<Index>(count);
    }
    matrix.resizeNonZeros(count);
}

/// Upper bound on the entries of a row: each term off the diagonal counts separately. Exact for the
/// simplices of a complex, which share at most one face or coface.
template <class Rows, class Transposed>
Index bound_row(const Rows& A, const Transposed& transposed, Index row) {
    Index count = A.size(row) > 0 ? 1 : 0;
    A.for_each(row, 1, [&](Index c, double) { count += transposed.size(c) - 1; });
    return count;
}

/// Calls take(column, value) for each column where one of the matrices has an entry in the row.
template <class Take>
void for_each_sum(const SparseMatrix& A, const SparseMatrix& B, Index row, Take take) {
    Index a = A.outerIndexPtr()[row], b = B.outerIndexPtr()[row];
    const Index end_of_a = A.outerIndexPtr()[row + 1], end_of_b = B.outerIndexPtr()[row + 1];
    constexpr Index none = std::numeric_limits<Index>::max();
    while (a < end_of_a || b < end_of_b) {
        const Index in_a = a < end_of_a ? A.innerIndexPtr()[a] : none;
        const Index in_b = b < end_of_b ? B.innerIndexPtr()[b] : none;
        take(std::min(in_a, in_b),
             (in_a <= in_b ? A.valuePtr()[a] : 0) + (in_b <= in_a ? B.valuePtr()[b] : 0));
        a += in_a <= in_b ? 1 : 0;
        b += in_b <= in_a ? 1 : 0;
    }
}

template <class Work>
void for_each_row(const SparseMatrix& matrix, Work work) {
    for_each_part(static_cast<Index>(matrix.rows()), part_size, [&](Index begin, Index end) {
        for (Index row = begin; row < end; ++row)
            work(row);
    });
}

/// A diag(weights) A^T for some ascending rows.
template <class Rows, class Transposed>
SparseMatrix gram(Index size, const Rows& A, const Transposed& transposed, const Vector& weights) {
    SparseMatrix product(size, size);
    if (size == 0)
        return product;
    Index* const rows = product.outerIndexPtr();
    for_each_row(product, [&](Index row) { rows[row + 1] = bound_row(A, transposed, row); });
    make_room(product);
    product.uncompress(); // rows may be shorter
    for_each_row(product, [&](Index row) {
        product.innerNonZeroPtr()[row] =
            sum_row(A, transposed, weights, row, product.innerIndexPtr() + rows[row],
                    product.valuePtr() + rows[row]);
    });
    product.makeCompressed();
    return product;
}

/// A cell with two faces, as an edge from one to the other; another cell has no first end.
struct Edge {
    Index first = -1, last = -1;
    double sign = 1; ///< product of the signs of both ends
};

template <class Rows>
Edge edge_of(const Rows& D, Index e) {
    Edge edge;
    Index ends = 0;
    D.for_each(e, 1, [&](Index face, double sign) {
        (ends++ == 0 ? edge.first : edge.last) = face;
        edge.sign *= sign;
    });
    return ends == 2 ? edge : Edge();
}

/// D^T diag(weights) D in one pass, where room for rows has been made: the row of a vertex consists
/// of the edges that end there, the vertex, and the edges that begin there. Returns whether rows
/// are complete: whether the cells are edges in lexicographic order, as in every simplicial
/// complex, and there is no more room (a relative complex counts edges that it does not have).
template <class Rows>
bool fill_from_edges(const Rows& D, Index edges, const Vector& weights, SparseMatrix& product) {
    const Index* const begins = product.outerIndexPtr();
    Index* const columns = product.innerIndexPtr();
    double* const values = product.valuePtr();
    std::vector<Index> next(begins, begins + product.rows());
    Vector diagonal = Vector::Zero(product.rows());
    Index e = 0;
    for (Index v = 0; v < product.rows(); ++v) {
        if (begins[v] == begins[v + 1])
            continue;
        const Index own = next[v];
        Index place = own + 1;
        double sum = diagonal[v];
        for (Index last = v; e < edges; ++e) {
            const Edge edge = edge_of(D, e);
            if (edge.first != v || edge.last <= last)
                break;
            last = edge.last;
            const Index across = next[last]++;
            columns[place] = last;
            columns[across] = v;
            values[place++] = values[across] = edge.sign * weights[e] + 0.0;
            sum += weights[e];
            diagonal[last] += weights[e];
        }
        columns[own] = v;
        values[own] = sum;
        if (place != begins[v + 1])
            return false;
    }
    return e == edges;
}

SignedRows rows_of(const IncidenceMatrix& A) {
    return {A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr()};
}

} // namespace

SparseMatrix gram_of_rows(const Incidences& D, const Vector& weights) {
    const IncidenceMatrix transposed = D.transposed();
    SparseMatrix product;
    D.visit([&](const auto& rows) {
        gram(D.rows(), rows, rows_of(transposed), weights).swap(product);
    });
    return product;
}

SparseMatrix gram_of_columns(const CellComplex& complex, int k, const Vector& weights) {
    const Incidences& D = complex.incidences(k);
    SparseMatrix product(D.cols(), D.cols());
    D.visit([&](const auto& rows) {
        if (D.size() == 2 * D.rows()) {
            const CofaceCounts& edges = complex.coface_counts(k);
            for (Index v = 0; v < D.cols(); ++v)
                product.outerIndexPtr()[v + 1] = edges[v] + (edges[v] > 0 ? 1 : 0);
            make_room(product);
            if (fill_from_edges(rows, D.rows(), weights, product))
                return;
        }
        const IncidenceMatrix transposed = D.transposed();
        gram(D.cols(), rows_of(transposed), rows, weights).swap(product);
    });
    return product;
}

SparseMatrix sum_of(const SparseMatrix& A, const SparseMatrix& B) {
    SparseMatrix sum(A.rows(), A.cols());
    Index* const rows = sum.outerIndexPtr();
    for_each_row(
        sum, [&](Index row) { for_each_sum(A, B, row, [&](Index, double) { ++rows[row + 1]; }); });
    make_room(sum);
    for_each_row(sum, [&](Index row) {
        Index place = rows[row];
        for_each_sum(A, B, row, [&](Index column, double value) {
            sum.innerIndexPtr()[place] = column;
            sum.valuePtr()[place++] = value;
        });
    });
    return sum;
}

} // namespace polydec
