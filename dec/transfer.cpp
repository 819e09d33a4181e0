// SPDX-License-Identifier: MIT
#include "dec/transfer.h"

#include "base/errors.h"

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
    return {form.side, form.degree,
            merged_from(discretization, {form.side, form.degree}) * form.values};
}

Cochain to_input(const Discretization& discretization, const Cochain& form) {
    check(discretization.complex(), form);
    return {form.side, form.degree,
            input_from(discretization, {form.side, form.degree}) * form.values};
}

Consistency consistency(const Discretization& discretization, const Cochain& form) {
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
