// SPDX-License-Identifier: MIT
#include "meshes/distance.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

double distance(const Points& points, Index a, Index b) {
    // near 1 by a power of two, squares lose nothing that others keep
    const Vector side = (points.row(b) - points.row(a)).transpose();
    const double largest = side.size() > 0 ? side.cwiseAbs().maxCoeff() : 0;
    if (largest == 0)
        return 0;
    const int exponent = std::isfinite(largest) ? std::ilogb(largest) : 0;
    double squares = 0;
    for (const double x : side)
        squares += std::pow(std::ldexp(x, -exponent), 2);
    const double length = std::ldexp(std::sqrt(squares), exponent);
    if (!std::isfinite(length))
        throw InvalidInput(
            fmt::format("the distance between vertices {} and {} is {}: expected a finite number; "
                        "move them or scale the mesh to a size nearer to 1",
                        a, b, length),
            {.vertices = {a, b}});
    return length;
}

} // namespace polydec
