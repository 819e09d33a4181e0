// SPDX-License-Identifier: MIT
#include "dec/fields/transfer.h"

#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/stars/star.h"
#include "dec/surfaces/passage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

namespace polydec {

namespace {

SparseMatrix transposed(const SparseMatrix& A) {
    return A.transpose();
}

/// Maps forms on the pieces to the cells, and back.
SparseMatrix merged_from(const Discretization& mesh, FormKind kind) {
    return kind.side == Side::primal
               ? primal_to_merged(mesh.merging(), kind.degree)
               : dual_to_merged(mesh.merging(), mesh.geometry().volumes(), kind.degree);
}

SparseMatrix pieces_from(const Discretization& mesh, FormKind kind) {
    return kind.side == Side::primal
               ? primal_to_input(mesh.merging(), mesh.geometry().volumes(), kind.degree)
               : dual_to_input(mesh.merging(), kind.degree);
}

/// Maps forms on the input's simplices to the pieces, and back. Dual forms are paired with primal
/// forms, so they use the transposed map.
SparseMatrix forth(const Discretization& mesh, FormKind kind) {
    return kind.side == Side::primal
               ? mesh.passage().matrix(kind.degree)
               : transposed(mesh.passage().matrix_back(mesh.dimension() - kind.degree));
}

SparseMatrix back(const Discretization& mesh, FormKind kind) {
    return kind.side == Side::primal
               ? mesh.passage().matrix_back(kind.degree)
               : transposed(mesh.passage().matrix(mesh.dimension() - kind.degree));
}

/// Functions on flipped triangles as means over their intersections with the input's triangles; an
/// input triangle without area gets the value of a triangle at its first corner.
Vector means_over_input(const Discretization& mesh, const Vector& values) {
    const int n = mesh.dimension();
    const Pieces &K = mesh.input(), &pieces = mesh.pieces();
    const Overlay common = overlay(mesh.passage(), mesh.measured_points());
    Vector sums = Vector::Zero(K.size(n)), areas = sums;
    for (Index p = 0; p < common.size(); ++p) {
        areas[common.input[p]] += common.areas[p];
        sums[common.input[p]] += common.areas[p] * common.signs[p] * values[common.triangle[p]];
    }
    Vector beside = Vector::Zero(pieces.size(0));
    for (Index t = 0; t < pieces.size(n); ++t)
        for (int i = 0; i <= n; ++i)
            beside[face_at(pieces, n, t, std::array{i})] = values[t];
    for (Index t = 0; t < sums.size(); ++t)
        sums[t] = areas[t] > 0 ? sums[t] / areas[t] : beside[face_at(K, n, t, std::array{0})];
    return sums;
}

std::string simplex(const Pieces& K, int k, Index s) {
    return fmt::format("the {}-simplex {} with vertices {}", k, s,
                       fmt::join(K.vertex_numbers(k, s), ", "));
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
    check_fit(merging.pieces(), volumes);
    const SparseMatrix dia = merging.diamond(k).cast<double>();
    const Vector merged_volume = dia.cwiseAbs() * volumes.primal(k);
    return merged_volume.cwiseInverse().asDiagonal() * dia * volumes.primal(k).asDiagonal();
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
                                       "cells must be {} x {}, not {} x {}",
                                       name(from.side), from.degree, name(to.side), to.degree, rows,
                                       columns, O.rows(), O.cols()));
    const SparseMatrix down = O * merged_from(discretization, from);
    const SparseMatrix result = pieces_from(discretization, to) * down;
    const SparseMatrix on_pieces = result * forth(discretization, from);
    return back(discretization, to) * on_pieces;
}

Cochain to_merged(const Discretization& discretization, const Cochain& form) {
    check(discretization.input(), form);
    const auto& [side, degree, values] = form;
    if (discretization.passage().is_identity())
        return on_cells(discretization, form);
    if (side == Side::primal)
        return on_cells(discretization,
                        {side, degree, discretization.passage().forth(degree, values)});
    const auto& lift = discretization.merged().lift()[discretization.dimension() - degree];
    return {side, degree, lift.transpose() * (forth(discretization, {side, degree}) * values)};
}

Cochain on_pieces(const Discretization& mesh, const Cochain& form) {
    check(mesh.complex(), form);
    if (form.side != Side::primal)
        throw InvalidInput(fmt::format(
            "a dual {}-form cannot be lifted: lift its star, which is primal", form.degree));
    return {Side::primal, form.degree, mesh.merged().lift()[form.degree] * form.values};
}

Cochain on_cells(const Discretization& mesh, const Cochain& form) {
    check(mesh.pieces(), form);
    return {form.side, form.degree, merged_from(mesh, {form.side, form.degree}) * form.values};
}

Cochain lifted(const Discretization& mesh, const Cochain& form) {
    return {Side::primal, form.degree,
            mesh.passage().back(form.degree, on_pieces(mesh, form).values)};
}

Cochain to_input(const Discretization& discretization, const Cochain& form) {
    check(discretization.complex(), form);
    const FormKind kind{form.side, form.degree};
    if (discretization.passage().is_identity())
        return {form.side, form.degree, pieces_from(discretization, kind) * form.values};
    if (form.side == Side::primal) {
        // to allow later derivatives, values inside the cells must commute with them
        return lifted(discretization, form);
    }
    const Vector values = pieces_from(discretization, kind) * form.values;
    return {form.side, form.degree,
            form.degree == 0 ? means_over_input(discretization, values)
                             : Vector(back(discretization, kind) * values)};
}

Cochain form_at_places(const Discretization& mesh, const Cochain& form) {
    const int k = cell_degree(mesh.complex(), form.side, form.degree);
    check(mesh.complex(), form);
    if (!mesh.box())
        return form;
    const Vector values =
        form.side == Side::primal ? lifted(mesh, form).values : to_input(mesh, form).values;
    return to_merged(placed(mesh), {form.side, form.degree, to_places(mesh, k, values)});
}

Consistency consistency(const Discretization& discretization, const Cochain& form) {
    const auto& K = discretization.pieces();
    check(K, form);
    if (form.side != Side::dual)
        throw InvalidInput(fmt::format("a primal {}-form is given: only dual forms can be "
                                       "inconsistent, since dual cells may coincide",
                                       form.degree));
    const int k = cell_degree(K, form.side, form.degree);
    const FormKind kind{form.side, form.degree};
    const Vector expected =
        pieces_from(discretization, kind) * (merged_from(discretization, kind) * form.values);

    Consistency result;
    for (Index s = 0; s < form.values.size(); ++s)
        if (const double deviation = std::abs(form.values[s] - expected[s]);
            deviation > result.worst)
            result = {deviation, s, form.values[s], expected[s], {}};
    if (result.cell < 0)
        return result;
    const auto& carrier = discretization.merging().carriers(k)[result.cell];
    result.description =
        carrier.dimension > k
            ? fmt::format("{} lies inside a merged {}-cell, so its dual has no extent, but the "
                          "form has the value {:.6g} there: expected 0",
                          simplex(K, k, result.cell), carrier.dimension, result.found)
            : fmt::format("{} is a piece of the merged {}-cell {}, whose pieces share one dual, "
                          "but the form has the value {:.6g} there and {:.6g} on average",
                          simplex(K, k, result.cell), k, carrier.cell, result.found,
                          result.expected);
    return result;
}

} // namespace polydec
