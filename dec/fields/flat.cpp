// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/flat_and_sharp.h"
#include "dec/fields/flat_pieces.h"
#include "dec/fields/seams.h"
#include "dec/fields/transfer.h"
#include "dec/forms/input_units.h"
#include "dec/metric/centers.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/inverse_star.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/stars/star.h"
#include "dec/surfaces/places.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec {

namespace {

bool is_at_vertices(Flat kind) {
    return kind != Flat::dpp && kind != Flat::dpd;
}

bool is_primal(Flat kind) {
    return kind == Flat::ppp || kind == Flat::pdp || kind == Flat::dpp;
}

void check_field(const Discretization& mesh, bool at_vertices, const DenseMatrix& field) {
    const auto N = mesh.ambient_dimension();
    require_points(N, "a flat");
    const auto rows = at_vertices ? mesh.measured_points().rows()
                                  : Eigen::Index(mesh.complex().size(mesh.dimension()));
    const char* place = at_vertices ? "vertex" : "merged cell";
    if (field.rows() != rows || field.cols() != N)
        throw InvalidInput(
            fmt::format("a field of {} x {} numbers is given: expected {} x {}, a row for each {}",
                        field.rows(), field.cols(), rows, N, place));
    for (Index row = 0; row < field.rows(); ++row)
        if (!field.row(row).allFinite())
            throw InvalidInput(fmt::format("the vector at {} {} is not finite", place,
                                           at_vertices ? mesh.pieces().vertex_number(row) : row),
                               at_vertices
                                   ? Error::Place{.vertices = {mesh.pieces().vertex_number(row)}}
                                   : Error::Place{.degree = mesh.dimension(), .cells = {row}});
}

/// Means of the rows of the vertices of each k-simplex.
Points means(const Pieces& complex, const Points& field, int k) {
    return combinations(complex, k, Points::Constant(complex.size(k), k + 1, 1.0 / (k + 1)), field);
}

/// Copies the vectors of the merged n-cells to their pieces.
Points copied_to_pieces(const Discretization& mesh, const DenseMatrix& field) {
    const auto& carriers = mesh.merging().carriers(mesh.dimension());
    Points result(carriers.size(), field.cols());
    for (std::size_t t = 0; t < carriers.size(); ++t)
        result.row(t) = field.row(carriers[t].cell);
    return result;
}

/// Product of each edge of the input with the mean of the vectors at its ends.
Vector along_edges(const Discretization& mesh, const DenseMatrix& field) {
    const Discretization& at = placed(mesh);
    const DenseMatrix edges =
        from_places(mesh, 1, edge_vectors(at.input(), at.measured_input_points()));
    const Points of_input = field.topRows(mesh.input().size(0)); // others are from splits
    return edges.cwiseProduct(means(mesh.input(), of_input, 1)).rowwise().sum();
}

void check_dual_volumes(const Discretization& mesh) {
    if (const auto zero = star(mesh.volumes(), 1).zeros(); !zero.empty())
        throw InvalidInput(
            fmt::format("the dpp flat divides by zero: the dual of the edge with vertices {} has "
                        "no volume ({} such edges, see HodgeStar::zeros of degree 1); merge cells, "
                        "or give the field at the vertices",
                        fmt::join(cell_vertices(mesh, 1, zero.front()), ", "), zero.size()),
            {.degree = 1, .cells = zero, .vertices = cell_vertices(mesh, 1, zero.front())});
}

/// Product of each edge with the vectors of the n-simplices around, by parts of the dual.
Vector around_edges(const Discretization& mesh, const DenseMatrix& field) {
    check_dual_volumes(mesh);
    const int n = mesh.dimension();
    const Points parts = parts_of_duals(mesh.geometry(), mesh.geometry().centers(), 1, n);
    const Points vectors = copied_to_pieces(mesh, field);
    SimplexFaces faces(mesh.pieces(), n, 1);
    Vector result = Vector::Zero(mesh.pieces().size(1));
    for (Index t = 0; t < vectors.rows(); ++t) {
        const Vector along = edges_beside(mesh, faces, t) * vectors.row(t).transpose();
        const auto& edges = faces.of(t);
        for (Index i = 0; i < along.size(); ++i)
            result[edges[i]] += parts(t, i) * along[i];
    }

    // edges inside merged cells do not count, and their duals may vanish
    constexpr int own = 1;
    const auto& carriers = mesh.merging().carriers(own);
    for (Index e = 0; e < result.size(); ++e)
        result[e] =
            carriers[e].dimension == own ? result[e] / mesh.geometry().volumes().dual(own)[e] : 0;
    return result;
}

/// Integral along the dual edge of each facet f, by its pieces in the n-simplices t around f.
Vector along_dual_edges(const Discretization& mesh, Flat kind, const DenseMatrix& given) {
    const int n = mesh.dimension();
    const Discretization& at = placed(mesh);
    const Pieces& K = at.pieces();
    const Places places(at.passage(), at.measured_points());
    const Points centers = at_centers(at, places, at.measured_points(), n);
    const Points facet_centers = at_centers(at, places, at.measured_points(), n - 1);
    const auto integrals = [&](auto mean) { // mean(t, f): of the field over the piece
        const double sign = n % 2 == 0 ? 1 : -1;
        Vector result = Vector::Zero(K.size(n - 1));
        for (Index t = 0; t < K.size(n); ++t)
            for (int i = n; i >= 0; --i) {
                const Index f = K.face(n, t, i);
                const auto piece = centers.row(t) - facet_centers.row(f);
                result[f] += sign * K.sign(n, t, i) * piece.dot(mean(t, f));
            }
        return result;
    };
    const Points field = is_at_vertices(kind) ? to_places(mesh, 0, given)
                                              : to_places(mesh, n, copied_to_pieces(mesh, given));
    if (kind == Flat::ppd) {
        const Points cells = at_centers(at, places, field, n);
        const Points facets = at_centers(at, places, field, n - 1);
        return integrals([&](Index t, Index f) { return (cells.row(t) + facets.row(f)) / 2; });
    }
    const Points vectors = kind == Flat::pdd ? means(K, field, n - 1) : field;
    return integrals([&](Index t, Index f) { return vectors.row(kind == Flat::pdd ? f : t); });
}

/// Stars of the fluxes of the vectors, if stars know no duals: on the simplices of the input for a
/// field at vertices, on the pieces for a field on cells.
Cochain star_of_fluxes(const Discretization& mesh, bool at_vertices, const DenseMatrix& field) {
    const int n = mesh.dimension();
    const Pieces& K = at_vertices ? mesh.input() : mesh.pieces();
    const auto [points, corners] = at_vertices ? mesh.places() : mesh.places_of_pieces();
    const Points of_facets = at_vertices ? means(K, field.topRows(K.size(0)), n - 1) : Points();
    const Points of_cells = at_vertices ? Points() : copied_to_pieces(mesh, field);
    const Cochain fluxes{Side::primal, n - 1,
                         inverse_star_means(K, points, corners, 1, [&](Index t, Index f) {
                             return at_vertices ? of_facets.row(f) : of_cells.row(t);
                         })};
    const Cochain of_mesh = at_vertices ? to_merged(mesh, fluxes) : on_cells(mesh, fluxes);
    return {Side::dual, 1, mesh.geometric_star(n - 1) * of_mesh.values};
}

/// For vectors in the unit of the mesh.
Cochain flat_in_unit(const Discretization& mesh, Flat kind, const DenseMatrix& field) {
    if (!is_primal(kind) && !mesh.chosen_stars().is_over_duals(mesh.dimension() - 1))
        return star_of_fluxes(mesh, is_at_vertices(kind), field);
    if (!is_primal(kind))
        return on_cells(mesh, {Side::dual, 1,
                               sums_from_places(mesh, mesh.dimension() - 1,
                                                along_dual_edges(mesh, kind, field))});
    if (kind == Flat::dpp)
        return on_cells(mesh, {Side::primal, 1, around_edges(mesh, field)});
    return to_merged(mesh, {Side::primal, 1, along_edges(mesh, field)});
}

} // namespace

Cochain flat(const Discretization& mesh, Flat kind, const DenseMatrix& field) {
    check_field(mesh, is_at_vertices(kind), field);
    (is_at_vertices(kind) ? refuse_turned_vertices : refuse_turned_cells)(mesh, "a flat");
    Cochain form = flat_in_unit(mesh, kind, field);
    form.values = form_in_input_units(form.values, mesh.unit(), 1, "circulations");
    return form;
}

} // namespace polydec
