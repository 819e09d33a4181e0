// SPDX-License-Identifier: MIT
#include "base/block_matrix.h"
#include "base/checks.h"
#include "base/errors.h"
#include "complex/components.h"
#include "dec/forms/cells.h"
#include "dec/merging/merged_cells.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/whitney.h"

#include <fmt/format.h>

namespace polydec {

namespace {

/// The weights of the boundary facets, 0 at other facets.
Vector on_boundary(const CellComplex& complex, int k, const Vector& weights) {
    const int n = complex.dimension();
    check_number("the star within the boundary of degree", k, 0, n - 1);
    check_values("weights of facets", weights, complex.size(n - 1));
    Vector result = Vector::Zero(weights.size());
    for (const BoundaryFacet& on : boundary_facets(complex))
        result[on.facet] = weights[on.facet];
    return result;
}

SparseMatrix pieces_of(const MergedCells& cells, int k) {
    return cells.merging().diamond(k).cast<double>().cwiseAbs();
}

SparseMatrix by_duals(const MergedCells& cells, int k, const Vector& of_pieces) {
    const Geometry& geometry = cells.geometry();
    const SparseMatrix parts = dual_parts(geometry, geometry.centers(), k, cells.dimension() - 1);
    const Vector duals = parts.transpose() * of_pieces;
    const Vector& volumes = cells.volumes().primal(k);
    return diagonal_matrix((pieces_of(cells, k) * geometry.volumes().primal(k).cwiseProduct(duals))
                               .cwiseQuotient(volumes)
                               .cwiseQuotient(volumes));
}

SparseMatrix by_whitney_forms(const MergedCells& cells, int k, const Vector& of_pieces) {
    const Geometry& geometry = cells.geometry();
    const SparseMatrix W =
        whitney_mass(geometry.pieces(), geometry.metric(), cells.dimension() - 1, k, of_pieces);
    const SparseMatrix& S = cells.lift()[k];
    return S.transpose() * W * S;
}

/// Divides each facet equally among its vertices.
SparseMatrix equal_shares(const CellComplex& complex, const Vector& areas) {
    const int n = complex.dimension();
    SparseMatrix vertices = diagonal_matrix(Vector::Ones(complex.size(n - 1)));
    for (int k = n - 2; k >= 0; --k) {
        SparseMatrix faces = complex.incidences(k).real_matrix().cwiseAbs();
        for (const auto& [cell, face] : complex.canceled(k))
            faces.coeffRef(cell, face) = 1;
        vertices = SparseMatrix(vertices * faces);
    }
    vertices.coeffs().setOnes();
    const Vector counts = vertices * Vector::Ones(vertices.cols());
    return SparseMatrix(areas.cwiseQuotient(counts).asDiagonal() * vertices).transpose();
}

SparseMatrix of_own(const Cells& cells, int k, const Vector& of_facets) {
    if (k == cells.dimension() - 1)
        return diagonal_matrix(of_facets.cwiseQuotient(cells.stars().volumes().primal(k)));
    if (k > 0)
        throw InvalidInput(fmt::format("dual volumes of {}-cells within the boundary are unknown "
                                       "without a mesh; give a mesh",
                                       k),
                           {.degree = k});
    const Vector& areas = cells.stars().volumes().primal(cells.dimension() - 1);
    return diagonal_matrix(equal_shares(cells.complex(), areas) * of_facets);
}

} // namespace

SparseMatrix Cells::boundary_star(int k, const Vector& weights) const {
    const Vector of_facets = on_boundary(complex_, k, weights);
    if (!merged_)
        return of_own(*this, k, of_facets);
    const Vector of_pieces = pieces_of(*merged_, dimension() - 1).transpose() * of_facets;
    return stars()[k + 1].is_diagonal() ? by_duals(*merged_, k, of_pieces)
                                        : by_whitney_forms(*merged_, k, of_pieces);
}

} // namespace polydec
