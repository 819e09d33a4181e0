// SPDX-License-Identifier: MIT
#include "io/pictures/lighting.h"

#include <algorithm>

namespace polydec {

double brightness(const Eigen::Vector3d& normal) {
    static const Eigen::Vector3d light = Eigen::Vector3d(-0.35, 0.7, 1).normalized();
    const double size = normal.norm(), turn = normal[2] < 0 ? -1 : 1;
    return size > 0 ? 0.74 + 0.26 * std::max(0.0, turn * normal.dot(light) / size) : 1;
}

} // namespace polydec
