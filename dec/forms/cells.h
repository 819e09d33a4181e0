// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/shared.h"
#include "complex/cell_complex.h"
#include "dec/stars/star.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace polydec {

class MergedCells;

/// Oriented cells of degrees 0..n with a Hodge star for each degree: the argument of operators and
/// solvers. For a mesh use a Discretization; for cells of your own, {complex, stars}. An immutable
/// handle: copies share the data and cost nothing. Accessors of a temporary return copies.
class Cells {
public:
    /// Cells of your own, measured in some unit (see unit()). Throws InvalidInput, naming the
    /// degree, unless the sizes of the stars match the numbers of cells.
    Cells(const CellComplex& complex, const HodgeStars& stars, double unit = 1);

    const CellComplex& complex() const& { return complex_; }
    CellComplex complex() && { return complex_; }
    int dimension() const { return complex_.dimension(); }
    Index size(int k) const { return complex_.size(k); } ///< number of k-cells

    /// Volumes of the cells and of their duals: of a mesh those between its centers, by default
    /// circumcenters, whatever its stars; circumcentric stars without material are ratios of these.
    const CellVolumes& volumes() const& { return volumes_; }
    CellVolumes volumes() && { return volumes_; }

    /// The Hodge stars, and their kind. Stars of a mesh are computed on first use, once for all
    /// copies.
    const HodgeStars& stars() const& { return chosen_stars().stars; }
    HodgeStars stars() && { return stars(); }
    const ChosenStars& chosen_stars() const&;
    ChosenStars chosen_stars() && { return chosen_stars(); }

    /// Unit of volumes and stars, as a length of the input: 1, or a power of 4 if the input is so
    /// large or small that products of its lengths would overflow or underflow. Functions of cells,
    /// and solvers, take and return numbers in the units of the input.
    double unit() const { return unit_; }

    /// Volumes of the k-cells and of their duals in the units of the input. Throw InvalidInput,
    /// naming the degree, for overflow or underflow.
    const Vector& input_volumes(int k) const&;
    Vector input_volumes(int k) && { return input_volumes(k); }
    const Vector& input_dual_volumes(int k) const&;
    Vector input_dual_volumes(int k) && { return input_dual_volumes(k); }

    /// The star of k-cells without a material, in unit(): it maps the integrals of a smooth form's
    /// inverse star to the dual form that stands for the smooth form. Over duals (see
    /// ChosenStars::is_over_duals) it is the ratio of the volumes. A matrix of your own counts as
    /// one without a material.
    HodgeStar geometric_star(int k) const;

    /// The same with other stars, or with a matrix as the star of k-forms, in the units of the
    /// input. Products of dual forms and integrals over duals still use the volumes. Throws
    /// InvalidInput unless the sizes match, and like HodgeStar.
    Cells with_stars(const ChosenStars& chosen) const;
    Cells with_star(int k, const SparseMatrix& star) const;

    /// The star of k-cells within the boundary, 0 <= k < n. Each entry sums the parts of the cell's
    /// dual in the boundary facets, times the facets' weights, and divides by the cell's volume. If
    /// the star of (k+1)-cells is a matrix: inner products of the traces of Whitney forms. 0 off
    /// the boundary. size(k) x size(k); `weights` has one value per (n-1)-cell, and only boundary
    /// facets matter. Units length^(n-1-2k) times the weights' units, in unit(). With Robin
    /// coefficients it is Robin's term of a Laplacian; with ones, the inner product of traces.
    /// Throws InvalidInput for 0 < k < n-1 on cells of your own, for a wrong number of weights, and
    /// for weights that are not finite.
    SparseMatrix boundary_star(int k, const Vector& weights) const;

    /// Marks the (n-1)-cells on the boundary whose dual has length zero up to rounding (see
    /// HodgeStar::zeros). The dual is the half edge from the circumcenter of the adjacent n-cell;
    /// this center then lies on the boundary, as for a facet opposite a right angle, and a dual
    /// 0-form has its boundary value there. Size size(n-1); no marks where the star is a matrix.
    std::vector<bool> boundary_facets_without_dual() const;

    /// A k-cell for messages, "facet 17 (vertices 3, 8)", and for programs. On a mesh the vertices
    /// are listed by their numbers in the input.
    std::string name(int k, Index cell) const;
    Error::Place place(int k, Index cell) const;

protected:
    /// Cells of merged simplices; `stars` is called on first use.
    Cells(std::shared_ptr<const MergedCells> merged, std::function<ChosenStars()> stars,
          double unit);

    const MergedCells& merged_cells() const { return *merged_; }

private:
    CellComplex complex_;
    CellVolumes volumes_;
    Shared<const MergedCells> merged_; // null for cells of your own
    std::function<ChosenStars()> make_stars_;
    Shared<const Lazy<ChosenStars>> stars_;
    double unit_;
    /// Primal and dual volumes, by degree.
    using InputVolumes = std::vector<std::array<Lazy<Vector>, 2>>;
    Shared<const InputVolumes> input_volumes_{
        std::make_shared<InputVolumes>(complex_.dimension() + 1)};
};

/// The star of k-cells in the units of the input.
inline HodgeStar star(const Cells& cells, int k) {
    return cells.stars()[k].in_input_units(cells.unit());
}

} // namespace polydec
