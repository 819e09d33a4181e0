// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/merged.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

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

} // namespace polydec::test
