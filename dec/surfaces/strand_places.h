// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/normal_coordinates.h"

namespace polydec {

/// Where strands cross the edges of a surface with these lengths: of each crossing its place along
/// the strand, from 0 to 1, ascending. Strands are geodesics: the triangles that one passes, laid
/// flat one behind the other, have it as a straight line.
std::vector<double> strand_places(const GluedSurface& surface, const Vector& lengths,
                                  const Strands& strands);

} // namespace polydec
