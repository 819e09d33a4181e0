// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "tests/support/families.h"
#include "tests/support/matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace polydec::test {

/// What is asked of a mesh of which this is the length 1, about forms of a side and degree; the
/// answer without units.
using Question =
    std::function<Vector(const Discretization& mesh, double size, Side side, int degree)>;

/// Degrees below the first number, on meshes of the family.
struct Asked {
    int degrees = 9;
    std::vector<std::string> names{"grid4", "kuhn3", "wellcentred4", "icosphere3"};
};

/// Meshes of any size have the answers of those of size 1. The twin: data for twice that size.
inline void expect_no_unit(const Asked& asked, const Question& ask) {
    for (const std::string& name_of : asked.names)
        for (const Side side : {Side::primal, Side::dual}) {
            const auto original = discretize(mesh_named(name_of));
            for (int k = 0; k < std::min(asked.degrees, original.dimension() + 1); ++k) {
                const Vector expected = ask(original, 1, side, k);
                if (expected.size() == 0)
                    continue;
                for (const int exponent : {-300, -27, 200}) {
                    const double size = std::exp2(exponent);
                    Mesh mesh = mesh_named(name_of);
                    mesh.points *= size;
                    const auto scaled = discretize(mesh);
                    ASSERT_EQ(scaled.unit() == 1, exponent == -27);
                    EXPECT_LE(relative_difference(ask(scaled, size, side, k), expected), 1e-8)
                        << name_of << ' ' << exponent << ' ' << name(side) << k;
                    EXPECT_GT(relative_difference(ask(scaled, 2 * size, side, k), expected), 1e-4)
                        << name_of << ' ' << exponent << ' ' << name(side) << k;
                }
            }
        }
}

inline Vector joined(const std::vector<Vector>& parts) {
    Vector all;
    for (const Vector& part : parts) {
        all.conservativeResize(all.size() + part.size());
        all.tail(part.size()) = part;
    }
    return all;
}

} // namespace polydec::test
