// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/slices.h"

namespace polydec {

/// Collective: throws InvalidInput where tidy would leave cells out of the mesh, or refuse it:
/// cells with a repeated corner, on the vertices of another one, or without volume. Appends to the
/// slice's warnings, as tidy does, which vertices belong to no cell. Coordinates are finite, and
/// vertices are there.
void check_tidy(const Ranks& ranks, MeshSlice& slice);

} // namespace polydec
