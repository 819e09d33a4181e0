// SPDX-License-Identifier: MIT
#include "dec/boundary_star.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/metric/dual_parts.h"

#include <fmt/format.h>

namespace polydec {

namespace {

/// The weights of the facets of the boundary, 0 at others.
Vector on_boundary(const CellComplex& complex, int k, const Vector& weights) {
    const int n = complex.dimension();
    check_number("the star within the boundary of degree", k, 0, n - 1);
    check_as_many("weights of facets", weights.size(), complex.size(n - 1));
    Vector result = weights;
    for (Index f = 0; f < result.size(); ++f)
        if (complex.coface_counts(n - 1)[f] != 1)
            result[f] = 0;
    return result;
}

} // namespace

Vector boundary_star(const Discretization& mesh, int k, const Vector& weights) {
    const int n = mesh.dimension();
    const Vector of_facets = on_boundary(mesh.complex(), k, weights);
    const auto pieces_of = [&](int j) -> SparseMatrix {
        return mesh.merging().diamond(j).cast<double>().cwiseAbs();
    };
    const SparseMatrix parts =
        dual_parts(mesh.pieces(), mesh.metric(), mesh.piece_volumes(), k, n - 1, mesh.centers());
    const Vector of_pieces = pieces_of(n - 1).transpose() * of_facets;
    const Vector duals = parts.transpose() * of_pieces;
    const Vector& volumes = mesh.volumes().primal(k);
    return (pieces_of(k) * mesh.piece_volumes().primal(k).cwiseProduct(duals))
        .cwiseQuotient(volumes)
        .cwiseQuotient(volumes);
}

Vector boundary_star(const CellComplex& complex, const CellVolumes& volumes, int k,
                     const Vector& weights) {
    const Vector of_facets = on_boundary(complex, k, weights);
    if (k != complex.dimension() - 1)
        throw InvalidInput(fmt::format("the duals within the boundary of {}-cells of one's own are "
                                       "not known; give a mesh",
                                       k),
                           {.degree = k});
    return of_facets.cwiseQuotient(volumes.primal(k));
}

} // namespace polydec
