// SPDX-License-Identifier: MIT
#include "complex/relative.h"

#include "base/checks.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

bool marks_none(const CellMarks& marks) {
    return std::all_of(marks.begin(), marks.end(), [](const std::vector<bool>& of_degree) {
        return std::find(of_degree.begin(), of_degree.end(), true) == of_degree.end();
    });
}

/// Checks that the marks fit and, if there are any, calls check(k, s, t) for every k-cell s that is
/// a face of t.
template <class Check>
void check_incidences(const CellComplex& complex, const CellMarks& marks, Check check) {
    check_marks(complex, marks);
    if (marks_none(marks))
        return;
    for (int k = 0; k < complex.dimension(); ++k) {
        for (Index t = 0; t < complex.size(k + 1); ++t)
            for (const SignedFace& s : complex.incidences(k)[t])
                check(k, s.face, t);
        for (const auto& [t, s] : complex.canceled(k))
            check(k, s, t);
    }
}

void check_closed(const CellComplex& complex, const CellMarks& dropped) {
    check_incidences(complex, dropped, [&](int k, Index s, Index t) {
        if (dropped[k + 1][t] && !dropped[k][s])
            throw InvalidInput(fmt::format("{}-cell {} is dropped but its face, {}-cell {}, is "
                                           "not: drop both or neither",
                                           k + 1, t, k, s),
                               {.degree = k + 1, .cells = {t}});
    });
}

void check_open(const CellComplex& complex, const CellMarks& dropped) {
    check_incidences(complex, dropped, [&](int k, Index s, Index t) {
        if (dropped[k][s] && !dropped[k + 1][t])
            throw InvalidInput(fmt::format("{}-cell {} of an open set is dropped but its coface, "
                                           "{}-cell {}, is not: drop both or neither",
                                           k, s, k + 1, t),
                               {.degree = k, .cells = {s}});
    });
}

/// d_k between the kept cells, whose numbers are `cells`; number[s] is the new one of k-cell s.
IncidenceMatrix kept_part(const Incidences& d, const std::vector<Index>& rows,
                          const std::vector<Index>& number, Index columns) {
    IncidenceMatrix part(static_cast<Index>(rows.size()), columns);
    part.reserve(d.size());
    for (std::size_t t = 0; t < rows.size(); ++t) {
        part.startVec(static_cast<Index>(t));
        for (const auto& [s, sign] : d[rows[t]])
            if (number[s] >= 0)
                part.insertBack(static_cast<Index>(t), number[s]) = static_cast<std::int8_t>(sign);
    }
    part.finalize();
    return part;
}

} // namespace

DenseMatrix RelativeComplex::restrict_columns(int k, const DenseMatrix& whole) const {
    check_number("values on cells of degree", k, 0, complex.dimension());
    check_as_many(fmt::format("values on {}-cells of the whole complex", k), whole.rows(),
                  whole_sizes[k]);
    return whole(cells[k], Eigen::indexing::all);
}

DenseMatrix RelativeComplex::extend_columns(int k, const DenseMatrix& kept) const {
    check_number("values on cells of degree", k, 0, complex.dimension());
    check_as_many(fmt::format("values on kept {}-cells", k), kept.rows(), complex.size(k));
    DenseMatrix whole = DenseMatrix::Zero(whole_sizes[k], kept.cols());
    whole(cells[k], Eigen::indexing::all) = kept;
    return whole;
}

SparseMatrix inclusion(const std::vector<Index>& cells, Index size) {
    SparseMatrix result(size, static_cast<Index>(cells.size()));
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (std::size_t i = 0; i < cells.size(); ++i)
        entries.emplace_back(cells[i], static_cast<Index>(i), 1.0);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

SparseMatrix RelativeComplex::block(int k, const SparseMatrix& of_whole) const {
    const SparseMatrix kept = inclusion(cells[k], whole_sizes[k]);
    return SparseMatrix(kept.transpose()) * of_whole * kept;
}

RelativeComplex relative_complex(const CellComplex& complex, const CellMarks& closed,
                                 const CellMarks& open) {
    if (open.empty())
        return relative_complex(complex, closed, no_marks(complex));
    check_closed(complex, closed);
    check_open(complex, open);
    const int n = complex.dimension();
    std::vector<std::vector<Index>> cells(n + 1), numbers(n + 1);
    std::vector<Index> sizes;
    for (int k = 0; k <= n; ++k) {
        sizes.push_back(complex.size(k));
        cells[k].reserve(static_cast<std::size_t>(complex.size(k)));
        for (Index s = 0; s < complex.size(k); ++s)
            if (!closed[k][s] && !open[k][s])
                cells[k].push_back(s);
    }
    if (marks_none(closed) && marks_none(open)) // the whole, which shares its memory
        return {complex, std::move(cells), std::move(sizes)};
    for (int k = 0; k <= n; ++k) {
        numbers[k].assign(complex.size(k), -1);
        for (std::size_t i = 0; i < cells[k].size(); ++i)
            numbers[k][cells[k][i]] = static_cast<Index>(i);
    }
    std::vector<Coboundary> coboundaries;
    for (int k = 0; k < n; ++k) {
        std::vector<Index> counts;
        for (const Index s : cells[k])
            counts.push_back(complex.coface_counts(k)[s]);
        std::vector<Incidence> canceled;
        for (const auto& [t, s] : complex.canceled(k))
            if (numbers[k + 1][t] >= 0 && numbers[k][s] >= 0)
                canceled.push_back({numbers[k + 1][t], numbers[k][s]});
        coboundaries.push_back(
            {Incidences(kept_part(complex.incidences(k), cells[k + 1], numbers[k],
                                  static_cast<Index>(cells[k].size()))),
             counts, std::move(canceled)});
    }
    return {CellComplex(CellComplex::Unchecked{}, std::move(coboundaries)), std::move(cells),
            std::move(sizes)};
}

RelativeComplex relative_to_boundary(const CellComplex& complex) {
    return relative_complex(complex, boundary_cells(complex));
}

} // namespace polydec
