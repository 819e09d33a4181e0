// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"
#include "meshes/tetgen/closed_surface.h"

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace polydec {

/// A closed surface that TetGen can fill; TetGen crashes on much invalid input. Coordinates are
/// near 1, so that products of lengths neither overflow nor underflow.
struct TetgenInput {
    Points points = {};               ///< the vertices of triangles, in order, times 2^-exponent
    Simplices triangles = {};         ///< of these points
    Points holes = {};                ///< a point in each part that stays empty, same unit
    std::vector<Index> vertices = {}; ///< numbers of the points on the given surface
    Simplices given = {};             ///< the triangles with those numbers, for messages
    int exponent = 0;
    ClosedSurface surface = {};
    std::vector<bool> filled = {};   ///< for each part: whether it is to contain tetrahedra
    std::vector<Index> patches = {}; ///< for each triangle, the first one of its patch, see below
};

/// Checks triangles in R^3 and the holes. A patch consists of triangles that meet at edges and are
/// coplanar within plane_tolerance of the smaller one. A hole empties the innermost part around it,
/// except for the parts inside that one. Throws InvalidInput like tetrahedralize.
TetgenInput tetgen_input(const Mesh& surface, const Points& holes);

/// Tolerance for coplanar triangles, relative to their size; TetGen's own.
inline constexpr double plane_tolerance = 1e-8;

/// The plane of a triangle, and its size.
struct TrianglePlane {
    Eigen::Vector3d origin;
    Eigen::Vector3d normal; ///< of length 1, or 0 if it has no area
    double size;            ///< its longest edge
    double area;

    /// Distance of a point from the plane.
    double height(const Eigen::Vector3d& place) const {
        return std::abs((place - origin).dot(normal));
    }
};

TrianglePlane triangle_plane(const Points& points, const Simplices& triangles, Index triangle);

/// A triangle with its corners: "3 (4 5 7)".
std::string facet_name(const Simplices& given, Index triangle);

} // namespace polydec
