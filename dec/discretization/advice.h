// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

#include <string>
#include <vector>

namespace polydec {

/// Remedy for dual cells of negative or zero volume: an option of discretize.
enum class Remedy {
    none,
    flips,  ///< Delaunay::flips: flips edges between two triangles
    splits, ///< Delaunay::flips_and_splits: also splits boundary edges
    stars,  ///< StarKind::automatic: stars that are positive on every mesh
};

/// C++ name of the option: "DiscretizeOptions::delaunay"; empty for Remedy::none.
const char* option(Remedy remedy);

/// The options with the remedy applied.
DiscretizeOptions with(Remedy remedy, DiscretizeOptions options);

/// The remedy for a mesh some of whose duals are not positive: the first of flips and splits that
/// makes every dual positive, else stars. Flips and splits are tried out, on surfaces with at most
/// two triangles per edge, unless the options exclude them: by the test of opposite angles, by
/// keeping materials apart, or by other centers. `lengths`: one per edge of the input. Takes the
/// time of the flips.
Remedy remedy(const SimplicialComplex& input, const Vector& lengths,
              const DiscretizeOptions& options);

/// The remedy for a discretized mesh with circumcentric or hybrid stars; never stars if they are
/// hybrid. None if every dual is positive, if hybrid stars meet no negative dual (zero volumes do
/// no harm to them), and for other stars or centers.
Remedy remedy(const Discretization& mesh);

/// Cells of one degree whose duals are not positive, and the remedy.
struct Advice {
    int degree = 0;
    Index cells = 0;
    bool negative = true;     ///< false: without volume
    bool on_boundary = false; ///< all are boundary facets, which cannot flip
    Remedy remedy = Remedy::none;
};

/// Example: "3 negative dual edges on the boundary: add Delaunay::flips_and_splits".
std::string in_words(const Advice& advice, int dimension);

/// Advice on the negative duals of the highest degree that has any (on surfaces, negative duals of
/// vertices follow from negative duals of edges). Without negative duals: advice on duals without
/// volume; the remedy is then stars. Empty if every dual is positive, and for other stars or
/// centers. A mesh discretized again with the remedy (see with) needs no further advice.
std::vector<Advice> advice(const Discretization& discretization);

/// "; add Delaunay::flips" where flips or splits help against negative duals, else empty.
std::string flip_advice(const Discretization& mesh);

/// Adds a warning if the options select hybrid stars because of negative duals that flips or splits
/// could make positive. `lengths`: one per edge of the input. `volumes`: of the cells.
void warn_of_hybrid_stars(const SimplicialComplex& input, const Vector& lengths,
                          const CellVolumes& volumes, const DiscretizeOptions& options,
                          std::vector<std::string>& warnings);

/// A warning that states the consequence, if the star of k-cells has negative entries; else empty.
std::vector<std::string> warning_of_negative_duals(const Cells& cells, int k,
                                                   std::string_view consequence);

/// "stars that are positive on every mesh (StarKind::automatic)", and the alternatives: for error
/// messages of functions that use volumes only.
std::string positive_stars(int dimension);

} // namespace polydec
