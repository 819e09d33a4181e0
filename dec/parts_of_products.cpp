// SPDX-License-Identifier: MIT
#include "dec/parts_of_products.h"

#include "dec/metric/dual_parts.h"

namespace polydec {

SparseMatrix parts_of_products(const Discretization& mesh, int k, const Centers& centers) {
    const int n = mesh.dimension();
    const SparseMatrix parts =
        dual_parts(mesh.pieces(), mesh.metric(), mesh.piece_volumes(), k, n, centers);
    const SparseMatrix cells = mesh.merging().diamond(n).cast<double>().cwiseAbs();
    const SparseMatrix faces = mesh.merging().diamond(k).cast<double>().cwiseAbs();
    return cells * parts * mesh.piece_volumes().primal(k).asDiagonal() *
           SparseMatrix(faces.transpose());
}

} // namespace polydec
