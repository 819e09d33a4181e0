// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <string_view>

namespace polydec {

/// Throws InvalidInput, naming the first, if there are any: for what needs more of every piece than
/// fill_flat_pieces can give; what says for what.
void refuse_flat_pieces(const Discretization& mesh, std::string_view what);

/// Replaces the rows of flat n-pieces (Geometry::is_flat), whose corners tell nothing of what
/// goes across them, by the mean over the other pieces of their cells, weighted by volume. rows has
/// one for each n-piece.
void fill_flat_pieces(const Discretization& mesh, Points& rows);

} // namespace polydec
