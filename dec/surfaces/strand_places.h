// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/normal_coordinates.h"

namespace polydec {

/// Positions at which strands cross the edges of a surface with these lengths: per crossing the
/// position along the strand, from 0 to 1, ascending. Strands are geodesics: straight lines when
/// the triangles along them are laid flat.
std::vector<double> strand_places(const GluedSurface& surface, const Vector& lengths,
                                  const Strands& strands);

} // namespace polydec
