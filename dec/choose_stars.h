// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/star_kind.h"

namespace polydec {

/// The stars of a mesh of some kind, size(k) x size(k), units length^(n-2k). Linear time, but for
/// the lift of merged cells; hybrid ones take a pass more whenever vertices add bad cells.
/// Source: Whitney 1957 for the forms, Hirani 2003 for the diagonal.
/// Throws InvalidInput for hybrid stars in another dimension than 2, and for stars of one's own.
ChosenStars choose_stars(const Discretization& mesh, StarKind kind);

} // namespace polydec
