// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/vtu.h"
#include "meshes/level_sets.h"

#include <string>

namespace polydec {

/// The level sets of a primal 0-form, linear on the simplices of the input, by the numbers of these
/// and at the places of the input; not turned to any side. Throws like level_sets, and InvalidInput
/// for other forms: their values are not at vertices.
LevelSets level_sets(const Discretization& discretization, const Cochain& form,
                     const Vector& levels);

/// As points, lines, triangles or tetrahedra, with their levels as cell data of this name, and
/// `simplex`, which each of them lies in. Throws InvalidInput above three dimensions.
VtuGrid draw_levels(const LevelSets& sets, const Vector& levels, std::string name);

} // namespace polydec
