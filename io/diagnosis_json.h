// SPDX-License-Identifier: MIT
#pragma once

#include "dec/diagnosis.h"
#include "io/json_writer.h"

#include <array>
#include <string>
#include <vector>

namespace polydec {

/// The verdicts on one operator, on primal and on dual forms; for some there is only one of them.
struct OperatorRow {
    using Sides = std::array<const OperatorVerdict*, 2>;
    std::string name;
    int degree;
    BeforeAndAfter<Sides> sides = {};
};

/// Those of all operators, in the order of the diagnosis.
std::vector<OperatorRow> operator_rows(const Diagnosis& facts);

/// How many of the triangles were merged: with flips and splits, of those that they have made.
double percent_of_pairs(const Diagnosis& facts);

/// Writes the members of the JSON object that tells of a mesh; the advice is already in words.
void write_diagnosis(JsonWriter& json, const Diagnosis& facts,
                     const std::vector<std::string>& advice);

/// The member that has numbers of the stars of all degrees.
void write_star_numbers(JsonWriter& json, const char* name, const std::vector<StarNumbers>& stars);

/// And the member that tells of its stars.
void write_stars(JsonWriter& json, const ChosenStars& stars);

} // namespace polydec
