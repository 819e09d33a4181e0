// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/vtu.h"
#include "meshes/level_sets.h"

#include <string>

namespace polydec {

/// The level sets of a primal 0-form, linear on the input's simplices, with their numbers and at
/// the places of the input; without orientation. Throws like level_sets, and InvalidInput for other
/// forms, which have no values at vertices.
LevelSets level_sets(const Discretization& discretization, const Cochain& form,
                     const Vector& levels);

/// Draws level sets as points, lines, triangles or tetrahedra. Cell data are the levels, under this
/// name, and `simplex`, the simplex that contains each. Throws InvalidInput above three dimensions.
VtuGrid draw_levels(const LevelSets& sets, const Vector& levels, std::string name);

} // namespace polydec
