// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <string>
#include <vector>

namespace polydec {

/// What makes negative duals positive: an option of discretize.
enum class Remedy {
    none,
    flips,     ///< Delaunay::flips: of edges between two triangles
    splits,    ///< Delaunay::flips_and_splits: of boundary edges too
    centroids, ///< Centers::centroids(): on every mesh, but less exact everywhere
};

/// The option by its name in C++: "DiscretizeOptions::delaunay"; empty for none.
const char* option(Remedy remedy);

/// The options with the remedy taken. With flips go neither the test of opposite angles, nor
/// materials kept apart, nor other centers: they are as by default then.
DiscretizeOptions with(Remedy remedy, DiscretizeOptions options);

/// The first remedy that is not taken yet: flips, then splits, for a surface with two triangles at
/// an edge at most; centroids for other meshes. None where all is taken.
Remedy remedy(const Discretization& discretization);

/// Cells of one degree with a negative dual, and what makes those positive.
struct Advice {
    int degree = 0;
    Index cells = 0;
    bool on_boundary = false; ///< facets of the boundary alone, which cannot flip
    Remedy remedy = Remedy::none;
};

/// "3 negative dual edges on the boundary: add Delaunay::flips_and_splits".
std::string in_words(const Advice& advice, int dimension);

/// On the negative duals of the highest degree that has some, which below n - 1 follow from those
/// of facets on surfaces; empty if there are none or nothing is left to be done. Who follows the
/// last of it (with, then discretize again) needs no other, unless flips have turned an obtuse
/// angle to the boundary; splits are advised then, and end it.
std::vector<Advice> advice(const Discretization& discretization);

/// "a mesh that is nearer to Delaunay there", and how to come by one: for refusals of what knows
/// volumes alone.
std::string nearer_to_delaunay(int dimension);

} // namespace polydec
