// SPDX-License-Identifier: MIT
#include "dec/fields/transfer.h"

#include "base/errors.h"
#include "dec/forms/star.h"
#include "dec/metric/cell_volumes.h"
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

/// The cell that each flipped triangle is a piece of, and its sign there.
struct Piece {
    Index cell;
    double sign;
};

std::vector<Piece> pieces_of_cells(const IntrinsicTessellation& tessellation) {
    const IncidenceMatrix& diamond = tessellation.merging.diamonds[2];
    std::vector<Piece> pieces(static_cast<std::size_t>(diamond.cols()));
    for (Index cell = 0; cell < diamond.rows(); ++cell)
        for (Row t(diamond, cell); t; ++t)
            pieces[t.col()] = {cell, static_cast<double>(t.value())};
    return pieces;
}

/// Functions of the cells as means over what the input's triangles have in common with them; one
/// without area gets the value of a cell at its first corner.
Vector means_over_input(const Discretization& mesh, const Vector& values) {
    const auto& surface = mesh.intrinsic->surface();
    const auto of = pieces_of_cells(*mesh.intrinsic);
    const Overlay pieces = overlay(mesh);
    Vector sums = Vector::Zero(mesh.input().size(2)), areas = sums;
    for (Index p = 0; p < pieces.size(); ++p) {
        const Piece& piece = of[pieces.triangle[p]];
        areas[pieces.input[p]] += pieces.areas[p];
        sums[pieces.input[p]] +=
            pieces.areas[p] * pieces.signs[p] * piece.sign * values[piece.cell];
    }

    std::vector<Index> beside(static_cast<std::size_t>(surface.vertices()), 0);
    for (Index h = 0; h < 3 * surface.triangles(); ++h)
        beside[surface.tail(h)] = of[GluedSurface::triangle(h)].cell;
    const auto& K = mesh.input();
    for (Index t = 0; t < sums.size(); ++t) {
        const Index corner = K.coboundary(0).innerIndexPtr()[2 * K.face(2, t, 2)];
        sums[t] = areas[t] > 0 ? sums[t] / areas[t] : values[beside[corner]];
    }
    return sums;
}

/// Primal forms by the inverse flips, functions of the cells by means.
Cochain flipped_to_input(const Discretization& mesh, const Cochain& form) {
    if (form.side == Side::primal)
        return {form.side, form.degree, carry_back(*mesh.intrinsic, form.degree, form.values)};
    if (form.degree > 0)
        check_not_flipped(mesh, "a dual form of this degree on the input's triangles");
    return {form.side, form.degree, means_over_input(mesh, form.values)};
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
    check_fit(merging.input(), volumes);
    const SparseMatrix dia = merging.diamond(k).cast<double>();
    const Vector merged_volume = dia.cwiseAbs() * volumes.primal(k);
    return merged_volume.cwiseInverse().asDiagonal() * dia * volumes.primal(k).asDiagonal();
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
