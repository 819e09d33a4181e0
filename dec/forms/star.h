// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "base/types.h"
#include "dec/metric/cell_volumes.h"

#include <string>
#include <vector>

namespace polydec {

/// Hodge star on primal k-forms, to dual (n-k)-forms: diagonal, dual volume over primal volume of
/// each k-cell. Units length^(n-2k); positive iff every dual volume is. A handle on the volumes:
/// copies cost nothing.
/// Source: Hirani 2003, Def. 4.1.1.
class HodgeStar {
public:
    /// Throws InvalidInput for another degree than 0..n.
    HodgeStar(const CellVolumes& volumes, int k);

    /// n and k.
    int dimension() const { return volumes_.dimension(); }
    int degree() const { return degree_; }
    Index size() const { return static_cast<Index>(volumes_.primal(degree_).size()); }

    /// |*s| / |s|, size() entries; and as a matrix.
    Vector diagonal() const;
    SparseMatrix matrix() const;

    /// What the star makes of values. Throws InvalidInput unless there are size() of them.
    Vector operator*(const Vector& values) const;

    /// The values of which it makes these. Throws likewise, and like inverse.
    Vector solve(const Vector& values) const;

    /// The diagonal of the inverse, |s| / |*s|. Throws InvalidInput, naming the cells, if the star
    /// of one is zero.
    Vector inverse() const;

    /// How far off each entry of the diagonal may be by what computing has done to it (see
    /// CellVolumes::rounding).
    Vector uncertainty() const;

    /// The cells whose entry counts as zero: whose dual volume is no larger than the rounding error
    /// of what cancels in it (CellVolumes::terms, is_zero). Neither other cells nor scale matter.
    std::vector<Index> zeros() const;

    /// The cells whose entry is negative and not zero in the above sense.
    std::vector<Index> negatives() const;

    /// The first five of some cells for messages, "3, 7, 8, 10, 12, ..", and all of them for
    /// programs: by CellVolumes::number.
    std::string numbers(const std::vector<Index>& cells) const;
    Error::Place place(const std::vector<Index>& cells) const;

private:
    void check(const Vector& values) const;

    CellVolumes volumes_;
    int degree_;
};

/// The stars of all degrees. Volumes are the stars that they make, wherever these are expected.
class HodgeStars {
public:
    HodgeStars(const CellVolumes& volumes) : volumes_(volumes) {}

    /// Dimension n; -1 without cells.
    int dimension() const { return volumes_.dimension(); }

    /// That of k-cells. Throws InvalidInput for another degree than 0..n.
    HodgeStar operator[](int k) const { return {volumes_, k}; }

    /// What they are made of.
    const CellVolumes& volumes() const { return volumes_; }

private:
    CellVolumes volumes_;
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
