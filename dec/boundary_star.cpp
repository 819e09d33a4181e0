// SPDX-License-Identifier: MIT
#include "dec/boundary_star.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/whitney.h"

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

SparseMatrix pieces_of(const Discretization& mesh, int k) {
    return mesh.merging().diamond(k).cast<double>().cwiseAbs();
}

Vector by_duals(const Discretization& mesh, int k, const Vector& of_pieces) {
    const SparseMatrix parts =
        dual_parts(mesh.geometry(), mesh.geometry().centers(), k, mesh.dimension() - 1);
    const Vector duals = parts.transpose() * of_pieces;
    const Vector& volumes = mesh.volumes().primal(k);
    return (pieces_of(mesh, k) * mesh.geometry().volumes().primal(k).cwiseProduct(duals))
        .cwiseQuotient(volumes)
        .cwiseQuotient(volumes);
}

SparseMatrix by_whitney_forms(const Discretization& mesh, int k, const Vector& of_pieces) {
    const Pieces& K = mesh.pieces();
    const int m = mesh.dimension() - 1;
    SimplexFaces faces(K, m, k);
    SimplexLayout layout(K, mesh.geometry().metric());
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index f = 0; f < K.size(m); ++f) {
        if (of_pieces[f] == 0)
            continue;
        const Corners corners = layout.at(m, f);
        const DenseMatrix mass = whitney_mass(corners.points, corners.vertices, k);
        const auto& list = faces.of(f);
        for (Index a = 0; a < mass.rows(); ++a)
            for (Index b = 0; b < mass.cols(); ++b)
                entries.emplace_back(list[a], list[b], of_pieces[f] * mass(a, b));
    }
    SparseMatrix W(K.size(k), K.size(k));
    W.setFromTriplets(entries.begin(), entries.end());
    const SparseMatrix& S = mesh.merged().lift()[k];
    return S.transpose() * W * S;
}

} // namespace

SparseMatrix boundary_star(const Discretization& mesh, int k, const Vector& weights) {
    const int n = mesh.dimension();
    const Vector of_facets = on_boundary(mesh.complex(), k, weights);
    const Vector of_pieces = pieces_of(mesh, n - 1).transpose() * of_facets;
    if (mesh.stars()[k + 1].is_diagonal())
        return SparseMatrix(by_duals(mesh, k, of_pieces).asDiagonal());
    return by_whitney_forms(mesh, k, of_pieces);
}

SparseMatrix boundary_star(const CellComplex& complex, const CellVolumes& volumes, int k,
                           const Vector& weights) {
    const Vector of_facets = on_boundary(complex, k, weights);
    if (k != complex.dimension() - 1)
        throw InvalidInput(fmt::format("the duals within the boundary of {}-cells of one's own are "
                                       "not known; give a mesh",
                                       k),
                           {.degree = k});
    return SparseMatrix(of_facets.cwiseQuotient(volumes.primal(k)).asDiagonal());
}

} // namespace polydec
