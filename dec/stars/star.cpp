// SPDX-License-Identifier: MIT
#include "dec/stars/star.h"

#include "backends/registry.h"
#include "base/block_matrix.h"
#include "base/checks.h"
#include "complex/surfaces/glued_surface.h"
#include "dec/metric/rounding.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <span>
#include <utility>

namespace polydec {

struct HodgeStar::Matrix {
    std::shared_ptr<const SparseMatrix> entries;
    std::mutex solving; // an engine serves one thread at a time
    std::unique_ptr<LinearSolver> solver = nullptr;
};

namespace {

/// Checks that entries are finite and the matrix is symmetric up to rounding.
void check_symmetric(const SparseMatrix& matrix, int k, Index size) {
    check_as_many(fmt::format("rows of the star of {}-cells", k), matrix.rows(), size);
    check_as_many(fmt::format("columns of the star of {}-cells", k), matrix.cols(), size);
    constexpr double rounding = 1e-12;
    const SparseMatrix skew = matrix - SparseMatrix(matrix.transpose());
    for (Index row = 0; row < size; ++row)
        for (SparseMatrix::InnerIterator entry(skew, row); entry; ++entry) {
            const double largest = std::sqrt(matrix.coeff(row, row)) *
                                   std::sqrt(matrix.coeff(entry.col(), entry.col()));
            if (!(std::abs(entry.value()) <= rounding * largest))
                throw InvalidInput(
                    fmt::format("the star of {}-cells is given by a matrix whose entries at row "
                                "{}, column {} are {} and, across the diagonal, {}: expected a "
                                "symmetric positive definite one",
                                k, row, entry.col(), matrix.coeff(row, entry.col()),
                                matrix.coeff(entry.col(), row)),
                    {.degree = k, .cells = {row, static_cast<Index>(entry.col())}});
        }
}

std::string first_of(const std::vector<Index>& cells) {
    constexpr std::size_t most = 5;
    const std::span first = std::span(cells).first(std::min(cells.size(), most));
    return fmt::format("{}{}", fmt::join(first, ", "), cells.size() > most ? ", .." : "");
}

} // namespace

void refuse_inverse(int k, std::vector<Index> cells) {
    const std::string text = fmt::format("the inverse star of degree {} divides by zero: the duals "
                                         "of {} {}-cells have no volume (cells {})",
                                         k, cells.size(), k, first_of(cells));
    throw InvalidInput(text, {.degree = k, .cells = std::move(cells)});
}

HodgeStar::HodgeStar(const CellVolumes& volumes, int k) : volumes_(volumes), degree_(k) {
    volumes_.size(k); // throws for an invalid degree
}

HodgeStar::HodgeStar(const CellVolumes& volumes, int k, SparseMatrix matrix)
    : HodgeStar(volumes, k) {
    check_symmetric(matrix, k, size());
    matrix_ = std::make_shared<Matrix>();
    matrix_->entries = std::make_shared<const SparseMatrix>(
        0.5 * (matrix + SparseMatrix(matrix.transpose()))); // removes rounding across the diagonal
}

HodgeStar HodgeStar::in_input_units(double unit) const {
    HodgeStar result = *this;
    result.unit_ *= unit;
    return result;
}

std::string HodgeStar::name() const {
    return fmt::format("the star of degree {}", degree_);
}

/// Of the star, of power 1, or its inverse, of power -1.
Vector HodgeStar::entries(Vector measured, int power) const {
    if (unit_ == 1)
        return measured;
    return polydec::in_input_units(measured, unit_, power * (dimension() - 2 * degree_), name());
}

/// What the star, or its inverse, makes of a form.
Vector HodgeStar::form(Vector measured, int power) const {
    if (unit_ == 1)
        return measured;
    return form_in_input_units(measured, unit_, power * (dimension() - 2 * degree_), name());
}

void HodgeStar::check(const Vector& values) const {
    check_as_many(fmt::format("values of {}-cells", degree_), values.size(), size());
}

void HodgeStar::require_diagonal() const {
    if (!is_diagonal())
        throw InvalidInput(fmt::format("the star of {}-cells is a matrix: expected a diagonal "
                                       "star; use circumcentric stars",
                                       degree_),
                           {.degree = degree_});
}

Vector HodgeStar::diagonal() const {
    require_diagonal();
    return entries(volumes_.ratios(degree_), 1);
}

SparseMatrix HodgeStar::matrix() const {
    if (is_diagonal())
        return diagonal_matrix(diagonal());
    return polydec::in_input_units(*matrix_->entries, unit_, dimension() - 2 * degree_, name());
}

Vector HodgeStar::operator*(const Vector& values) const {
    check(values);
    return form(is_diagonal() ? Vector(volumes_.ratios(degree_).cwiseProduct(values))
                              : *matrix_->entries * values,
                1);
}

Vector HodgeStar::solve(const Vector& values) const {
    check(values);
    if (is_diagonal())
        return form(measured_inverse().cwiseProduct(values), -1);
    const std::lock_guard lock(matrix_->solving);
    if (!matrix_->solver) {
        auto solver = make_linear_solver("auto");
        solver->factorize(matrix_->entries, {.symmetry = Symmetry::symmetric,
                                             .inertia = Inertia::wanted,
                                             .domain_dimension = dimension(),
                                             .many_solves = true});
        if (const auto negative = solver->negative_pivots(); negative.value_or(0) > 0)
            throw InvalidInput(fmt::format("the star of {}-cells is given by a matrix with {} "
                                           "negative eigenvalues: expected a positive definite one",
                                           degree_, *negative),
                               {.degree = degree_});
        matrix_->solver = std::move(solver);
    }
    return form(matrix_->solver->solve(values), -1);
}

Vector HodgeStar::measured_inverse() const {
    require_diagonal();
    if (const auto cells = zeros(); !cells.empty())
        refuse_inverse(degree_, volumes_.numbers(degree_, cells));
    return volumes_.ratios(degree_).cwiseInverse();
}

Vector HodgeStar::inverse() const {
    return entries(measured_inverse(), -1);
}

Vector HodgeStar::uncertainty() const {
    require_diagonal();
    return entries(volumes_.rounding(degree_).vector().cwiseQuotient(volumes_.primal(degree_)), 1);
}

template <class Is>
std::vector<Index> HodgeStar::cells_whose_dual(Is is) const {
    std::vector<Index> cells;
    const auto& [primal, dual, terms, rounding] = volumes_.degree(degree_);
    for (Index s = 0; is_diagonal() && s < size(); ++s)
        if (is(dual[s], terms, s))
            cells.push_back(s);
    return cells;
}

std::vector<Index> HodgeStar::zeros() const {
    return cells_whose_dual(
        [](double dual, const Bounds& terms, Index s) { return is_zero(dual, terms[s]); });
}

std::vector<Index> HodgeStar::negatives() const {
    return cells_whose_dual([](double dual, const Bounds& terms, Index s) {
        return dual < 0 && !is_zero(dual, terms[s]);
    });
}

std::string HodgeStar::numbers(const std::vector<Index>& cells) const {
    return first_of(volumes_.numbers(degree_, cells));
}

Error::Place HodgeStar::place(const std::vector<Index>& cells) const {
    return {.degree = degree_, .cells = volumes_.numbers(degree_, cells)};
}

HodgeStar HodgeStars::operator[](int k) const {
    const auto found = std::find_if(matrices_.begin(), matrices_.end(),
                                    [&](const HodgeStar& star) { return star.degree() == k; });
    return found != matrices_.end() ? *found : HodgeStar(volumes_, k);
}

HodgeStars HodgeStars::with(int k, SparseMatrix matrix) const {
    HodgeStars result = *this;
    std::erase_if(result.matrices_, [&](const HodgeStar& star) { return star.degree() == k; });
    result.matrices_.emplace_back(volumes_, k, std::move(matrix));
    return result;
}

const char* name(StarKind kind) {
    constexpr std::array names{"circumcentric", "galerkin",  "hybrid",
                               "barycentric",   "automatic", "own"};
    return names[static_cast<std::size_t>(kind)];
}

bool all_positive(const HodgeStars& stars) {
    for (int k = 0; k <= stars.dimension(); ++k) {
        const auto& [primal, dual, terms, rounding] = stars.volumes().degree(k);
        const Index size = stars[k].is_diagonal() ? primal.size() : 0;
        for (Index s = 0; s < size; ++s)
            if (dual[s] <= rounding_of(terms[s]))
                return false;
    }
    return true;
}

StarKind automatic_kind(int dimension, bool every_dual_is_positive) {
    return every_dual_is_positive                 ? StarKind::circumcentric
           : dimension == GluedSurface::dimension ? StarKind::hybrid
                                                  : StarKind::galerkin;
}

void check_fit(const CellComplex& complex, const HodgeStars& stars) {
    check_fit(complex, stars.volumes());
    for (int k = 0; k <= complex.dimension(); ++k) {
        if (stars[k].is_diagonal())
            continue;
        const Vector diagonal = stars[k].matrix().diagonal();
        for (Index cell = 0; cell < diagonal.size(); ++cell)
            if (!(diagonal[cell] > 0))
                throw InvalidInput(
                    fmt::format("the star of {}-cells is given by a matrix whose entry {} on the "
                                "diagonal is {}: expected a symmetric positive definite one",
                                k, cell, diagonal[cell]),
                    {.degree = k, .cells = {cell}});
    }
}

ChosenStars::ChosenStars(const HodgeStars& stars_, StarKind kind_, std::vector<bool> galerkin_)
    : stars(stars_), kind(kind_), galerkin(std::move(galerkin_)), geometric(stars_) {
    if (galerkin.empty() && stars.dimension() >= 0)
        galerkin.resize(static_cast<std::size_t>(stars[stars.dimension()].size()));
}

bool ChosenStars::is_over_duals(int k) const {
    return stars[k].is_diagonal() &&
           (kind == StarKind::circumcentric || kind == StarKind::own || k == stars.dimension());
}

double ChosenStars::galerkin_share() const {
    const auto count = std::count(galerkin.begin(), galerkin.end(), true);
    return galerkin.empty() ? 0 : static_cast<double>(count) / static_cast<double>(galerkin.size());
}

} // namespace polydec
