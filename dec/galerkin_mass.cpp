// SPDX-License-Identifier: MIT
#include "dec/galerkin_mass.h"

#include "dec/metric/whitney.h"

namespace polydec {

SparseMatrix lifted(const Discretization& mesh, int k, const SparseMatrix& of_pieces) {
    const SparseMatrix& S = mesh.lift()[k];
    const SparseMatrix result = SparseMatrix(S.transpose()) * of_pieces * S;
    return 0.5 *
           (result + SparseMatrix(result.transpose())); // without rounding across the diagonal
}

SparseMatrix galerkin_mass(const Discretization& mesh, int k, const Vector& weights) {
    const auto& carriers = mesh.merging().carriers(mesh.dimension());
    Vector of_pieces(carriers.size());
    for (std::size_t t = 0; t < carriers.size(); ++t)
        of_pieces[static_cast<Index>(t)] =
            mesh.is_flat(static_cast<Index>(t)) ? 0 : weights[carriers[t].cell];
    return lifted(mesh, k, whitney_mass(mesh.pieces(), mesh.metric(), k, of_pieces));
}

} // namespace polydec
