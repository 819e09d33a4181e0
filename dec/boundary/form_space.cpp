// SPDX-License-Identifier: MIT
#include "dec/boundary/form_space.h"

#include "base/errors.h"
#include "dec/boundary/two_sided.h"
#include "dec/forms/laplacian.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace polydec {

namespace {

/// The cells whose duals lie on the boundary: facets without dual that are not already left out,
/// the n-cells beside them, and cells with no other cofaces.
CellMarks on_the_boundary(const CellComplex& complex, std::vector<bool> without_dual,
                          const CellMarks& left_out) {
    const int n = complex.dimension();
    CellMarks marks = no_marks(complex);
    if (std::find(without_dual.begin(), without_dual.end(), true) == without_dual.end())
        return marks;
    marks[n - 1] = std::move(without_dual);
    for (Index f = 0; f < complex.size(n - 1); ++f)
        if (left_out[n - 1][f])
            marks[n - 1][f] = false;
    for (Index t = 0; t < complex.size(n); ++t)
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (marks[n - 1][f.face])
                marks[n][t] = true;
    for (int k = n - 2; k >= 0; --k) {
        std::vector<bool> has_other(complex.size(k), false);
        for (Index t = 0; t < complex.size(k + 1); ++t)
            for (const SignedFace& s : complex.incidences(k)[t])
                if (marks[k + 1][t])
                    marks[k][s.face] = true;
                else
                    has_other[s.face] = true;
        for (Index s = 0; s < complex.size(k); ++s)
            if (has_other[s] || left_out[k][s])
                marks[k][s] = false;
    }
    return marks;
}

/// In the unit of the cells.
Vector coefficients_on(const Cells& cells, BoundaryConditions conditions) {
    for (double& coefficient : conditions.coefficients)
        coefficient *= cells.unit();
    return robin_coefficients(cells.complex(), conditions);
}

/// A star plus Robin's part, which is inverted.
SparseMatrix with_layer(const HodgeStar& star, const SparseMatrix& layer) {
    const SparseMatrix sum = star.matrix() + layer;
    std::vector<Index> bad;
    for (Index cell = 0; cell < sum.rows(); ++cell)
        if (!(sum.coeff(cell, cell) > 0))
            bad.push_back(cell);
    if (!bad.empty())
        throw InvalidInput(
            fmt::format(
                "the star of {}-cells with Robin's condition is not positive on {} of {} cells "
                "({}): their duals have negative or zero volume; use stars that are positive on "
                "every mesh (StarKind::automatic)",
                star.degree(), bad.size(), star.size(), star.numbers(bad)),
            star.place(bad));
    return sum;
}

} // namespace

FormSpace::FormSpace(const Cells& cells, Side side, int degree)
    : FormSpace(cells, side, degree, built_in_conditions(side)) {}

FormSpace::FormSpace(const Cells& cells, Side side, int degree,
                     const BoundaryConditions& conditions) {
    const CellComplex& complex = cells.complex();
    const int k = polydec::cell_degree(complex, side, degree); // throws for an invalid degree
    if (side == Side::dual && degree == 0)
        check_not_branching(cells);
    if (degree == complex.dimension())
        polydec::refuse_robin(complex, conditions, "n-forms, which have no trace");
    auto parts = std::shared_ptr<Parts>(new Parts{
        cells, side, degree, k, conditions, essential_cells(complex, conditions, side, degree)});
    parts->robin = coefficients_on(cells, conditions);
    if (side == Side::dual || degree == cells.dimension()) {
        parts->without_dual = cells.boundary_facets_without_dual();
        for (Index f = 0; f < parts->robin.size(); ++f)
            if (parts->robin[f] > 0) // no value is given there
                parts->without_dual[f] = false;
    }
    parts_ = std::move(parts);
}

FormSpace FormSpace::vanishing_on(const Cells& cells, Side side, int degree,
                                  const CellMarks& closed) {
    const CellComplex& complex = cells.complex();
    const int k = polydec::cell_degree(complex, side, degree);
    CellMarks fixed = closed.empty() ? no_marks(complex) : closed;
    return FormSpace(std::shared_ptr<Parts>(
        new Parts{cells, side, degree, k, {BoundaryCondition::natural}, std::move(fixed)}));
}

std::string FormSpace::in_words(const BoundaryData& data) const {
    const CellComplex& complex = parts_->cells.complex();
    return polydec::in_words(boundary_counts(complex, conditions()), degree(), complex.dimension(),
                             data);
}

void FormSpace::require_use(const NamedData& data) const {
    polydec::require_use(boundary_counts(parts_->cells.complex(), conditions()), data);
}

Cochain FormSpace::form(Vector values) const {
    Cochain result{side(), degree(), std::move(values)};
    check(result);
    return result;
}

void FormSpace::check(const Cochain& form) const {
    if (form.side != side() || form.degree != degree())
        throw InvalidInput(fmt::format("a {} {}-form is given: expected a {} {}-form",
                                       name(form.side), form.degree, name(side()), degree()));
    polydec::check(parts_->cells.complex(), form);
}

void FormSpace::refuse_robin(const char* what) const {
    polydec::refuse_robin(parts_->cells.complex(), conditions(), what);
}

const CellMarks& FormSpace::on_the_boundary() const {
    return parts_->on_boundary.get([&] {
        return polydec::on_the_boundary(parts_->cells.complex(), parts_->without_dual, fixed());
    });
}

const CellMarks& FormSpace::left_out() const& {
    if (parts_->without_dual.empty())
        return fixed();
    return parts_->left_out.get([&] {
        CellMarks marks = fixed();
        for (std::size_t k = 0; k < marks.size(); ++k)
            std::transform(marks[k].begin(), marks[k].end(), on_the_boundary()[k].begin(),
                           marks[k].begin(), std::logical_or<>());
        return marks;
    });
}

const RelativeComplex& FormSpace::relative() const& {
    return parts_->relative.get(
        [&] { return relative_complex(parts_->cells.complex(), fixed(), on_the_boundary()); });
}

Cells FormSpace::inside() const {
    return parts_->inside.get([&] {
        HodgeStars stars = relative_stars(relative(), parts_->cells.stars());
        const int below = cell_degree() - 1;
        if (robin_layer().size() > 0)
            stars =
                stars.with(below, with_layer(stars[below], relative().block(below, robin_layer())));
        return Cells(relative().complex, stars, parts_->cells.unit());
    });
}

const SparseMatrix& FormSpace::robin_weights() const& {
    return parts_->weights.get([&] {
        const bool has_any = side() == Side::primal && !parts_->robin.isZero(0);
        return has_any ? parts_->cells.boundary_star(cell_degree(), parts_->robin) : SparseMatrix();
    });
}

const SparseMatrix& FormSpace::robin_layer() const& {
    return parts_->layer.get([&] {
        const Vector& robin = parts_->robin;
        if (side() == Side::primal || robin.isZero(0))
            return SparseMatrix();
        return parts_->cells.boundary_star(
            cell_degree() - 1, (robin.array() > 0).select(robin.cwiseInverse(), 0.0 * robin));
    });
}

SparseMatrix FormSpace::free_robin_weights() const {
    return robin_weights().size() > 0 ? relative().block(cell_degree(), robin_weights())
                                      : SparseMatrix();
}

Operator FormSpace::stiffness() const {
    const Cells on = inside();
    const Operator without = symmetric_laplacian({on.complex(), on.stars()}, cell_degree());
    if (robin_weights().size() == 0)
        return without;
    return without + Operator::star({on.stars().volumes(), cell_degree(), free_robin_weights()});
}

} // namespace polydec
