// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/merged_surface.h"
#include "dec/metric/cell_volumes.h"

namespace polydec {

/// Throws InvalidInput, naming the edge or triangle, unless there is one positive length for each
/// edge and every triangle has some area with them.
void check_lengths(const GluedSurface& surface, const Vector& lengths);

/// The side lengths of a triangle, those of its three half-edges.
std::array<double, 3> side_lengths(const GluedSurface& surface, const Vector& lengths,
                                   Index triangle);

/// Volumes of the cells of a glued surface and signed volumes of their circumcentric duals from
/// edge lengths alone: star_1 is half the sum of the cotangents of the angles opposite to an edge.
/// The same as those of a simplicial surface with these lengths. Throws like check_lengths.
CellVolumes circumcentric_volumes(const GluedSurface& surface, const Vector& lengths);

/// Volumes of the polygons, as merged_volumes.
CellVolumes merged_volumes(const MergedSurface& merging, const CellVolumes& triangles);

} // namespace polydec
