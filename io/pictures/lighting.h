// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// The light on a surface with this normal, in parts to the right, up and to the eye: from the
/// upper left, from behind the eye. A side and its back are lit alike; 1 for the normal 0.
double brightness(const Eigen::Vector3d& normal);

} // namespace polydec
