// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/forms.h"
#include "tests/support/merged.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace polydec::test {

using Json = nlohmann::json;

/// The file of that name among the golden ones.
Json golden_numbers(const std::string& file);

/// "grid4" of "grid4.nsc": what the mesh is called in the family.
std::string stem(const std::string& file);

/// Whether a value is the golden one, which has ten digits: 1e-8 relative, of zeros absolute.
bool is_golden(const Json& expected, double value);

#define EXPECT_GOLDEN(expected, value) EXPECT_PRED2(is_golden, Json(expected), value)

/// Compares star_k of the merged cells, named by their vertices, with [[vertices], value] pairs.
void expect_stars(const Json& expected, const Merged& mesh, int k);

/// The golden numbers of forms and their products, by the file names of meshes.
const Json& golden_calculus();

/// The names in it of the golden meshes that lie with the tests.
std::vector<std::string> golden_calculus_names();

/// Fixture of what these numbers say; the parameter is the name of a golden mesh.
class OverGoldenForms : public testing::TestWithParam<std::string> {
protected:
    const Merged& mesh() const { return merged(stem(GetParam())); }
    const Json& numbers() const { return golden_calculus().at(GetParam()); }
};

#define POLYDEC_OVER_GOLDEN_FORMS(suite)                                                           \
    INSTANTIATE_TEST_SUITE_P(Meshes, suite, testing::ValuesIn(golden_calculus_names()),            \
                             [](const auto& instance) { return stem(instance.param); })

/// The forms of which they are, in R^N with coordinates x, y, z, w as far as there are; missing
/// ones are 0.

/// (1 - y + x z, x^2 + y, y z + x, w + x) . dl
Vector alpha(const Vector& point);

/// (y, z - x, x y + 1, w^2) . dl
Vector beta(const Vector& point);

/// (1 + y) dx^dy + (x - z^2) dx^dz + (x y + 2) dy^dz
Vector eta(const Vector& point);

/// The integrals of a k-form over the merged cells.
Vector on_merged_cells(const Merged& mesh, int k, const Form& form);

} // namespace polydec::test
