// SPDX-License-Identifier: MIT
#include "dec/fields/lie_derivative.h"

#include "base/errors.h"
#include "dec/fields/contraction.h"
#include "dec/fields/seams.h"
#include "dec/fields/transfer.h"
#include "dec/forms/input_units.h"

#include <fmt/format.h>

#include <optional>

namespace polydec {

namespace {

/// Throws InvalidInput unless 0 <= k <= largest.
void check_degree_of_contraction(int k, int largest) {
    if (k < 0 || k > largest)
        throw InvalidInput(fmt::format(
            "a vector field cannot act on {}-forms here: expected a degree from 0 to {}", k,
            largest));
}

/// Throws InvalidInput for upwind transport of functions with values at vertices that splits have
/// added: carried to the input and back, these would follow their neighbors only.
void check_transport(const Discretization& mesh, int k, Sampling sampling) {
    const Index added = mesh.pieces().size(0) - mesh.input().size(0);
    if (k == 0 && sampling == Sampling::upwind && added > 0)
        throw InvalidInput(fmt::format(
            "upwind transport of functions is not monotone at the {} vertices that splits have "
            "added: use Delaunay::flips, which add none, or centered sampling",
            added));
}

constexpr auto acting = "a vector field that acts on forms";

/// Vectors at the vertices of the input, from vectors at the points of a mesh, in its unit. Throws
/// InvalidInput, naming the vertex, unless the field has one finite vector per point, and if only
/// lengths are known.
Points field_on_input(const Discretization& mesh, const Points& field) {
    const Pieces& complex = mesh.pieces();
    const int N = mesh.ambient_dimension();
    require_points(N, "a vector field");
    if (field.rows() != complex.size(0) || field.cols() != N)
        throw InvalidInput(fmt::format("a vector field of {} x {} numbers is given: expected {} x "
                                       "{}, a row for each point",
                                       field.rows(), field.cols(), complex.size(0), N));
    for (Index v = 0; v < field.rows(); ++v)
        if (!field.row(v).allFinite())
            throw InvalidInput(
                fmt::format("the vector field at vertex {} is not finite: give it a value",
                            complex.vertex_number(v)),
                {.vertices = {complex.vertex_number(v)}});
    return in_input_units(Points(mesh.passage().back(0, field)), mesh.unit(), -1, "vectors");
}

SparseMatrix contraction(const Pieces& complex, const PlacedSimplices& places, const Points& field,
                         int k, Sampling sampling, Beyond beyond) {
    check_degree_of_contraction(k, complex.dimension() + 1);
    SparseMatrix result(complex.size(k - 1), complex.size(k));
    if (result.rows() == 0 || result.cols() == 0)
        return result;
    std::vector<Eigen::Triplet<double, Index>> entries;
    Contraction(complex, places, k)
        .visit_entries(field, sampling, beyond, [&](Index s, Index coface, double value) {
            entries.emplace_back(s, coface, value);
        });
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

SparseMatrix inflow(const Pieces& complex, const PlacedSimplices& places, const Points& field,
                    int k) {
    const int n = complex.dimension();
    check_degree_of_contraction(k, n);
    SparseMatrix rates(complex.size(k), complex.size(k));
    if (k == n) // both sides of an n-simplex are interior
        return rates;
    std::vector<Eigen::Triplet<double, Index>> entries;
    Contraction(complex, places, k + 1).visit_inflow(field, [&](Index s, double rate) {
        entries.emplace_back(s, s, rate);
    });
    rates.setFromTriplets(entries.begin(), entries.end());
    return rates;
}

/// i_X d + d i_X, plus the inflow.
SparseMatrix lie_derivative(const Pieces& complex, const PlacedSimplices& places,
                            const Points& field, int k, Sampling sampling) {
    check_degree_of_contraction(k, complex.dimension());
    const auto interior = [&](int degree) {
        return contraction(complex, places, field, degree, sampling, Beyond::nothing);
    };
    const SparseMatrix upper = interior(k + 1) * derivative(complex, k);
    const SparseMatrix lower = derivative(complex, k - 1) * interior(k);
    const SparseMatrix L = upper + lower;
    return sampling == Sampling::upwind ? SparseMatrix(L + inflow(complex, places, field, k)) : L;
}

/// Maps an operator on the input's simplices, from k-forms to j-forms, to the cells.
SparseMatrix on_cells(const Discretization& mesh, const SparseMatrix& fine, int k, int j) {
    if (fine.rows() == 0 || fine.cols() == 0)
        return SparseMatrix(mesh.complex().size(j), mesh.complex().size(k));
    const SparseMatrix back = mesh.passage().matrix_back(k) * mesh.merged().lift()[k];
    const SparseMatrix there = mesh.passage().matrix(j) * SparseMatrix(fine * back);
    return mesh.merging().diamond(j).cast<double>() * there;
}

} // namespace

SparseMatrix interior_product(const Discretization& mesh, const Points& field, int k,
                              Sampling sampling) {
    refuse_turned_vertices(mesh, acting);
    const Points here = field_on_input(mesh, field);
    return on_cells(mesh,
                    contraction(mesh.input(), mesh.places(), here, k, sampling, Beyond::the_same),
                    k, k - 1);
}

SparseMatrix lie_derivative(const Discretization& mesh, const Points& field, int k,
                            Sampling sampling) {
    refuse_turned_vertices(mesh, acting);
    check_transport(mesh, k, sampling);
    const Points here = field_on_input(mesh, field);
    return on_cells(mesh, lie_derivative(mesh.input(), mesh.places(), here, k, sampling), k, k);
}

SparseMatrix inflow(const Discretization& mesh, const Points& field, int k) {
    refuse_turned_vertices(mesh, acting);
    const Points here = field_on_input(mesh, field);
    return on_cells(mesh, inflow(mesh.input(), mesh.places(), here, k), k, k);
}

struct LieDerivative::Parts {
    Discretization mesh;
    SimplicialComplex complex;
    int k;
    Sampling sampling;
    std::optional<Contraction> lower, upper; // of k-forms and of their derivatives

