// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace polydec {

/// 1, 0 or -1: the sign of (b - a) x (c - a) . (d - a), exact unless a product underflows. Source:
/// Shewchuk, Discrete Comput. Geom. 18 (1997) 305.
int tetrahedron_sign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d);

} // namespace polydec
