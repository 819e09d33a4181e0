// SPDX-License-Identifier: MIT
#include "dec/stars/galerkin_mass.h"

#include "dec/metric/whitney.h"
#include "system/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace polydec {

namespace {

/// Number of pairs of k-cells below a common n-cell with several pieces: the lift to k-simplices
/// inside couples all of them.
double count_pairs(const Merging& merging, int k) {
    const CellComplex& complex = merging.merged();
    const int n = complex.dimension();
    const auto& pieces = merging.diamond(n);
    double pairs = 0;
    std::vector<Index> cells, faces;
    for (Index top = 0; k > 0 && top < complex.size(n); ++top) {
        if (pieces.outerIndexPtr()[top + 1] - pieces.outerIndexPtr()[top] < 2)
            continue;
        cells.assign(1, top);
        for (int j = n - 1; j >= k; --j) {
            faces.clear();
            for (const Index cell : cells)
                for (const SignedFace& face : complex.incidences(j)[cell])
                    faces.push_back(face.face);
            std::sort(faces.begin(), faces.end());
            faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
            cells.swap(faces);
        }
        pairs += std::pow(static_cast<double>(cells.size()), 2);
    }
    return pairs;
}

} // namespace

GalerkinMass::GalerkinMass(const MergedCells& cells)
    : cells_(cells.geometry().flat().empty() ? cells : cone_flat_cells(cells)) {}

SparseMatrix GalerkinMass::operator()(int k, const Vector& weights) const {
    Vector of_pieces(pieces().size(pieces().dimension()));
    for (Index t = 0; t < of_pieces.size(); ++t)
        of_pieces[t] = weights[cell(t)];
    return lifted(k, whitney_mass(pieces(), metric(), pieces().dimension(), k, of_pieces));
}

SparseMatrix GalerkinMass::lifted(int k, const SparseMatrix& of_pieces) const {
    // of the intermediate product, the result, its transpose and their sum
    constexpr double bytes_each = 5 * (sizeof(double) + sizeof(Index));
    const double entries = count_pairs(cells_.merging(), k);
    check_memory(bytes_each * entries,
                 fmt::format("Galerkin's star of {}-forms with {:.3g} entries", k, entries));
    const SparseMatrix& S = cells_.lift()[k];
    const SparseMatrix result = SparseMatrix(S.transpose()) * of_pieces * S;
    return 0.5 *
           (result + SparseMatrix(result.transpose())); // removes rounding across the diagonal
}

} // namespace polydec
