// SPDX-License-Identifier: MIT
#pragma once

#include "backends/mesher.h"

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace polydec {

/// What a mesher need not be told: programs that mesh end in a crash where these do not hold.
/// Throw InvalidInput as tetrahedralize says.
void check_mesher_options(const MesherOptions& options);
void check_mesher_input(const MesherInput& input);

/// Number of facets; 0 for a point set.
Index facet_count(const MesherInput& input);

/// The points that the mesh is made of, ascending: all of a point set, else those on facets.
std::vector<Index> used_points(const MesherInput& input);

/// What a facet may be bent by, and the facets of one plane may be off each other, relative to the
/// size of the facet; what TetGen takes for plane.
inline constexpr double bending_tolerance = 1e-8;

/// Where a facet lies, and how large it is.
struct FacetPlane {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< of length 1, or 0 if it has no area
    double size = 0.0; ///< its longest side, or way between its first and another corner

    /// How far a place is off the plane, in units of the points.
    double height(const Eigen::Vector3d& place) const {
        return std::abs((place - origin).dot(normal));
    }
};

/// For every facet. Squares of coordinates must be numbers.
std::vector<FacetPlane> facet_planes(const MesherInput& input);

/// Facets that meet at edges and lie in one plane, within bending_tolerance of the smaller one, are
/// one patch: for each facet the number of the first one of its patch.
std::vector<Index> plane_patches(const MesherInput& input);

/// A facet with its corners, for messages: "3 (4 5 7)"; of many corners the first ones.
std::string facet_name(const MesherInput& input, Index facet);

} // namespace polydec
