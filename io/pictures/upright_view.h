// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_solid.h"

namespace polydec {

/// The default view with the axis `up`, 0 to 2, upwards: from the front, the right and above.
/// Throws InvalidInput for other numbers.
SolidView upright_view(int up);

/// Whether all points lie in one plane z = constant.
bool is_flat(const Points& points);

/// The direction from which points are seen first: upright_view; from straight above if they are
/// flat.
SolidView first_view(const Points& points, int up);

} // namespace polydec
