// SPDX-License-Identifier: MIT
//
// Fig. 9: short dual edges get a minimal length instead of being merged away. The operators belong
// to the unmerged mesh. A dual edge shorter than epsilon gets length epsilon with the same sign.
// Between concyclic triangles the length is 0, and only rounding gives it a sign. The experiment
// therefore sets the sign, and shows both choices.
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec::paper {

namespace {

struct Sign {
    double of_zero; // 1 or -1
    const char *suffix, *title;
};

const Sign signs[] = {{1, "", "epsilon for 0"}, {-1, "_negative", "-epsilon for 0"}};

Discretization with_least_dual_length(const Mesh& mesh, double epsilon, const Sign& sign) {
    constexpr double rounding = 1e-10; // relative to the edge
    // the tolerance identifies boundary edges without dual; here all edges have one
    const auto bundle = discretized(mesh, {.criterion = MergeCriterion::none, .tolerance = 0});
    const Vector& edges = bundle.volumes().primal(1);
    Vector lengths = bundle.volumes().dual(1);
    for (Index e = 0; e < lengths.size(); ++e)
        if (std::abs(lengths[e]) < epsilon) {
            const bool is_zero = std::abs(lengths[e]) <= rounding * edges[e];
            lengths[e] = std::copysign(epsilon, is_zero ? sign.of_zero : lengths[e]);
        }
    return bundle.with_volumes(bundle.volumes().with_dual(1, std::move(lengths)));
}

double franke_error(const Discretization& mesh) {
    const PoissonSolver solver({mesh, Side::dual, 0, {BoundaryCondition::essential}});
    const Points places = dual_sites(mesh);
    const auto found = solver.solve({Side::dual, 0, values(franke_laplacian, places)},
                                    {.values = values(franke, facet_sites(mesh))});
    return weighted_norm(masses(mesh, Side::dual), found.form.values - values(franke, places));
}

double dual_sphere_error(const Discretization& mesh) {
    return sphere_error(mesh, Side::dual).relative;
}

struct Problem {
    std::string name, title, norm;
    Mesh (*make)(int cells);
    double (*error)(const Discretization&);
};

const Problem problems[] = {
    {"poisson", "Franke's problem on a split grid", "L2 error",
     [](int cells) { return grid(cells, cells); }, franke_error},
    {"sphere", "Spherical harmonic on a split UV sphere", "relative L2 error",
     [](int cells) { return uv_sphere(2 * cells, 2 * cells); }, dual_sphere_error}};

double error_or_none(const Problem& problem, const Discretization& mesh) {
    try {
        return problem.error(mesh);
    } catch (const Error&) { // lengths that are numerically zero are errors
        return none;
    }
}

void add_problem(Report& report, const Request& request, const Problem& problem, const Sign& sign,
                 int levels) {
    const std::string name = problem.name + sign.suffix;
    const std::string title = fmt::format("{}, {}", problem.title, sign.title);
    Table table{name, title + ", dual 0-forms: error", {"least dual length"}, {}};
    SvgPlot plot{.title = title, .x = {"least dual length"}, .y = {problem.norm}};
    for (int level = 0; level < levels; ++level) {
        table.columns.push_back(std::to_string(8 << level));
        plot.series.push_back({fmt::format("{} cells to a side", 8 << level), {}, {}});
    }
    for (int exponent = 1; exponent <= 13; exponent += 2) {
        const double epsilon = std::pow(10.0, -exponent);
        std::vector<Entry> row{fmt::format("1e-{}", exponent)};
        for (int level = 0; level < levels; ++level) {
            if (request.progress)
                request.progress(fmt::format("{}, {}, {}", name, 8 << level, epsilon));
            const auto mesh = with_least_dual_length(problem.make(8 << level), epsilon, sign);
            const double error = error_or_none(problem, mesh);
            plot.series[level].x.push_back(epsilon);
            plot.series[level].y.push_back(error);
            row.emplace_back(error);
        }
        table.rows.push_back(std::move(row));
    }
    std::vector<Entry> merged{"merged"};
    for (int level = 0; level < levels; ++level)
        merged.emplace_back(problem.error(discretized(problem.make(8 << level))));
    table.rows.push_back(std::move(merged));
    report.tables.push_back(std::move(table));
    report.plots.push_back({name, std::move(plot)});
}

} // namespace

Report fig9(const Request& request) {
    const int levels = request.levels > 0 ? request.levels : 4;
    Report report{.name = "fig9", .title = "A least dual edge length instead of merging (Fig. 9)"};
    for (const auto& problem : problems)
        for (const auto& sign : signs)
            add_problem(report, request, problem, sign, levels);
    report.remarks = {"Lengths for which the matrix cannot be solved to 1e-10 are refused, shown "
                      "as a dash: the paper's numerical instability.",
                      "A fixed length is right for one resolution at best: the error grows again "
                      "under refinement."};
    return report;
}

} // namespace polydec::paper
