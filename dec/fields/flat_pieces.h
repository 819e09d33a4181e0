// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/surfaces/places.h"

#include <string_view>

namespace polydec {

/// Throws InvalidInput, naming the first, if there are flat n-pieces: for functions that need more
/// than fill_flat_pieces provides; `what` names the function.
void refuse_flat_pieces(const Discretization& mesh, std::string_view what);

/// Replaces the rows of flat n-pieces (Geometry::is_flat) by the mean over the other pieces of
/// their cells, weighted by volume: corners of flat pieces do not determine the component across
/// them. `rows` has one row per n-piece.
void fill_flat_pieces(const Discretization& mesh, Points& rows);

/// Values at vertices, interpolated linearly at the centers of the k-pieces; filled likewise for
/// k = n.
Points at_centers(const Discretization& mesh, const Places& places, const Points& values, int k);

} // namespace polydec
