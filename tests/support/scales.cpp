// SPDX-License-Identifier: MIT
#include "tests/support/scales.h"

#include "tests/support/test.h"

namespace polydec::test {

Mesh layers(int n, int cells, double thickness) {
    Mesh mesh = kuhn(n, cells);
    mesh.points.col(n - 1) *= cells * thickness;
    return mesh;
}

Mesh graded(int n, int cells, double ratio) {
    Mesh mesh = kuhn(n, cells);
    const double growth = std::pow(ratio, 1.0 / (cells - 1));
    const double whole = std::pow(growth, cells) - 1;
    mesh.points = mesh.points.unaryExpr(
        [&](double x) { return (std::pow(growth, std::round(x * cells)) - 1) / whole; });
    return mesh;
}

} // namespace polydec::test
