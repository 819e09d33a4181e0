// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "complex/cell_complex.h"
#include "dec/forms/star_kind.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace polydec {

class MergedCells;

/// Oriented cells of degrees 0..n with a Hodge star for each degree: what operators and solvers
/// take. Those of a mesh are a Discretization; cells of your own are {complex, stars}. A handle on
/// what never changes: copies share it and cost nothing. Accessors of a temporary return copies.
class Cells {
public:
    /// Cells of your own, measured in some unit (see unit()). Throws InvalidInput, naming the
    /// degree, unless there are as many entries of stars as cells.
    Cells(const CellComplex& complex, const HodgeStars& stars, double unit = 1);

    // no moves, which would leave a handle on nothing
    Cells(const Cells&) = default;
    Cells& operator=(const Cells&) = default;

    const CellComplex& complex() const& { return complex_; }
    CellComplex complex() && { return complex_; }
    int dimension() const { return complex_.dimension(); }
    Index size(int k) const { return complex_.size(k); } ///< how many k-cells there are

    /// Of the cells; diagonal stars of your own are made of them.
    const CellVolumes& volumes() const& { return volumes_; }
    CellVolumes volumes() && { return volumes_; }

    /// The Hodge stars, and of which kind they are: those of a mesh are made when they are first
    /// asked for, once for all copies.
    const HodgeStars& stars() const& { return chosen_stars().stars; }
    HodgeStars stars() && { return stars(); }
    const ChosenStars& chosen_stars() const&;
    ChosenStars chosen_stars() && { return chosen_stars(); }

    /// What volumes and stars are measured in, as a length of the input: 1, or a power of 4 where
    /// the input of a mesh is so large or small that products of its lengths would be no numbers.
    /// Functions of cells, and solvers, take and give numbers in the units of the input.
    double unit() const { return unit_; }

    /// The stars in the units of the input. Throws InvalidInput, naming the degree, for numbers out
    /// of range.
    const HodgeStars& input_stars() const;

    /// The same with other stars, or with a matrix, in the units of the input, as that of k-forms.
    /// Products of dual forms and integrals over duals stay those of the volumes. Throws
    /// InvalidInput unless they fit, and like HodgeStar.
    Cells with_stars(const ChosenStars& chosen) const;
    Cells with_star(int k, const SparseMatrix& star) const;

    /// The star of k-cells within the boundary, 0 <= k < n: for each the volume of the part of its
    /// dual that lies there over its own, the part in each facet times the facet's weight; where
    /// the star of (k+1)-cells is a matrix, the inner products of the traces of Whitney forms. 0
    /// off the boundary. size(k) x size(k); weights has one value for each (n-1)-cell, and only
    /// those of the boundary matter. Units length^(n-1-2k) times those of the weights, in unit().
    /// With the coefficients of Robin's condition it is what that adds to a Laplacian; with ones
    /// the inner product of traces. 0 < k < n-1 throws InvalidInput for cells of your own; so do
    /// other numbers of weights.
    SparseMatrix boundary_star(int k, const Vector& weights) const;

    /// What each vertex has of the areas of the (n-1)-cells, which their duals divide among their
    /// vertices, equally for finite elements and for cells of your own. size(0) x size(n-1), in
    /// unit().
    SparseMatrix shares_of_vertices() const;

    /// Marks the (n-1)-cells on the boundary whose dual, the half of an edge from the circumcenter
    /// of the one n-cell beside them, has no length but for rounding (see HodgeStar::zeros): the
    /// center lies on the boundary, as that of a right angle opposite to it. A dual 0-form has its
    /// boundary value there. Size size(n-1); none where the star is a matrix.
    std::vector<bool> boundary_facets_without_dual() const;

    /// A k-cell for messages, "facet 17 (vertices 3, 8)", and for programs; the vertices are those
    /// of a mesh, by the numbers of the input.
    std::string name(int k, Index cell) const;
    Error::Place place(int k, Index cell) const;

protected:
    /// Of what they were made, with stars that are made when they are asked for.
    Cells(std::shared_ptr<const MergedCells> merged, std::function<ChosenStars()> stars,
          double unit);

    const MergedCells& merged_cells() const { return *merged_; }

private:
    CellComplex complex_;
    CellVolumes volumes_;
    std::shared_ptr<const MergedCells> merged_; // null for cells of one's own
    std::function<ChosenStars()> make_stars_;
    std::shared_ptr<const Lazy<ChosenStars>> stars_;
    std::shared_ptr<const Lazy<HodgeStars>> input_stars_;
    double unit_;
};

/// The star of k-cells in the units of the input.
inline HodgeStar star(const Cells& cells, int k) {
    return cells.input_stars()[k];
}

} // namespace polydec
