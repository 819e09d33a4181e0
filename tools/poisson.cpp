// SPDX-License-Identifier: MIT
#include "solvers/sources/poisson.h"

#include "base/errors.h"
#include "dec/discretization/material_stars.h"
#include "dec/fields/cell_centers.h"
#include "meshes/unit_of_length.h"
#include "system/memory.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/expression.h"
#include "tools/form_values.h"
#include "tools/picture.h"
#include "tools/poisson_answer.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace polydec::tools {

namespace {

struct PoissonArguments {
    MeshArguments mesh;
    Side side = Side::primal;
    std::string engine = "auto";
    ConditionArguments conditions;
    std::string rhs, boundary, exact, flux, conductivity;
    PictureArguments picture;
};

Solved describe(const Discretization& mesh, const FormSpace& space,
                const PoissonArguments& arguments, const PoissonSolution& solution) {
    const Vector& u = solution.form.values;
    Solved answer{
        {space.side(), 0,
         space.in_words({.values = !arguments.boundary.empty(), .flow = !arguments.flux.empty()}),
         mesh.chosen_stars()}};
    const auto& [natural, essential_where, essential_on, fixed_where, robin] = arguments.conditions;
    const bool everywhere = essential_where.empty() && essential_on.empty() && fixed_where.empty();
    answer.boundary = !everywhere  ? "mixed"
                      : robin != 0 ? "robin"
                      : natural    ? "natural"
                                   : "dirichlet";
    answer.unknowns = u.size();
    answer.min = u.minCoeff();
    answer.max = u.maxCoeff();
    answer.report = solution.report;
    answer.free_components = solution.compatibility.free_components;
    return answer;
}

Errors errors(const Discretization& mesh, Side side, const Vector& difference) {
    const Vector& volumes = side == Side::primal ? mesh.stars().volumes().dual(0)
                                                 : mesh.volumes().primal(mesh.dimension());
    // squares of the differences of a solution of extreme size would be no numbers
    const double largest = difference.cwiseAbs().maxCoeff();
    const double size = largest > 0 ? std::exp2(std::ilogb(largest)) : 1;
    const double squared = volumes.cwiseAbs().dot((difference / size).cwiseAbs2());
    return {in_input_units(size * std::sqrt(squared), mesh.unit(), mesh.dimension() / 2.0),
            largest};
}

void draw(const Discretization& mesh, const PoissonArguments& arguments, const Vector& values,
          const Solved& answer, const Log& log) {
    const auto side = arguments.side;
    PageText text =
        page_of(log, "Poisson problem",
                {fmt::format("Delta u = f with f = {}", arguments.rhs), answer.facts.conditions,
                 fmt::format("u from {:.10g} to {:.10g}; residual {:.2e} with {}", answer.min,
                             answer.max, answer.report.residual, answer.report.engine)});
    const NamedForm u("u", {side, 0, values},
                      fmt::format("the solution, a {} 0-form, in units of length^2*f{}", name(side),
                                  arguments.conductivity.empty() ? "" : "/conductivity"));
    std::vector<VtuArray> numbers{{"residual", std::vector<double>{answer.report.residual}}};
    if (answer.errors)
        numbers.push_back({"error_max", std::vector<double>{answer.errors->max}});
    if (answer.errors && answer.errors->l2)
        numbers.push_back({"error_l2", std::vector<double>{*answer.errors->l2}});
    write_picture(arguments.picture, mesh, {u}, std::move(text), std::move(numbers), log);
}

/// What the options give at sites; made before the mesh is read.
struct Data {
    explicit Data(const PoissonArguments& arguments)
        : rhs("--rhs", arguments.rhs),
          boundary(if_given<SiteValues>("--boundary", arguments.boundary)),
          flux(if_given<SiteValues>("--flux", arguments.flux)),
          conditions(arguments.conditions),
          exact(if_given<SiteValues>("--exact", arguments.exact)),
          conductivity(if_given<SiteValues>("--conductivity", arguments.conductivity, "group")) {}

