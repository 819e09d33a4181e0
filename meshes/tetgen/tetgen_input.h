// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"
#include "meshes/tetgen/closed_surface.h"

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace polydec {

/// A closed surface that TetGen can fill, which ends in a crash on much that is none. Coordinates
/// are near 1, so that products of lengths neither overflow nor vanish.
struct TetgenInput {
    Points points = {};               ///< the vertices of triangles, in order, times 2^-exponent
    Simplices triangles = {};         ///< of these points
    Points holes = {};                ///< a point in each part that stays empty, in the same unit
    std::vector<Index> vertices = {}; ///< the points' numbers on the surface that was given
    Simplices given = {};             ///< the triangles with those numbers, for messages
    int exponent = 0;
    ClosedSurface surface = {};
    std::vector<bool> filled = {};   ///< of each part of it: whether there are tetrahedra within
    std::vector<Index> patches = {}; ///< of each triangle the first one of its patch, see below
};

/// Checks triangles in R^3 and the holes. Triangles that meet at edges and lie in one plane, within
/// plane_tolerance of the smaller one, are a patch. A hole empties the innermost part around it, up
/// to the parts within that one. Throws InvalidInput as tetrahedralize says.
TetgenInput tetgen_input(const Mesh& surface, const Points& holes);

/// What the triangles of one plane may be off each other, relative to their size; what TetGen takes
/// for plane.
inline constexpr double plane_tolerance = 1e-8;

/// Where a triangle lies, and how large it is.
struct TrianglePlane {
    Eigen::Vector3d origin;
    Eigen::Vector3d normal; ///< of length 1, or 0 if it has no area
    double size;            ///< its longest edge
    double area;

    /// How far a place is off the plane.
    double height(const Eigen::Vector3d& place) const {
        return std::abs((place - origin).dot(normal));
    }
};

TrianglePlane triangle_plane(const Points& points, const Simplices& triangles, Index triangle);

/// A triangle with its corners: "3 (4 5 7)".
std::string facet_name(const Simplices& given, Index triangle);

} // namespace polydec
