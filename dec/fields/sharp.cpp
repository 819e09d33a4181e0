// SPDX-License-Identifier: MIT
#include "base/decompositions.h"
#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/flat_and_sharp.h"
#include "dec/fields/flat_pieces.h"
#include "dec/fields/seams.h"
#include "dec/fields/transfer.h"
#include "dec/forms/input_units.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/stars/star.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace polydec {

namespace {

void check_form(const Discretization& mesh, const Cochain& form, int degree) {
    require_points(mesh.ambient_dimension(), "a sharp");
    if (form.side != Side::primal || form.degree != degree)
        throw InvalidInput(fmt::format("expected a primal {}-form, not a {} {}-form", degree,
                                       name(form.side), form.degree));
    check(mesh.complex(), form);
}

void check_dual_cells(const Discretization& mesh) {
    auto zero = star(mesh.input_geometry().volumes(), 0).zeros();
    if (zero.empty())
        return;
    const auto count = zero.size();
    zero.resize(std::min<std::size_t>(count, 5));
    zero = mesh.input().vertex_numbers(std::move(zero));
    throw InvalidInput(
        fmt::format(
            "the sharp to vertices divides by zero: the dual cells of {} vertices have no volume "
            "(vertices {}{}); use vectors at the cells (sharp_pd), or move the vertices",
            count, fmt::join(zero, ", "), count > zero.size() ? ", .." : ""),
        {.vertices = zero});
}

/// Row i: sum over the other vertices j of an n-simplex of a(i->j) grad lambda_j.
DenseMatrix gradients_seen_from_vertices(const Discretization& mesh, const Vector& a, Index t) {
    const auto& K = mesh.input();
    const int n = mesh.dimension();
    const auto [points, corners] = mesh.places();
    const DenseMatrix gradients = barycentric_gradients(points, vertices(corners, t));
    DenseMatrix result = DenseMatrix::Zero(n + 1, points.cols());
    for (int i = 0; i <= n; ++i)
        for (int j = i + 1; j <= n; ++j) {
            const Index e = face_at(K, n, t, std::array{i, j});
            const double value = orientation(K, 1, e) * a[e];
            result.row(i) += value * gradients.row(j);
            result.row(j) -= value * gradients.row(i);
        }
    return result;
}

/// For flat pieces, the mean of these in the other pieces of their cells; empty without any.
Points gradients_in_flat_pieces(const Discretization& mesh, const Vector& a) {
    if (mesh.geometry().flat().empty())
        return {};
    Points rows(mesh.pieces().size(mesh.dimension()), mesh.ambient_dimension());
    for (Index t = 0; t < rows.rows(); ++t)
        rows.row(t) = gradients_seen_from_vertices(mesh, a, t).colwise().mean();
    fill_flat_pieces(mesh, rows);
    return rows;
}

constexpr double rank_tolerance = 1e-12;

/// Orthonormal basis, as columns, of the mean tangent space of n-simplices: the n eigenvectors of
/// largest eigenvalue of the mean projection onto their planes. Fewer if all corners lie on a line,
/// as for a triangle that flips have laid around a spike.
DenseMatrix mean_tangents(const Discretization& mesh, Index cell) {
    const int n = mesh.dimension();
    const auto [points, tops] = mesh.places_of_pieces();
    const auto N = points.cols();
    DenseMatrix sum = DenseMatrix::Zero(N, N);
    for (const Index t : mesh.merging().pieces_of(n, cell)) {
        const auto corners = vertices(tops, t);
        const DenseMatrix gradients = barycentric_gradients(points, corners);
        DenseMatrix projection = DenseMatrix::Zero(N, N);
        for (int i = 1; i <= n; ++i)
            projection +=
                (points.row(corners[i]) - points.row(corners[0])).transpose() * gradients.row(i);
        sum += mesh.geometry().volumes().primal(n)[t] * projection;
    }
    const Eigen::SelfAdjointEigenSolver<DenseMatrix> solver(sum);
    const Vector largest = solver.eigenvalues().tail(n);
    return solver.eigenvectors().rightCols(
        (largest.array() > rank_tolerance * largest.sum()).count());
}

/// The merged edges where a merged n-cell lies, of which only those around it are used.
class EdgesBesideCells {
public:
    explicit EdgesBesideCells(const Discretization& mesh)
        : mesh_(mesh),
          faces_(mesh.pieces(), mesh.dimension(), 1),
          pieces_(mesh.pieces().size(1), mesh.ambient_dimension()) {}

    void look_at(Index cell) {
        for (const Index t : mesh_.merging().pieces_of(mesh_.dimension(), cell)) {
            const DenseMatrix edges = edges_beside(mesh_, faces_, t);
            pieces_(faces_.of(t), Eigen::indexing::all) = edges;
        }
    }