    SiteValues rhs;
    std::optional<SiteValues> boundary, flux;
    ConditionValues conditions;
    std::optional<SiteValues> exact, conductivity;
};

/// What is proved of the error, on triangles, or why nothing is.
void add_bound(Solved& answer, const Discretization& mesh, const FormSpace& space,
               const CellData& conductivity, const std::string& engine, const Vector& f,
               const Vector& flux, const Vector& u) {
    if (mesh.dimension() != 2 || space.side() != Side::primal)
        return;
    try {
        const auto problem = poisson_problem(mesh, space.conditions(), conductivity, f, flux);
        answer.bound = poisson_error(problem, u, {.linear_solver = engine});
        for (const std::string& warning : answer.bound->warnings)
            answer.without_bound = warning;
    } catch (const OutOfMemory&) {
        throw;
    } catch (const Error& error) {
        answer.without_bound = error.what();
    }
}

void run_poisson(PoissonArguments arguments) {
    Log log;
    const Data data(arguments);
    check_picture(arguments.picture);
    if (arguments.picture.isolines > 0 && arguments.side == Side::dual)
        throw InvalidInput("--isolines need values at vertices: use --side primal");
    const Discretization mesh = load(arguments.mesh, log, arguments.picture.out);
    const CellData conductivity =
        data.conductivity ? cell_values(mesh, *data.conductivity) : CellData();
    const auto cells = computed_on(log.mesh, [&] {
        return data.conductivity ? with_conductivity(mesh, arguments.side, conductivity) : mesh;
    });
    const auto space = computed_on(log.mesh, [&] {
        return FormSpace(cells, arguments.side, 0,
                         data.conditions.on(mesh).value_or(BoundaryConditions{}));
    });
    space.require_use({.values = arguments.boundary.empty() ? "" : "--boundary",
                       .flow = arguments.flux.empty() ? "" : "--flux"});
    log.timing.begin("solve");
    const auto at = [&](const SiteValues& values, const Points& places) {
        return arguments.side == Side::primal ? vertex_values(mesh, values, places)
                                              : values.at(places);
    };
    const auto places = [&] { return sites(cells, arguments.side); };
    const Vector f = at(data.rhs, places()); // before there is a factor
    Vector h = Vector::Zero(cells.size(cells.dimension() - 1));
    BoundaryForms known;
    if (data.boundary)
        known.values = at(*data.boundary, boundary_sites(cells, arguments.side));
    if (data.flux) {
        h = data.flux->at(facet_sites(cells));
        known.derivative_flow = outward_flow(cells, arguments.side, h);
    }
    const auto solution = computed(log, "solve", [&] {
        return PoissonSolver(space, arguments.engine).solve({arguments.side, 0, f}, known);
    });
    const Vector& u = solution.form.values;
    log.warn(solution.warnings);
    Solved answer = describe(mesh, space, arguments, solution);
    log.timing.begin("bound");
    add_bound(answer, mesh, space, conductivity, arguments.engine, f, h, u);
    if (data.exact)
        answer.errors = errors(mesh, arguments.side, u - at(*data.exact, places()));
    if (!arguments.picture.out.empty()) {
        log.timing.begin("write");
        draw(mesh, arguments, u, answer, log);
    }
    tell(answer, log, arguments.mesh.tell);
}

} // namespace

void add_poisson(CLI::App& app) {
    const auto [command, arguments] = add_command<PoissonArguments>(
        app, "poisson", "solves Delta u = f, Delta = -div grad", run_poisson);
    command->add_option("--rhs", arguments->rhs, "EXPR\tthe right-hand side f")->required();
    command->add_option("--conductivity", arguments->conductivity,
                        "EXPR\tsolve -div(kappa grad u) = f with this kappa > 0 per cell; the "
                        "expression may use `group`, the cell's physical group");
    command->add_option("--exact", arguments->exact, "EXPR\texact solution to compare u with");
    add_side(*command, arguments->side);
    add_mesh_arguments(*command, arguments->mesh, StarKind::automatic);
    auto* boundary = command->add_option("--boundary", arguments->boundary,
                                         "EXPR\tvalues of u on the boundary (Dirichlet), instead "
                                         "of 0");
    add_conditions(*command, arguments->conditions,
                   "no values given on the boundary, only --flux (Neumann); u has mean 0",
                   "give values only at boundary facets where this is not 0, --flux elsewhere")
        ->excludes(boundary);
    command->add_option("--flux", arguments->flux,
                        "EXPR\toutward derivative of u, times the conductivity if given, elsewhere "
                        "on the boundary, instead of 0");
    add_robin(*command, arguments->conditions, "--flux");
    add_fixed(*command, arguments->conditions, "values of --boundary");
    add_picture(*command, arguments->picture, "u");
    add_isolines(*command, arguments->picture);
    add_engine(*command, arguments->engine);
    command->footer(
        "A file has one number for each vertex (primal) or merged cell (dual); for --boundary, for "
        "each vertex or merged facet, where only those on the boundary matter; for --flux and "
        "--essential-where, for each merged facet; for --conductivity, for each cell of the mesh "
        "file, in its order.\n\nExamples:\n"
        "  polydec poisson grid.nsc --side dual --rhs '2*pi^2*sin(pi*x)*sin(pi*y)' -o u.vtu\n"
        "  polydec poisson grid.nsc --rhs 1 --essential-where 'x<.01' --flux=-y\n"
        "  polydec poisson plate.msh --rhs 1 --keep-groups --conductivity 'group==2 ? 10 : 1'\n"
        "  polydec poisson plate.msh --side dual --rhs 1 --essential-on 3 --robin 2.5\n"
        "  polydec poisson sphere.off --rhs=-z --natural --json");
}

} // namespace polydec::tools
