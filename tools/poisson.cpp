// SPDX-License-Identifier: MIT
#include "solvers/poisson.h"

#include "dec/star.h"
#include "io/draw_cells.h"
#include "io/vtu.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/expression.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <optional>

namespace polydec::tools {

namespace {

struct Arguments {
    MeshArguments mesh;
    PoissonOptions poisson;
    ConditionArguments conditions;
    std::string rhs, boundary, exact, flux;
    std::filesystem::path out;
};

/// What is known on the boundary, in words.
std::string known(const Discretization& mesh, const Arguments& arguments) {
    const auto given = [](const std::string& values) { return values != "0"; };
    return in_words(arguments.poisson.boundary, mesh.complex(), 0,
                    {.values = given(arguments.boundary), .flow = given(arguments.flux)});
}

Json describe(const Arguments& arguments, const PoissonSolver& solver, const Vector& u) {
    Json answer{{"side", name(arguments.poisson.side)},
                {"boundary", arguments.conditions.natural                   ? "natural"
                             : arguments.conditions.essential_where.empty() ? "dirichlet"
                                                                            : "mixed"},
                {"unknowns", u.size()},
                {"min", u.minCoeff()},
                {"max", u.maxCoeff()},
                {"residual", solver.residual()},
                {"engine", solver.report().engine},
                {"tried", solver.report().tried},
                {"iterations", solver.report().iterations},
                {"free_components", solver.compatibility().free_components}};
    return answer;
}

/// Errors against the exact solution: L2 with the cells' volumes as weights, and the largest.
Json errors(const Discretization& mesh, const Arguments& arguments, const PoissonSolver& solver,
            const Vector& u) {
    const Vector difference = u - values_at("--exact", arguments.exact, solver.sites());
    const Vector& volumes = arguments.poisson.side == Side::primal
                                ? mesh.volumes.dual(0)
                                : mesh.volumes.primal(mesh.dimension());
    const double squared = volumes.cwiseAbs().dot(difference.cwiseAbs2());
    return {{"l2", std::sqrt(squared)}, {"max", difference.cwiseAbs().maxCoeff()}};
}

void draw(const Discretization& mesh, const Arguments& arguments, const Vector& u) {
    const int k = arguments.poisson.side == Side::primal ? 0 : mesh.dimension();
    auto grid = draw_cells(mesh, k);
    const auto side = arguments.poisson.side;
    add_form(grid, mesh, "u", {side, 0, u});
    write_vtu(arguments.out, grid);
}

void print(const Json& answer) {
    fmt::print("Poisson problem for {} 0-forms, {} boundary, {} unknowns\n",
               answer["side"].get<std::string>(), answer["boundary"].get<std::string>(),
               answer["unknowns"].get<Index>());
    fmt::print("  {}\n", answer["conditions"].get<std::string>());
    fmt::print("  solution from {:.10g} to {:.10g}\n", answer["min"].get<double>(),
               answer["max"].get<double>());
    fmt::print("  residual {:.2e} with {} (tried: {})\n", answer["residual"].get<double>(),
               answer["engine"].get<std::string>(),
               fmt::join(answer["tried"].get<std::vector<std::string>>(), "; "));
    if (answer.contains("error"))
        fmt::print("  error: L2 {:.6e}, largest {:.6e}\n", answer["error"]["l2"].get<double>(),
                   answer["error"]["max"].get<double>());
}

void warn_of_compatibility(const PoissonSolver& solver) {
    const auto& compatibility = solver.compatibility();
    constexpr double rounding = 1e-10;
    if (compatibility.worst > rounding)
        warn(fmt::format("the right-hand side does not sum to zero on {} component{} without "
                         "boundary data (relative {:.2g}): its mean was removed",
                         compatibility.free_components,
                         compatibility.free_components == 1 ? "" : "s", compatibility.worst));
}

/// Dual cells of negative extent that the problem is made of.
std::optional<std::string> negative_duals(const Discretization& mesh, Side side) {
    const int k = side == Side::primal ? 0 : mesh.dimension() - 1;
    const auto cells = negative_star_cells(mesh.volumes, k).size();
    if (cells == 0)
        return std::nullopt;
    return fmt::format("{} of the {}-cells have a negative dual (the mesh is not Delaunay there): "
                       "the solution may be far off beside them{}{}",
                       cells, k, side == Side::dual ? "; compare with --side primal" : "",
                       flip_advice(mesh));
}

void run(Arguments arguments) {
    Timing timing;
    const Discretization mesh = load(arguments.mesh, timing);
    arguments.poisson.boundary =
        conditions(mesh, arguments.conditions).value_or(BoundaryConditions{});
    if (!arguments.out.empty())
        check_drawable(mesh.dimension(), static_cast<int>(mesh.points.cols()));
    timing.begin("solve");
    PoissonSolver solver = [&] {
        const Progress progress;
        progress("solve");
        return PoissonSolver(mesh, arguments.poisson);
    }();
    const Vector f = values_at("--rhs", arguments.rhs, solver.sites());
    const Vector g = values_at("--boundary", arguments.boundary, solver.boundary_sites());
    const Vector h = values_at("--flux", arguments.flux, solver.flux_sites());
    const Vector u = solver.solve(f, g, h);
    warn_of_compatibility(solver);
    const auto negative = negative_duals(mesh, arguments.poisson.side);
    if (negative)
        warn(*negative);
    if (!arguments.out.empty()) {
        timing.begin("write");
        draw(mesh, arguments, u);
    }

    Json answer = describe(arguments, solver, u);
    answer["conditions"] = known(mesh, arguments);
    if (!arguments.exact.empty())
        answer["error"] = errors(mesh, arguments, solver, u);
    answer["warnings"] = mesh.warnings;
    if (negative)
        answer["warnings"].push_back(*negative);
    add_timing(answer, arguments.mesh, timing);
    if (arguments.mesh.json) {
        fmt::print("{}\n", answer.dump());
        return;
    }
    print(answer);
    print_timing(arguments.mesh, timing);
}

} // namespace

void add_poisson(CLI::App& app) {
    auto* command = app.add_subcommand("poisson", "solves Delta u = f, Delta = -div grad");
    const auto arguments = std::make_shared<Arguments>();
    add_mesh_arguments(*command, arguments->mesh, JsonOption::offered);
    add_side(*command, arguments->poisson.side)->required();
    command->add_option("--rhs", arguments->rhs, "f: an expression in x, y, z, or a file")
        ->required();
    auto* boundary = command->add_option("--boundary", arguments->boundary,
                                         "values of u on the boundary (Dirichlet): expression or\n"
                                         "file (default 0)");
    arguments->boundary = "0";
    add_conditions(*command, arguments->conditions,
                   "no values given on the boundary, only --flux (Neumann);\nu has mean 0",
                   "values given (Dirichlet) only at boundary facets where this is not 0,\n"
                   "--flux (Neumann) at the others")
        ->excludes(boundary);
    command->add_option("--flux", arguments->flux,
                        "outward derivative of u on the rest of the boundary (default 0:\n"
                        "no flow through it)");
    arguments->flux = "0";
    command->add_option("--exact", arguments->exact, "exact solution to compare with");
    command->add_option("-o,--out", arguments->out, "write u to this .vtu file");
    command->add_option("--engine", arguments->poisson.linear_solver, "linear solver")
        ->capture_default_str();
    command->footer(
        "A file holds one value for each vertex (primal) or merged cell (dual); for --boundary "
        "one\n"
        "for each vertex or merged facet, of which those off the boundary do not matter; for "
        "--flux\n"
        "and --essential-where one for each merged facet.\n\n"
        "Examples:\n"
        "  polydec poisson grid.nsc --side dual --rhs '2*pi^2*sin(pi*x)*sin(pi*y)' -o u.vtu\n"
        "  polydec poisson grid.nsc --side primal --rhs 1 --essential-where 'x<.01' --flux=-y\n"
        "  polydec poisson sphere.off --side primal --rhs=-z --natural --json");
    command->callback([arguments] { run(*arguments); });
}

} // namespace polydec::tools
