// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_solid.h"

namespace polydec {

/// The default view with the axis `up`, 0 to 2, upwards: from the front, the right and above.
/// Throws InvalidInput for other numbers.
SolidView upright_view(int up);

} // namespace polydec
