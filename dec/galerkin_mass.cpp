// SPDX-License-Identifier: MIT
#include "dec/galerkin_mass.h"

#include "base/memory.h"
#include "dec/merging/lift.h"
#include "dec/metric/circumcentric_volumes.h"
#include "dec/metric/whitney.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

namespace {

/// In a cell of many faces each is coupled to each other: throws where their star needs more memory
/// than there may be.
void check_couplings(const CellComplex& P, int k) {
    constexpr double bytes = 3 * (sizeof(double) + sizeof(Index)); // with what it is made of
    constexpr std::size_t many = 100;
    const int n = P.dimension();
    double entries = 0;
    std::vector<Index> faces, above;
    for (Index cell = 0; cell < P.size(n); ++cell) {
        faces.assign(1, cell);
        for (int j = n - 1; j >= k && (j == n - 1 || faces.size() > many); --j) {
            above = std::exchange(faces, {});
            for (const Index face : above)
                for (const SignedFace& lower : P.incidences(j)[face])
                    faces.push_back(lower.face);
            std::sort(faces.begin(), faces.end());
            faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        }
        entries += faces.size() > many ? std::pow(static_cast<double>(faces.size()), 2) : 0;
    }
    check_memory(bytes * entries, fmt::format("Galerkin's star of {}-cells, of which some {}-cells "
                                              "have hundreds,",
                                              k, n));
}

} // namespace

SparseMatrix GalerkinMass::lifted(int k, const SparseMatrix& of_pieces) const {
    check_couplings(mesh_.complex(), k);
    const SparseMatrix& S = coned_ ? lift_[k] : mesh_.lift()[k];
    const SparseMatrix result = SparseMatrix(S.transpose()) * of_pieces * S;
    return 0.5 *
           (result + SparseMatrix(result.transpose())); // without rounding across the diagonal
}

} // namespace polydec
