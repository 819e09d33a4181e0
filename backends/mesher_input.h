// SPDX-License-Identifier: MIT
#pragma once

#include "backends/mesher.h"

#include <string>
#include <vector>

namespace polydec {

/// What a mesher need not be told: programs that mesh end in a crash where these do not hold.
/// Throw InvalidInput as tetrahedralize says.
void check_mesher_options(const MesherOptions& options);
void check_mesher_input(const MesherInput& input);

/// Number of facets; 0 for a point set.
Index facet_count(const MesherInput& input);

/// The points that the mesh is made of, ascending: all of a point set, else those on facets.
std::vector<Index> used_points(const MesherInput& input);

/// Facets that meet at edges and lie in one plane, within what facets may be bent by, are one
/// patch: for each facet the number of the first one of its patch.
std::vector<Index> plane_patches(const MesherInput& input);

/// A facet with its corners, for messages: "3 (4 5 7)"; of many corners the first ones.
std::string facet_name(const MesherInput& input, Index facet);

} // namespace polydec