    Parts(const Discretization& on, int degree, Sampling how)
        : mesh(on), complex(mesh.input()), k(degree), sampling(how) {
        const PlacedSimplices places = mesh.places();
        check_degree_of_contraction(k, complex.dimension());
        require_points(mesh.ambient_dimension(), "a vector field");
        refuse_turned_vertices(mesh, acting);
        check_transport(mesh, k, sampling);
        if (k > 0)
            lower.emplace(complex, places, k);
        if (k < complex.dimension())
            upper.emplace(complex, places, k + 1);
    }

    /// Checks the form and returns its values on the simplices.
    Cochain checked(const Cochain& form) const {
        if (form.side != Side::primal || form.degree != k)
            throw InvalidInput(
                fmt::format("a {} {}-form is given: this Lie derivative acts on primal {}-forms",
                            name(form.side), form.degree, k));
        return lifted(mesh, form);
    }

    Cochain contract(const Contraction& by, const Points& field, const Cochain& form,
                     Beyond beyond) const {
        Vector values = Vector::Zero(complex.size(by.degree() - 1));
        by.visit_entries(field, sampling, beyond, [&](Index s, Index coface, double value) {
            values[s] += value * form.values[coface];
        });
        return {Side::primal, by.degree() - 1, std::move(values)};
    }

    void add_inflow(const Points& field, const Cochain& outside, Vector& to) const {
        if (upper && sampling == Sampling::upwind)
            upper->visit_inflow(field,
                                [&](Index s, double rate) { to[s] += rate * outside.values[s]; });
    }
};

LieDerivative::LieDerivative(const Discretization& mesh, int k, Sampling sampling)
    : parts_(std::make_shared<Parts>(mesh, k, sampling)) {}

Cochain LieDerivative::interior_product(const Points& field, const Cochain& form) const {
    const Points X = field_on_input(parts_->mesh, field);
    const Cochain a = parts_->checked(form);
    if (!parts_->lower)
        return {Side::primal, -1, {}};
    return to_merged(parts_->mesh, parts_->contract(*parts_->lower, X, a, Beyond::the_same));
}

Cochain LieDerivative::operator()(const Points& field, const Cochain& form) const {
    const Points X = field_on_input(parts_->mesh, field);
    const Cochain a = parts_->checked(form);
    Cochain result{Side::primal, a.degree, Vector::Zero(a.values.size())};
    if (parts_->upper)
        result.values +=
            parts_->contract(*parts_->upper, X, d(parts_->complex, a), Beyond::nothing).values;
    if (parts_->lower)
        result.values +=
            d(parts_->complex, parts_->contract(*parts_->lower, X, a, Beyond::nothing)).values;
    parts_->add_inflow(X, a, result.values);
    return to_merged(parts_->mesh, result);
}

Cochain LieDerivative::inflow(const Points& field, const Cochain& outside) const {
    const Points X = field_on_input(parts_->mesh, field);
    const Cochain g = parts_->checked(outside);
    Cochain result{Side::primal, g.degree, Vector::Zero(g.values.size())};
    parts_->add_inflow(X, g, result.values);
    return to_merged(parts_->mesh, result);
}

} // namespace polydec
