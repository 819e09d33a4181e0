// SPDX-License-Identifier: MIT
//
// Table 1: operators that are well defined on a mesh with concyclic triangles, before and after
// merging, computed from the duals of a split grid.
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"

#include <fmt/format.h>

#include <map>

namespace polydec::paper {

namespace {

/// The rows of the paper's table, in its order: operator, degree.
const std::vector<std::pair<std::string, int>> paper_rows = {
    {"d", 0},        {"d", 1},        {"star", 0},     {"star", 1},     {"star", 2},
    {"flat ppp", 1}, {"flat dpp", 1}, {"flat ppd", 1}, {"flat pdp", 1}, {"flat pdd", 1},
    {"flat dpd", 1}, {"sharp pp", 1}, {"sharp pd", 1}};

using Verdicts = std::map<std::pair<std::string, int>, std::map<Side, std::string>>;

Verdicts verdicts(const Discretization& mesh, Stage stage) {
    Verdicts result;
    for (const auto& verdict : operator_verdicts(mesh, stage))
        result[{verdict.name, verdict.degree}][verdict.side] = name(verdict.verdict);
    return result;
}

std::string word(const Verdicts& all, const std::pair<std::string, int>& row, Side side) {
    const auto& sides = all.at(row);
    const auto found = sides.find(side);
    return found == sides.end() ? "N/A" : found->second;
}

std::string label(const std::pair<std::string, int>& row) {
    const bool graded = row.first.find(' ') == std::string::npos;
    return graded ? fmt::format("{} {}", row.first, row.second) : row.first;
}

} // namespace

Report table1(const Request&) {
    const auto mesh = discretized(grid(8, 8));
    const auto before = verdicts(mesh, Stage::input), after = verdicts(mesh, Stage::merged);
    Table table{"table1",
                "whether operators are well defined on a split grid",
                {"operator", "primal", "dual", "merged, primal", "merged, dual"},
                {}};
    auto rows = paper_rows;
    for (int k = 0; k <= 2; ++k)
        rows.emplace_back("laplacian", k);
    for (const auto& row : rows)
        table.rows.push_back({label(row), word(before, row, Side::primal),
                              word(before, row, Side::dual), word(after, row, Side::primal),
                              word(after, row, Side::dual)});
    return {.name = "table1",
            .title = "Which operators are well defined (Table 1)",
            .tables = {std::move(table)},
            .remarks = {"Restricted: on forms alone that have one density on the triangles of a "
                        "polygon (Eq. 4).",
                        "The column of a star's degree is that of the primal forms; dual means "
                        "its inverse.",
                        "The paper leaves the sharps open on polygons; here they are there. The "
                        "Laplacians are those of its section 5.6.",
                        "The inverse of star 0 is well defined here, but not on every mesh as "
                        "Lemma A.1 has it: signed dual areas can vanish."}};
}

} // namespace polydec::paper