    Vector operator[](Index edge) const {
        Vector sum = Vector::Zero(pieces_.cols());
        for (IncidenceMatrix::InnerIterator piece(mesh_.merging().diamond(1), edge); piece; ++piece)
            sum += piece.value() * pieces_.row(piece.col()).transpose();
        return sum;
    }

private:
    const Discretization& mesh_;
    SimplexFaces faces_;
    DenseMatrix pieces_;
};

/// For each merged n-cell the weights |*e part in it| / |e| of its merged edges.
SparseMatrix edge_weights(const Discretization& mesh) {
    const int n = mesh.dimension();
    const SparseMatrix parts = dual_parts(mesh.geometry(), mesh.geometry().centers(), 1, n);
    const SparseMatrix cells = mesh.merging().diamond(n).cast<double>().cwiseAbs();
    const SparseMatrix edges = mesh.merging().diamond(1).cast<double>().cwiseAbs();
    // a vector of its own: Eigen's product would copy an expression's diagonal for every row
    const Vector inverse_lengths = mesh.geometry().volumes().primal(1).cwiseInverse();
    const SparseMatrix weighted = parts * inverse_lengths.asDiagonal();
    const SparseMatrix on_cells = cells * weighted;
    return on_cells * SparseMatrix(edges.transpose());
}

} // namespace

DenseMatrix sharp_pp(const Discretization& mesh, const Cochain& form) {
    check_form(mesh, form, 1);
    refuse_turned_vertices(mesh, "the sharp to vertices");
    check_dual_cells(mesh);
    const auto& K = mesh.input();
    const int n = mesh.dimension();
    const Geometry& input = mesh.input_geometry();
    const Points parts = parts_of_duals(input, input.centers(), 0, n);
    const Vector a = lifted(mesh, form).values;
    const Points in_flat = gradients_in_flat_pieces(mesh, a);
    Points at_cells = Points::Zero(K.size(0), mesh.ambient_dimension());
    for (Index t = 0; t < K.size(n); ++t) {
        DenseMatrix seen = gradients_seen_from_vertices(mesh, a, t);
        if (mesh.geometry().is_flat(t))
            seen = in_flat.row(t).replicate(n + 1, 1);
        for (int i = 0; i <= n; ++i) {
            const Index v = face_at(K, n, t, std::array{i});
            at_cells.row(v) +=
                parts(t, i) / mesh.input_geometry().volumes().dual(0)[v] * seen.row(i);
        }
    }
    return in_input_units(mesh.passage().forth(0, at_cells), mesh.unit(), -1, "vectors");
}

DenseMatrix sharp_pd(const Discretization& mesh, const Cochain& form) {
    check_form(mesh, form, 1);
    refuse_turned_cells(mesh, "the sharp to cells");
    const SparseMatrix weights = edge_weights(mesh);
    EdgesBesideCells edges(mesh);
    const auto N = mesh.ambient_dimension();
    DenseMatrix result(weights.rows(), N);
    for (Index cell = 0; cell < weights.rows(); ++cell) {
        DenseMatrix M = DenseMatrix::Zero(N, N);
        Vector right_side = Vector::Zero(N);
        edges.look_at(cell);
        for (SparseMatrix::InnerIterator entry(weights, cell); entry; ++entry) {
            const Vector e = edges[entry.col()];
            M += entry.value() * e * e.transpose();
            right_side += entry.value() * form.values[entry.col()] * e;
        }

        const DenseMatrix T = mean_tangents(mesh, cell);
        const Eigen::SelfAdjointEigenSolver<DenseMatrix> parts(DenseMatrix(T.transpose() * M * T));
        const Vector& sizes = parts.eigenvalues();
        if (!(sizes.cwiseAbs().minCoeff() > rank_tolerance * sizes.cwiseAbs().maxCoeff()))
            throw InvalidInput(
                fmt::format("the vector at merged cell {} (vertices {}) is not determined by its "
                            "edges, whose weights cancel: move its vertices",
                            cell, fmt::join(cell_vertices(mesh, mesh.dimension(), cell), ", ")),
                {.degree = mesh.dimension(),
                 .cells = {cell},
                 .vertices = cell_vertices(mesh, mesh.dimension(), cell)});
        const DenseMatrix axes = T * parts.eigenvectors();
        result.row(cell) = axes * (axes.transpose() * right_side).cwiseQuotient(sizes);
    }
    return in_input_units(std::move(result), mesh.unit(), -1, "vectors");
}

DenseMatrix flux_sharp(const Discretization& mesh, const Cochain& form) {
    const int n = mesh.dimension();
    check_form(mesh, form, n - 1);
    refuse_turned_cells(mesh, "the sharp of fluxes");
    if (mesh.box()) {
        // the integral over a cell sums over its parts in the box
        const Discretization& box = placed(mesh);
        DenseMatrix of_parts = flux_sharp(box, form_at_places(mesh, form));
        DenseMatrix result(mesh.complex().size(n), of_parts.cols());
        for (Eigen::Index axis = 0; axis < result.cols(); ++axis) {
            const Cochain values = to_input(box, {Side::dual, 0, of_parts.col(axis)});
            result.col(axis) =
                on_cells(mesh, {Side::dual, 0, from_places(mesh, n, values.values)}).values;
        }
        return result;
    }
    const Points centroids = cell_centroids(mesh, n);
    const Points facets = cell_centroids(mesh, n - 1);
    Points result = Points::Zero(centroids.rows(), centroids.cols());
    for (Index cell = 0; cell < centroids.rows(); ++cell) {
        for (const auto& [f, sign] : mesh.complex().incidences(n - 1)[cell])
            result.row(cell) += sign * form.values[f] * (facets.row(f) - centroids.row(cell));
        result.row(cell) /= mesh.volumes().primal(n)[cell];
    }
    return in_input_units(DenseMatrix(result), mesh.unit(), -n, "vectors");
}

} // namespace polydec
