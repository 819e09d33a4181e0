// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <string>
#include <vector>

namespace polydec {

/// What helps against negative duals and against those without volume: an option of discretize.
enum class Remedy {
    none,
    flips,  ///< Delaunay::flips: of edges between two triangles
    splits, ///< Delaunay::flips_and_splits: of boundary edges too
    stars,  ///< StarKind::automatic: stars that are positive whatever the duals are
};

/// The option by its name in C++: "DiscretizeOptions::delaunay"; empty for none.
const char* option(Remedy remedy);

/// The options with the remedy taken. With flips go neither the test of opposite angles, nor
/// materials kept apart, nor other centers: they are as by default then.
DiscretizeOptions with(Remedy remedy, DiscretizeOptions options);

/// What makes every dual positive, or else stars, of a mesh with duals that are not: the first of
/// flips and splits that does, on a surface with two triangles at an edge at most, tried on it;
/// stars where none does. `lengths` are those of the input's edges. Time of flips.
Remedy remedy(const SimplicialComplex& input, const Vector& lengths,
              const DiscretizeOptions& options);

/// The same of a mesh with circumcentric stars, and but for stars of one with hybrid ones. None
/// where all duals are positive, for hybrid stars where none is negative (those without volume do
/// no harm then), or where stars or centers are chosen otherwise.
Remedy remedy(const Discretization& mesh);

/// Cells of one degree with a dual that is not positive, and what helps.
struct Advice {
    int degree = 0;
    Index cells = 0;
    bool negative = true;     ///< or else without volume
    bool on_boundary = false; ///< facets of the boundary alone, which cannot flip
    Remedy remedy = Remedy::none;
};

/// "3 negative dual edges on the boundary: add Delaunay::flips_and_splits".
std::string in_words(const Advice& advice, int dimension);

/// On the negative duals of the highest degree that has some, which below n - 1 follow from those
/// of facets on surfaces; where there are none, on those without volume, against which there are
/// stars. Empty if all duals are positive, or stars or centers are chosen otherwise. A mesh
/// discretized again with the remedy (see with) needs no further advice.
std::vector<Advice> advice(const Discretization& discretization);

/// "; add Delaunay::flips" where that helps against negative duals, else empty.
std::string flip_advice(const Discretization& mesh);

/// Adds a warning if the stars that the options ask for are hybrid ones, for negative duals that
/// can be made positive. `lengths` are those of the input's edges, `volumes` those of the cells.
void warn_of_hybrid_stars(const SimplicialComplex& input, const Vector& lengths,
                          const CellVolumes& volumes, const DiscretizeOptions& options,
                          std::vector<std::string>& warnings);

/// A warning if the star of k-cells has negative entries, and what follows from them in words.
std::vector<std::string> warning_of_negative_duals(const Cells& cells, int k,
                                                   std::string_view consequence);

/// "stars that are positive on every mesh (StarKind::automatic)", and what else there is: for
/// refusals of what knows volumes alone.
std::string positive_stars(int dimension);

} // namespace polydec
