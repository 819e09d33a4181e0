// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/merged_surface.h"
#include "dec/merging/merge.h"
#include "dec/surfaces/intrinsic_delaunay.h"

#include <utility>

namespace polydec {

/// The intrinsic Delaunay tessellation of a surface: triangles after flips, merged to polygons
/// where they are concyclic. Unique, up to tolerance, for every surface with vertices on it, and
/// every interior star_1 is positive. Source: Bobenko, Springborn 2007.
struct IntrinsicTessellation {
    IntrinsicDelaunay delaunay;
    CellVolumes triangle_volumes;
    MergedSurface merging;

    const GluedSurface& surface() const& { return delaunay.surface; }
    GluedSurface surface() && { return std::move(delaunay.surface); }
};

/// Flips, splits and merges as the options say. lengths are those of the edges.
/// Throws what intrinsic_delaunay throws; InvalidInput for the angle criterion, whose angles would
/// be those of the input.
IntrinsicTessellation intrinsic_tessellation(GluedSurface surface, Vector lengths,
                                             const MergeOptions& options);

/// A primal k-cochain of the triangles one began with as one of the polygons: the product of the
/// flips, then the sum over pieces. Commutes with d.
Vector carry(const IntrinsicTessellation& tessellation, int k, const Vector& values);

/// The other way: a removed edge gets the value that shares the circulation of its polygon in
/// proportion to area, and then all flips are undone. Commutes with d.
Vector carry_back(const IntrinsicTessellation& tessellation, int k, const Vector& values);

/// Lifts S_0, S_1, S_2 from the polygons to the flipped triangles: dia_k S_k = I, d S_k = S_(k+1)
/// d.
std::vector<SparseMatrix> commuting_lift(const IntrinsicTessellation& tessellation);

} // namespace polydec
