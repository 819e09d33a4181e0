// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "dec/stars/star.h"
#include "distributed/petsc_calls.h"

#include <algorithm>

namespace polydec {

namespace {

/// d_k^T, whose rows are known where the k-cells are.
OwnedMat transposed_coboundary(const Ranks& ranks, const DistributedCells& cells, int k) {
    check_number("a derivative from degree", k, 0, cells.dimension() - 1);
    const auto &lower = cells.degree(k), &upper = cells.degree(k + 1);
    struct Rows {
        std::vector<PetscInt> begins, columns;
        std::vector<double> signs;
    };
    const Rows rows = ranks.together("derivative", [&] {
        Rows made_rows;
        petsc_number(lower.count);
        petsc_number(upper.count);
        for (const Index begin : lower.begins)
            made_rows.begins.push_back(begin);
        for (const Index cell : lower.cofaces)
            made_rows.columns.push_back(petsc_number(upper.cell(cell).row));
        made_rows.signs.assign(lower.signs.begin(), lower.signs.end());
        return made_rows;
    });
    return made("taking over a derivative", [&](Mat* matrix) {
        return MatCreateMPIAIJWithArrays(
            communicator(ranks), static_cast<PetscInt>(lower.first.size()),
            static_cast<PetscInt>(upper.first.size()), static_cast<PetscInt>(lower.count),
            static_cast<PetscInt>(upper.count), rows.begins.data(), rows.columns.data(),
            rows.signs.data(), matrix);
    });
}

/// Own entries; errors tell of the cells of all ranks.
Vector inverse_star(const Ranks& ranks, const DistributedCells& cells, int k) {
    const HodgeStar star(cells.volumes, k);
    auto zeros = ranks.of_all(cells.volumes.numbers(k, star.zeros()));
    std::sort(zeros.begin(), zeros.end());
    if (!zeros.empty())
        refuse_inverse(k, std::move(zeros));
    return ranks.together("inverse star", [&] { return star.inverse(); });
}

/// left diag(weights) right.
OwnedMat scaled_product(OwnedMat left, Vec weights, Mat right) {
    require(MatDiagonalScale(left.get(), nullptr, weights), "scaling");
    return multiplied(left.get(), right);
}

/// Weights on both sides of both halves of a Laplacian; null stands for 1.
struct LaplacianWeights {
    Vec upper_left, upper_right, lower_left, lower_right;
};

/// d_k^T star_(k+1) d_k and d_(k-1) star_(k-1)^-1 d_(k-1)^T, with these weights, added.
OwnedMat weighted_sum(const Ranks& ranks, const DistributedCells& cells, int k,
                      const LaplacianWeights& weights) {
    OwnedMat sum;
    if (k < cells.dimension()) {
        sum = gram_of_columns(ranks, cells, k, ranks.together("star", [&] {
            return HodgeStar(cells.volumes, k + 1).diagonal();
        }));
        require(MatDiagonalScale(sum.get(), weights.upper_left, weights.upper_right), "scaling");
    }
    if (k > 0) {
        OwnedMat lower = gram_of_rows(ranks, cells, k - 1, inverse_star(ranks, cells, k - 1));
        require(MatDiagonalScale(lower.get(), weights.lower_left, weights.lower_right), "scaling");
        if (!sum)
            return lower;
        require(MatAXPY(sum.get(), 1, lower.get(), DIFFERENT_NONZERO_PATTERN), "adding");
    }
    return sum;
}

} // namespace

OwnedMat gram_of_columns(const Ranks& ranks, const DistributedCells& cells, int k,
                         const Vector& weights) {
    const OwnedMat B = transposed_coboundary(ranks, cells, k);
    return scaled_product(copied(B.get()), vector_of(ranks, weights).get(),
                          transposed(B.get()).get());
}

OwnedMat gram_of_rows(const Ranks& ranks, const DistributedCells& cells, int k,
                      const Vector& weights) {
    const OwnedMat B = transposed_coboundary(ranks, cells, k);
    return scaled_product(transposed(B.get()), vector_of(ranks, weights).get(), B.get());
}

OwnedMat coboundary(const Ranks& ranks, const DistributedCells& cells, int k) {
    return transposed(transposed_coboundary(ranks, cells, k).get());
}

OwnedVec star(const Ranks& ranks, const DistributedCells& cells, int k) {
    check_number("a star of degree", k, 0, cells.dimension());
    return vector_of(
        ranks, ranks.together("star", [&] { return HodgeStar(cells.volumes, k).diagonal(); }));
}

OwnedMat laplacian(const Ranks& ranks, const DistributedCells& cells, Side side, int degree) {
    const int n = cells.dimension();
    check_number("a Laplacian of degree", degree, 0, n);
    const int k = side == Side::primal ? degree : n - degree;
    const OwnedVec stars = star(ranks, cells, k);
    const OwnedVec inverse = k < n ? vector_of(ranks, inverse_star(ranks, cells, k)) : OwnedVec();
    return side == Side::primal
               ? weighted_sum(ranks, cells, k, {inverse.get(), nullptr, nullptr, stars.get()})
               : weighted_sum(ranks, cells, k, {nullptr, inverse.get(), stars.get(), nullptr});
}

OwnedMat symmetric_laplacian(const Ranks& ranks, const DistributedCells& cells, int k) {
    check_number("a Laplacian of degree", k, 0, cells.dimension());
    const OwnedVec stars = star(ranks, cells, k);
    return weighted_sum(ranks, cells, k, {nullptr, nullptr, stars.get(), stars.get()});
}

} // namespace polydec
