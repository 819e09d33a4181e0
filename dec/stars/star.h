// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "base/shared.h"
#include "base/types.h"
#include "dec/metric/cell_volumes.h"

#include <string>
#include <vector>

namespace polydec {

/// Hodge star on primal k-forms, to dual (n-k)-forms: diagonal, dual volume over primal volume of
/// each k-cell, or a symmetric positive definite matrix, as in finite elements. Units
/// length^(n-2k). A diagonal is positive iff every dual volume is. A handle: copies cost nothing.
/// Source: Hirani 2003, Def. 4.1.1.
class HodgeStar {
public:
    /// The diagonal star. Throws InvalidInput for a degree outside 0..n.
    HodgeStar(const CellVolumes& volumes, int k);

    /// A matrix in its place, size(k) x size(k), with finite entries and symmetric up to rounding
    /// errors, which are removed. Whether it is positive definite is checked by the first solve.
    /// Throws InvalidInput, naming the shape or the entry.
    HodgeStar(const CellVolumes& volumes, int k, SparseMatrix matrix);

    /// The same measured in this unit of length, a power of 4: it takes and returns numbers in the
    /// units of the input (see Cells::unit). Copies share one factorization. Functions throw
    /// InvalidInput, naming the degree, if what they return overflows or underflows.
    HodgeStar in_input_units(double unit) const;

    /// Dimension n and degree k.
    int dimension() const { return volumes_.dimension(); }
    int degree() const { return degree_; }
    Index size() const { return volumes_.size(degree_); }

    /// Whether it is diagonal; its diagonal |*s| / |s|, size() entries. Throw InvalidInput if not.
    bool is_diagonal() const { return matrix_ == nullptr; }
    void require_diagonal() const;
    Vector diagonal() const;

    SparseMatrix matrix() const;

    /// Applies the star. Throws InvalidInput unless there are size() values.
    Vector operator*(const Vector& values) const;

    /// Applies the inverse star. A matrix is factorized once, for all copies. Throws InvalidInput
    /// unless there are size() values and for a matrix with negative eigenvalues; a diagonal star
    /// throws like inverse.
    Vector solve(const Vector& values) const;

    /// The diagonal of the inverse, |s| / |*s|. Throws InvalidInput like diagonal, and, naming the
    /// cells, if an entry is zero.
    Vector inverse() const;

    /// Bound on the rounding error of each entry of the diagonal (see CellVolumes::rounding).
    /// Throws InvalidInput for a matrix.
    Vector uncertainty() const;

    /// The cells whose entry counts as zero: the dual volume does not exceed the rounding error of
    /// the terms that cancel in it (CellVolumes::terms, is_zero). Independent of other cells and of
    /// scale. A matrix has no zeros and no negatives.
    std::vector<Index> zeros() const;

    /// The cells whose entry is negative and not zero in the sense of zeros().
    std::vector<Index> negatives() const;

    /// The first five of some cells for messages, "3, 7, 8, 10, 12, ..", and all of them for
    /// programs, by CellVolumes::number.
    std::string numbers(const std::vector<Index>& cells) const;
    Error::Place place(const std::vector<Index>& cells) const;

private:
    struct Matrix;

    void check(const Vector& values) const;
    std::string name() const;
    Vector measured_inverse() const;
    Vector entries(Vector measured, int power) const;
    Vector form(Vector measured, int power) const;
    template <class Is>
    std::vector<Index> cells_whose_dual(Is is) const;

    CellVolumes volumes_;
    int degree_;
    Shared<Matrix> matrix_; // none: diagonal
    double unit_ = 1;       // of volumes and matrix
};

/// Throws the InvalidInput of HodgeStar::inverse for these cells, by CellVolumes::number.
[[noreturn]] void refuse_inverse(int k, std::vector<Index> cells);

/// The stars of all degrees. Volumes convert implicitly to the diagonal stars made from them.
class HodgeStars {
public:
    HodgeStars(const CellVolumes& volumes) : volumes_(volumes) {}

    /// Dimension n; -1 without cells.
    int dimension() const { return volumes_.dimension(); }

    /// The star of k-cells. Throws InvalidInput for a degree outside 0..n.
    HodgeStar operator[](int k) const;

    /// The same with a matrix as the star of k-cells. Throws like HodgeStar.
    HodgeStars with(int k, SparseMatrix matrix) const;

    /// Primal volumes, and dual ones for which diagonal stars are the ratios: volumes of duals, or
    /// with a material their parts in the n-cells, each times its weight.
    const CellVolumes& volumes() const& { return volumes_; }
    CellVolumes volumes() && { return volumes(); }

private:
    CellVolumes volumes_;
    std::vector<HodgeStar> matrices_; // those that are no diagonal, in any order
};

/// The star of k-cells, as an operator. Throws InvalidInput if there is no such degree.
inline HodgeStar star(const HodgeStars& stars, int k) {
    return stars[k];
}

/// Throws InvalidInput, naming the degree, unless the sizes of stars match the numbers of cells,
/// and the diagonals of matrices are positive.
void check_fit(const CellComplex& complex, const HodgeStars& stars);

/// Kinds of Hodge stars. On flat cells, inner products of constant forms are exact in every degree
/// for galerkin and hybrid stars, and in degrees 0 and n for all other stars.
enum class StarKind {
    circumcentric, ///< dual over primal volume: diagonal, but not positive on every mesh
    galerkin,      ///< inner products of Whitney forms, on merged cells by the lift: positive
                   ///< definite on every mesh; diagonal only for k = n
    hybrid,        ///< n = 2: galerkin on the cells beside edges whose dual is not positive and on
                   ///< as many around them as make it definite, circumcentric on all others
    barycentric,   ///< diagonal and positive, duals between centroids. Inconsistent for 0 < k < n:
                   ///< linear functions have no exact fluxes, which need not converge
    automatic,     ///< circumcentric if every dual is positive; else hybrid for n = 2, and for all
                   ///< other n galerkin for 0 < k < n and barycentric for k = 0
    own            ///< supplied by the user; cannot be selected
};

/// "circumcentric", "galerkin" ..
const char* name(StarKind kind);

/// Whether no star has a zero or a negative entry.
bool all_positive(const HodgeStars& stars);

/// The kind that automatic selects.
StarKind automatic_kind(int dimension, bool every_dual_is_positive);

struct ChosenStars {
    HodgeStars stars;
    StarKind kind; ///< the kind selected, never automatic
    /// For each n-cell, whether it has Galerkin's stars: then a dual 0-form has its value at the
    /// centroid, else at the circumcenter.
    std::vector<bool> galerkin;
    /// The stars without the materials that stars have (see Cells::geometric_star).
    HodgeStars geometric;

    /// Without Galerkin cells if no marks are given.
    ChosenStars(const HodgeStars& stars, StarKind kind = StarKind::own,
                std::vector<bool> galerkin = {});

    /// Whether the star of k-cells uses the circumcentric duals of the volumes, so that dual forms
    /// are integrals over these duals. If not, dual forms are stars of primal forms.
    bool is_over_duals(int k) const;

    /// Fraction of n-cells with Galerkin's stars, 0 to 1.
    double galerkin_share() const;
};

} // namespace polydec
