// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec::test {

/// A grid of boxes of 1/cells a side but along the last axis, where they are thin: as many layers.
Mesh layers(int n, int cells, double thickness);

/// A grid of boxes in the unit n-cube whose sizes grow geometrically along every axis, so that the
/// largest is `ratio` times the smallest.
Mesh graded(int n, int cells, double ratio);

} // namespace polydec::test
