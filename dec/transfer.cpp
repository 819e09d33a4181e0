// SPDX-License-Identifier: MIT
#include "dec/transfer.h"

#include "base/errors.h"
#include "dec/overlay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

SparseMatrix transposed(const SparseMatrix& A) {
    return A.transpose();
}

SparseMatrix merged_from(const Discretization& mesh, FormKind kind) {
    return kind.side == Side::primal
               ? primal_to_merged(mesh.merging, kind.degree)
               : dual_to_merged(mesh.merging, mesh.input_volumes, kind.degree);
}

SparseMatrix input_from(const Discretization& mesh, FormKind kind) {
    return kind.side == Side::primal
               ? primal_to_input(mesh.merging, mesh.input_volumes, kind.degree)
               : dual_to_input(mesh.merging, kind.degree);
}

std::vector<Index> a_cell_at_each_vertex(const IntrinsicTessellation& tessellation) {
    const auto& surface = tessellation.surface();
    const IncidenceMatrix& pieces = tessellation.merging.diamonds[2];
    std::vector<Index> cells(static_cast<std::size_t>(surface.vertices()), 0);
    for (Index cell = 0; cell < pieces.rows(); ++cell)
        for (Row t(pieces, cell); t; ++t)
            for (Index i = 0; i < 3; ++i)
                cells[surface.tail(3 * static_cast<Index>(t.col()) + i)] = cell;
    return cells;
}

Index first_corner(const SimplicialComplex& complex, Index triangle) {
    return complex.coboundary(0).innerIndexPtr()[2 * complex.face(2, triangle, 2)];
}

/// Primal forms by the inverse flips; functions of the cells as means over what triangles cover.
Cochain flipped_to_input(const Discretization& mesh, const Cochain& form) {
    if (form.side == Side::primal)
        return {form.side, form.degree, carry_back(*mesh.intrinsic, form.degree, form.values)};
    if (form.degree > 0)
        check_not_flipped(mesh, "a dual form of this degree on the input's triangles");
    const SparseMatrix areas = overlap(mesh);
    const Vector totals = areas * Vector::Ones(areas.cols());
    Vector means = areas * form.values;
    const auto beside = a_cell_at_each_vertex(*mesh.intrinsic);
    for (Index t = 0; t < means.size(); ++t) // one without area covers none
        means[t] = totals[t] > 0 ? means[t] / totals[t]
                                 : form.values[beside[first_corner(mesh.input(), t)]];
    return {form.side, form.degree, means};
}

std::string simplex(const SimplicialComplex& K, int k, Index s) {
    return fmt::format("the {}-simplex {} with vertices {}", k, s,
                       fmt::join(K.simplices(k).row(s), ", "));
}

} // namespace

SparseMatrix primal_to_merged(const Merging& merging, int k) {
    return merging.diamond(k).cast<double>();
}

SparseMatrix primal_to_input(const Merging& merging, const CellVolumes& volumes, int k) {
    return transposed(dual_to_merged(merging, volumes, merging.merged().dimension() - k));
}

SparseMatrix dual_to_merged(const Merging& merging, const CellVolumes& volumes, int j) {
    const int k = merging.merged().dimension() - j;
    const SparseMatrix dia = merging.diamond(k).cast<double>();
    const Vector merged_volume = dia.cwiseAbs() * volumes.primal.at(k);
    return merged_volume.cwiseInverse().asDiagonal() * dia * volumes.primal[k].asDiagonal();
}

SparseMatrix dual_to_input(const Merging& merging, int j) {
    return transposed(primal_to_merged(merging, merging.merged().dimension() - j));
}

SparseMatrix on_input(const Discretization& discretization, const SparseMatrix& O, FormKind from,
                      FormKind to) {
    check_not_flipped(discretization, "an operator on the input's simplices");
    const auto& P = discretization.complex();
    const Index columns = P.size(cell_degree(P, from.side, from.degree));
    const Index rows = P.size(cell_degree(P, to.side, to.degree));
    if (O.rows() != rows || O.cols() != columns)
        throw InvalidInput(fmt::format("an operator from {} {}-forms to {} {}-forms on the merged "
                                       "cells is {} x {}, the one given is {} x {}",
                                       name(from.side), from.degree, name(to.side), to.degree, rows,
                                       columns, O.rows(), O.cols()));
    const SparseMatrix down = O * merged_from(discretization, from);
    return input_from(discretization, to) * down;
}

Cochain to_merged(const Discretization& discretization, const Cochain& form) {
    check(discretization.input(), form);
    if (discretization.intrinsic) {
        if (form.side == Side::dual)
            check_not_flipped(discretization, "a dual form of the input on the polygons");
        return {form.side, form.degree, carry(*discretization.intrinsic, form.degree, form.values)};
    }
    return {form.side, form.degree,
            merged_from(discretization, {form.side, form.degree}) * form.values};
}

Cochain to_input(const Discretization& discretization, const Cochain& form) {
    check(discretization.complex(), form);
    if (discretization.intrinsic)
        return flipped_to_input(discretization, form);
    return {form.side, form.degree,
            input_from(discretization, {form.side, form.degree}) * form.values};
}

Consistency consistency(const Discretization& discretization, const Cochain& form) {
    check_not_flipped(discretization, "the consistency of a dual form");
    const auto& K = discretization.input();
    check(K, form);
    if (form.side != Side::dual)
        throw InvalidInput(fmt::format("consistency is asked of a primal {}-form: it is a question "
                                       "about dual forms, whose cells may coincide",
                                       form.degree));
    if (!form.values.allFinite())
        throw InvalidInput("consistency is asked of a form with a value that is not finite");
    const int k = cell_degree(K, form.side, form.degree);
    const Vector expected = to_input(discretization, to_merged(discretization, form)).values;

    Consistency result;
    for (Index s = 0; s < form.values.size(); ++s)
        if (const double deviation = std::abs(form.values[s] - expected[s]);
            deviation > result.worst)
            result = {deviation, s, form.values[s], expected[s], {}};
    if (result.cell < 0)
        return result;
    const auto& carrier = discretization.merging.carriers(k)[result.cell];
    result.description =
        carrier.dimension > k
            ? fmt::format("{} lies inside a merged {}-cell, so its dual has no extent, but the "
                          "form has the value {:.6g} there: expected 0",
                          simplex(K, k, result.cell), carrier.dimension, result.found)
            : fmt::format("{} is a piece of the merged {}-cell {}, whose pieces have one dual, but "
                          "the form has the value {:.6g} there and {:.6g} in the mean",
                          simplex(K, k, result.cell), k, carrier.cell, result.found,
                          result.expected);
    return result;
}

} // namespace polydec
