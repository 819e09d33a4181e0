// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merged_cells.h"
#include "dec/stars/star.h"

namespace polydec {

/// The stars of the given kind, size(k) x size(k), units length^(n-2k). Linear time, except for the
/// lift of merged cells; hybrid stars need another pass whenever vertices add bad cells.
/// Source: Whitney 1957 for the forms, Hirani 2003 for the diagonal.
/// Throws InvalidInput for hybrid stars in dimensions other than 2, and for StarKind::own.
ChosenStars choose_stars(const MergedCells& cells, StarKind kind);

} // namespace polydec
