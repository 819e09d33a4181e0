// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/periodic.h"

namespace polydec::test {

/// Unit squares cut in two, all in |x| + |y| <= m: glued along (m, m) and (m, -m), whose seams run
/// through squares.
PeriodicMesh diamond(int m);

/// The diamond of side 1 across.
PeriodicMesh unit_diamond(int m);

} // namespace polydec::test
