// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "base/types.h"
#include "dec/metric/cell_volumes.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

/// Hodge star on primal k-forms, to dual (n-k)-forms: diagonal, dual volume over primal volume of
/// each k-cell, or a symmetric positive definite matrix, as that of finite elements. Units
/// length^(n-2k). A diagonal is positive iff every dual volume is. A handle: copies cost nothing.
/// Source: Hirani 2003, Def. 4.1.1.
class HodgeStar {
public:
    /// The diagonal star. Throws InvalidInput for another degree than 0..n.
    HodgeStar(const CellVolumes& volumes, int k);

    /// A matrix in its place, whose entries must be finite and symmetric but for rounding, which is
    /// taken out of it: size(k) x size(k); that it is positive definite is seen when it is first
    /// solved with. Throws InvalidInput, naming the shape or the entry.
    HodgeStar(const CellVolumes& volumes, int k, SparseMatrix matrix);

    /// n and k.
    int dimension() const { return volumes_.dimension(); }
    int degree() const { return degree_; }
    Index size() const { return volumes_.size(degree_); }

    /// Whether it is diagonal: |*s| / |s|, size() entries. Throw InvalidInput if it is a matrix.
    bool is_diagonal() const { return matrix_ == nullptr; }
    void require_diagonal() const;
    Vector diagonal() const;

    SparseMatrix matrix() const;

    /// What the star makes of values. Throws InvalidInput unless there are size() of them.
    Vector operator*(const Vector& values) const;

    /// The values of which it makes these. A matrix is factorized once, for all copies. Throws
    /// likewise; like inverse if it is diagonal; InvalidInput for a matrix with negative
    /// eigenvalues.
    Vector solve(const Vector& values) const;

    /// The diagonal of the inverse, |s| / |*s|. Throws InvalidInput like diagonal, and, naming the
    /// cells, if the star of one is zero.
    Vector inverse() const;

    /// How far off each entry of the diagonal may be by what computing has done to it (see
    /// CellVolumes::rounding). Throws InvalidInput if it is a matrix.
    Vector uncertainty() const;

    /// The cells whose entry counts as zero: whose dual volume is no larger than the rounding error
    /// of what cancels in it (CellVolumes::terms, is_zero). Neither other cells nor scale matter. A
    /// matrix has none, nor negative ones.
    std::vector<Index> zeros() const;

    /// The cells whose entry is negative and not zero in the above sense.
    std::vector<Index> negatives() const;

    /// The first five of some cells for messages, "3, 7, 8, 10, 12, ..", and all of them for
    /// programs: by CellVolumes::number.
    std::string numbers(const std::vector<Index>& cells) const;
    Error::Place place(const std::vector<Index>& cells) const;

private:
    struct Matrix;

    void check(const Vector& values) const;

    CellVolumes volumes_;
    int degree_;
    std::shared_ptr<Matrix> matrix_; // none: diagonal
};

/// The stars of all degrees. Volumes are the stars that they make, wherever these are expected.
class HodgeStars {
public:
    HodgeStars(const CellVolumes& volumes) : volumes_(volumes) {}

    /// Dimension n; -1 without cells.
    int dimension() const { return volumes_.dimension(); }

    /// That of k-cells. Throws InvalidInput for another degree than 0..n.
    HodgeStar operator[](int k) const;

    /// The same with a matrix as the star of k-cells. Throws like HodgeStar.
    HodgeStars with(int k, SparseMatrix matrix) const;

    /// The volumes of the cells; diagonal stars are made of them.
    const CellVolumes& volumes() const { return volumes_; }

private:
    CellVolumes volumes_;
    std::vector<HodgeStar> matrices_; // those that are no diagonal, in any order
};

/// The star of k-cells, as an operator. Throws InvalidInput if there is no such degree.
inline HodgeStar star(const HodgeStars& stars, int k) {
    return stars[k];
}

/// Throws InvalidInput, naming the degree, unless the stars are those of as many cells.
inline void check_fit(const CellComplex& complex, const HodgeStars& stars) {
    check_fit(complex, stars.volumes());
}

} // namespace polydec
