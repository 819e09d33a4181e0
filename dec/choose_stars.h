// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/star_kind.h"
#include "dec/merging/merged_cells.h"

namespace polydec {

/// The stars of some kind of cells, size(k) x size(k), units length^(n-2k). Linear time, but for
/// the lift of merged cells; hybrid ones take a pass more whenever vertices add bad cells.
/// Source: Whitney 1957 for the forms, Hirani 2003 for the diagonal.
/// Throws InvalidInput for hybrid stars in another dimension than 2, and for stars of one's own.
ChosenStars choose_stars(const MergedCells& cells, StarKind kind);

} // namespace polydec
