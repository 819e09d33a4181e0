// SPDX-License-Identifier: MIT
#include "shape/form_family.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon() / 2;

/// Errors of local matrices, as a share of their diagonal, by rounding them to doubles and adding
/// parts up.
constexpr double local_rounding = 16 * unit;

} // namespace

FormFamily::FormFamily(const Shape& shape, Unknowns unknowns, Factors factors,
                       const std::function<LocalForms(Index)>& local)
    : domain_dimension_(shape.pieces.dimension()),
      unknowns_(std::move(unknowns)),
      factors_(std::move(factors)),
      reach_(shape.pieces.size(domain_dimension_)),
      errors_(reach_.size()),
      width_(static_cast<Index>(std::ssize(unknowns_.of_simplices)) /
             std::max<Index>(simplices(), 1)),
      robin_(reach_.size()),
      limit_(std::numeric_limits<double>::infinity()) {
    parts_ = static_cast<Index>(factors_(0, 0).size());
    const std::size_t entries = std::size_t(width_) * width_;
    values_.resize(entries * parts_ * simplices());
    std::vector<Cell> cells(simplices());
    for_each_part(simplices(), 64, [&](Index begin, Index end) {
        for (Index s = begin; s < end; ++s) {
            const LocalForms forms = local(s);
            double* values = values_.data() + entries * parts_ * s;
            for (const LongMatrix& part : forms.parts) {
                Eigen::Map<DenseMatrix>(values, width_, width_) = part.cast<double>();
                values += entries;
            }
            reach_[s] = forms.reach;
            errors_[s] = local_rounding + forms.error;
            cells[s].mass = forms.mass;
            if (forms.cell.size() > 0)
                cells[s].column = Vector(forms.cell.col(0).cast<double>());
            robin_[s] = forms.robin.cast<double>();
        }
    });
    if (!cells.empty() && cells[0].column.size() > 0)
        cells_ = std::move(cells);
    for (const double reach : reach_)
        limit_ = std::min(limit_, 1 / reach);
    make_pattern();
}

std::vector<Index> FormFamily::beyond(double s) const {
    std::vector<Index> simplices;
    for (std::size_t i = 0; i < reach_.size(); ++i)
        if (!(s * reach_[i] < 1))
            simplices.push_back(static_cast<Index>(i));
    return simplices;
}

void FormFamily::make_pattern() {
    std::vector<Eigen::Triplet<double, Index>> places;
    summands_ = Vector::Zero(size());
    for (Index s = 0; s < simplices(); ++s)
        for (Index i = 0; i < width_; ++i) {
            const Index row = unknown(s, i);
            if (row < 0)
                continue;
            most_summands_ = std::max(most_summands_, ++summands_[row]);
            for (Index j = 0; j < width_; ++j)
                if (const Index column = unknown(s, j); column >= 0)
                    places.emplace_back(row, column, 0);
        }
    pattern_ = SparseMatrix(size(), size());
    pattern_.setFromTriplets(places.begin(), places.end());
    slots_.assign(std::size_t(width_) * width_ * simplices(), -1);
    const Index* columns = pattern_.innerIndexPtr();
    const Index* begins = pattern_.outerIndexPtr();
    std::size_t slot = 0;
    for (Index s = 0; s < simplices(); ++s)
        for (Index i = 0; i < width_; ++i)
            for (Index j = 0; j < width_; ++j, ++slot) {
                const Index row = unknown(s, i), column = unknown(s, j);
                if (row >= 0 && column >= 0)
                    slots_[slot] = static_cast<Index>(
                        std::lower_bound(columns + begins[row], columns + begins[row + 1], column) -
                        columns);
            }
}

/// Q of one simplex, bounds of what is added up on its diagonal, and the error as a share of these.
/// Returns in sizes[width] whether the cell's own entry is negative.
void FormFamily::add_local(const Factors& factors_at, Index simplex, double s, DenseMatrix& Q,
                           Vector& sizes, double& error) const {
    const auto factors = factors_at(s, s * reach_[simplex]);
    Q.setZero(width_, width_);
    sizes.setZero(width_ + 1);
    for (Index p = 0; p < parts_; ++p) {
        Q += factors[p] * part(simplex, p);
        sizes.head(width_) += std::abs(factors[p]) * part(simplex, p).diagonal().cwiseAbs();
    }
    error = errors_[simplex];
    if (!cells_.empty()) {
        const Cell& cell = cells_[simplex];
        const Vector coupling = Q * cell.column;
        const double stiffness = cell.column.dot(coupling);
        const double pivot = stiffness - s * cell.mass;
        Q -= coupling * coupling.transpose() / pivot;
        sizes.head(width_) += coupling.cwiseAbs2() / std::abs(pivot);
        sizes[width_] = pivot < 0 ? 1 : 0;
        error *= std::max(1.0, (stiffness + s * cell.mass) / std::abs(pivot));
    }
    if (const DenseMatrix& robin = robin_[simplex]; robin.size() > 0) {
        Q += robin;
        sizes.head(width_) += robin.diagonal();
    }
}

