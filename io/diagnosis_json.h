// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/diagnosis.h"
#include "io/json_writer.h"

#include <array>
#include <string>
#include <vector>

namespace polydec {

/// The verdicts on one operator, on primal and on dual forms; null for a side without verdict.
struct OperatorRow {
    using Sides = std::array<const OperatorVerdict*, 2>;
    std::string name;
    int degree;
    BeforeAndAfter<Sides> sides = {};
};

/// The rows of all operators, in the order of the diagnosis.
std::vector<OperatorRow> operator_rows(const Diagnosis& facts);

/// Percentage of triangles that were merged; after flips and splits, of the resulting triangles.
double percent_of_pairs(const Diagnosis& facts);

/// Writes the JSON members that describe a mesh; `advice` is already in words.
void write_diagnosis(JsonWriter& json, const Diagnosis& facts,
                     const std::vector<std::string>& advice);

/// Writes the member with numbers of the stars of all degrees.
void write_star_numbers(JsonWriter& json, const char* name, const std::vector<StarNumbers>& stars);

/// Writes the member that describes the chosen stars.
void write_stars(JsonWriter& json, const ChosenStars& stars);

} // namespace polydec
