// SPDX-License-Identifier: MIT
#include "dec/galerkin_mass.h"

#include "dec/merging/lift.h"
#include "dec/metric/circumcentric_volumes.h"
#include "dec/metric/whitney.h"

namespace polydec {

GalerkinMass::GalerkinMass(const Discretization& mesh) : mesh_(mesh) {
    std::vector<bool> flat(mesh.pieces().size(mesh.dimension()));
    for (std::size_t t = 0; t < flat.size(); ++t)
        flat[t] = mesh.is_flat(static_cast<Index>(t));
    if (std::find(flat.begin(), flat.end(), true) == flat.end())
        return;
    coned_ = cone_flat_cells(mesh.merging(), *mesh.metric().points(), flat);
    const auto volumes = dual_volumes(pieces(), metric(), Centers::centroids());
    lift_ = commuting_lift(merging(), metric(), volumes);
}

SparseMatrix GalerkinMass::operator()(int k, const Vector& weights) const {
    Vector of_pieces(pieces().size(pieces().dimension()));
    for (Index t = 0; t < of_pieces.size(); ++t)
        of_pieces[t] = weights[cell(t)];
    return lifted(k, whitney_mass(pieces(), metric(), k, of_pieces));
}

SparseMatrix GalerkinMass::lifted(int k, const SparseMatrix& of_pieces) const {
    const SparseMatrix& S = coned_ ? lift_[k] : mesh_.lift()[k];
    const SparseMatrix result = SparseMatrix(S.transpose()) * of_pieces * S;
    return 0.5 *
           (result + SparseMatrix(result.transpose())); // without rounding across the diagonal
}

} // namespace polydec