CountedMatrix FormFamily::sum(const Factors& factors, double s) const {
    auto matrix = std::make_shared<SparseMatrix>(pattern_);
    double* entries = matrix->valuePtr();
    std::fill(entries, entries + matrix->nonZeros(), 0.0);
    CountedMatrix result;
    result.doubt.sizes = Vector::Zero(size());
    DenseMatrix local_forms(width_ * width_, simplices()), local_sizes(width_ + 1, simplices());
    Vector errors(simplices());
    for_each_part(simplices(), 64, [&](Index begin, Index end) {
        DenseMatrix Q;
        Vector sizes;
        for (Index t = begin; t < end; ++t) {
            add_local(factors, t, s, Q, sizes, errors[t]);
            local_forms.col(t) = Q.reshaped();
            local_sizes.col(t) = sizes;
        }
    });
    std::size_t slot = 0;
    for (Index t = 0; t < simplices(); ++t) {
        result.eliminated += static_cast<Index>(local_sizes(width_, t));
        const double* Q = local_forms.col(t).data();
        for (Index i = 0; i < width_; ++i)
            for (Index j = 0; j < width_; ++j, ++slot)
                if (slots_[slot] >= 0) // both triangles alike
                    entries[slots_[slot]] +=
                        sign(t, i) * sign(t, j) * Q[std::min(i, j) + width_ * std::max(i, j)];
        for (Index i = 0; i < width_; ++i)
            if (unknown(t, i) >= 0)
                result.doubt.sizes[unknown(t, i)] += local_sizes(i, t);
    }

    // row sums of errors / sqrt(sizes_i sizes_j)
    Vector sums = Vector::Zero(size());
    for (Index t = 0; t < simplices(); ++t) {
        double sum = 0;
        const auto share = [&](Index i) {
            const Index row = unknown(t, i);
            return row < 0 || !(result.doubt.sizes[row] > 0)
                       ? 0.0
                       : std::sqrt(local_sizes(i, t) / result.doubt.sizes[row]);
        };
        for (Index i = 0; i < width_; ++i)
            sum += share(i);
        for (Index i = 0; i < width_; ++i)
            if (unknown(t, i) >= 0)
                sums[unknown(t, i)] += (errors[t] + most_summands_ * unit) * share(i) * sum;
    }
    result.doubt.share = size() > 0 ? sums.maxCoeff() : 0;
    result.matrix = std::move(matrix);
    return result;
}

Vector FormFamily::doubt(Index simplex, double t) const {
    DenseMatrix Q;
    Vector sizes;
    double error = 0;
    add_local(factors_, simplex, t, Q, sizes, error);
    return width_ * (error + most_summands_ * unit) * sizes.head(width_);
}

void FormFamily::drop(Index simplex, double s, double t, const Vector& doubt, DenseMatrix& form,
                      double& mass) const {
    const auto at_s = factors_(s, s * reach_[simplex]), at_t = factors_(t, t * reach_[simplex]);
    const double error = width_ * errors_[simplex];
    form.setZero(width_, width_);
    for (Index p = 0; p < parts_; ++p) {
        form += (at_s[p] - at_t[p]) * part(simplex, p);
        form.diagonal() -=
            error * (std::abs(at_s[p]) + std::abs(at_t[p])) * part(simplex, p).diagonal();
    }
    mass = 0;
    if (cells_.empty()) {
        form.diagonal() -= doubt;
        return;
    }
    const Cell& cell = cells_[simplex]; // |m|^2 <= 2 |y|^2 + 2 |u cell|^2
    form.diagonal() -= 2 * doubt;
    mass = (t - s) * (1 - error) * cell.mass - 2 * doubt.dot(cell.column.cwiseAbs2());
}

const Vector& FormFamily::cell(Index simplex) const {
    static const Vector none;
    return cells_.empty() ? none : cells_[simplex].column;
}

void FormFamily::restrict_to(Index simplex, const DenseMatrix& X, DenseMatrix& Y) const {
    Y.setZero(width_, X.cols());
    for (Index i = 0; i < width_; ++i)
        if (const Index row = unknown(simplex, i); row >= 0)
            Y.row(i) = sign(simplex, i) * X.row(row);
}

void FormFamily::add_to(DenseMatrix& X, Index simplex, const DenseMatrix& Y) const {
    for (Index i = 0; i < width_; ++i)
        if (const Index row = unknown(simplex, i); row >= 0)
            X.row(row) += sign(simplex, i) * Y.row(i);
}

/// Parts with these factors, without Robin's.
DenseMatrix FormFamily::combined(const Factors& factors, Index simplex, double s) const {
    const auto each = factors(s, s * reach_[simplex]);
    DenseMatrix Q = DenseMatrix::Zero(width_, width_);
    for (Index p = 0; p < parts_; ++p)
        Q += each[p] * part(simplex, p);
    return Q;
}

FormFamily::Elimination FormFamily::elimination(Index simplex, double s) const {
    const Cell& cell = cells_[simplex];
    const Vector coupling = combined(factors_, simplex, s) * cell.column;
    const double pivot = cell.column.dot(coupling) - s * cell.mass;
    return {coupling / pivot, pivot};
}

Vector FormFamily::local_values(const Factors& factors, double s, const DenseMatrix& X) const {
    Vector result(simplices());
    DenseMatrix Y;
    for (Index t = 0; t < simplices(); ++t) {
        restrict_to(t, X, Y);
        if (!cells_.empty())
            Y -= DenseMatrix(cells_[t].column * (elimination(t, s).weights.transpose() * Y));
        result[t] = (Y.transpose() * combined(factors, t, s) * Y).trace();
    }
    return result;
}

} // namespace polydec
