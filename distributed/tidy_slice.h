// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/slices.h"

namespace polydec {

/// Collective: throws InvalidInput where tidy would omit cells or throw: cells with a repeated
/// corner, on the vertices of another cell, or without volume. Appends a warning about isolated
/// vertices to the slice, as tidy does. Coordinates must be finite, and vertices must exist.
void check_tidy(const Ranks& ranks, MeshSlice& slice);

} // namespace polydec
