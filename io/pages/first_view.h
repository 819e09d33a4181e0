// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"
#include "io/pictures/draw_solid.h"

namespace polydec {

/// The axis of a page that points up, 0 to 2: the one that its text names, else that of its mesh
/// file. Throws InvalidInput like upright_view.
int upward_axis(const Page& page);

/// Whether all points lie in one plane z = constant.
bool is_flat(const Points& points);

/// The direction from which points are seen first: upright_view; from straight above if they are
/// flat.
SolidView first_view(const Points& points, int up);

} // namespace polydec
