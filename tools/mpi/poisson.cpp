// SPDX-License-Identifier: MIT
#include "distributed/poisson.h"

#include "base/errors.h"
#include "distributed/shared_picture.h"
#include "meshes/unit_of_length.h"
#include "tools/conditions.h"
#include "tools/expression.h"
#include "tools/messages.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"
#include "tools/poisson_answer.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace polydec::tools {

namespace {

struct SharedPoissonArguments {
    SharedArguments mesh;
    SharedPoissonOptions poisson;
    ConditionArguments conditions;
    std::string rhs, boundary, exact, flux;
};

/// What the options give at sites of own cells; made before the mesh is read.
struct SharedData {
    explicit SharedData(const SharedPoissonArguments& arguments)
        : rhs(if_given<SiteValues>("--rhs", arguments.rhs)),
          boundary(if_given<SiteValues>("--boundary", arguments.boundary)),
          flux(if_given<SiteValues>("--flux", arguments.flux)),
          essential_where(
              if_given<SiteValues>("--essential-where", arguments.conditions.essential_where)),
          exact(if_given<SiteValues>("--exact", arguments.exact)) {}

    std::optional<SiteValues> rhs, boundary, flux, essential_where, exact;
};

/// Values at the centers of own cells; none without.
Vector values_at(const Ranks& ranks, const DistributedMesh& mesh,
                 const std::optional<SiteValues>& values, int k) {
    if (!values)
        return {};
    const auto& cells = mesh.cells.degree(k);
    const Points sites = mesh.unit * cell_centers(ranks, mesh, k);
    return ranks.together("data", [&] { return values->at(sites, cells.number, cells.count); });
}

BoundaryConditions conditions_on(const Ranks& ranks, const DistributedMesh& mesh,
                                 const SharedPoissonArguments& arguments, const SharedData& data) {
    if (arguments.conditions.natural)
        return {BoundaryCondition::natural};
    BoundaryConditions result;
    for (const double value : values_at(ranks, mesh, data.essential_where, mesh.dimension() - 1))
        result.facets.push_back(value != 0 ? BoundaryCondition::essential
                                           : BoundaryCondition::natural);
    return result;
}

Errors errors_of(const Ranks& ranks, const DistributedMesh& mesh, Side side,
                 const Vector& difference) {
    const Vector& volumes = side == Side::primal ? mesh.cells.volumes.dual(0)
                                                 : mesh.cells.volumes.primal(mesh.dimension());
    const double largest =
        ranks.largest(difference.size() > 0 ? difference.cwiseAbs().maxCoeff() : 0.0);
    const double size = largest > 0 ? std::exp2(std::ilogb(largest)) : 1;
    const double squared = ranks.sum(volumes.cwiseAbs().dot((difference / size).cwiseAbs2()));
    return {in_input_units(size * std::sqrt(squared), mesh.unit, mesh.dimension() / 2.0), largest};
}

void warn_of_negative(const Ranks& ranks, const DistributedMesh& mesh, Side side, Log& log) {
    const int n = mesh.dimension(), k = side == Side::primal ? std::min(1, n) : n - 1;
    const auto count =
        ranks.sum(static_cast<GlobalIndex>(HodgeStar(mesh.cells.volumes, k).negatives().size()));
    if (count > 0)
        log.warn(
            fmt::format("{} of the {}-cells {} a negative dual (not Delaunay there, or a center "
                        "beyond the boundary): "
                        "the solution may be far off there; `polydec poisson` supports other stars",
                        count, k, count == 1 ? "has" : "have"));
}

void run_poisson(const Ranks& ranks, SharedPoissonArguments arguments) {
    Log log = log_of(ranks);
    const SharedData data(arguments);
    check_output_file(ranks, arguments.mesh.out, ".pvtu");
    const DistributedMesh mesh = load(ranks, arguments.mesh, log);
    const auto& file = arguments.mesh.mesh.mesh;
    const Side side = arguments.poisson.side;
    const int n = mesh.dimension(), k = side == Side::primal ? 0 : n;
    log.timing.begin("solve");
    arguments.poisson.boundary = conditions_on(ranks, mesh, arguments, data);
    const BoundaryCounts on = boundary_counts(ranks, mesh, arguments.poisson.boundary);
    require_use(on, {.values = !arguments.boundary.empty() ? "--boundary"
                               : data.essential_where      ? "--essential-where"
                                                           : "",
                     .flow = arguments.flux.empty() ? "" : "--flux"});
    const auto solver = computed_on(file, [&] {
        const SharedProgress progress(ranks);
        return SharedPoissonSolver(ranks, mesh, arguments.poisson);
    });
    const auto in_units = [&](const Vector& values, double power, const char* what) {
        return ranks.together("data",
                              [&] { return in_input_units(values, mesh.unit, power, what); });
    };
    const Vector f = in_units(values_at(ranks, mesh, data.rhs, k), 2, "--rhs");
    const Vector g = values_at(ranks, mesh, data.boundary, side == Side::primal ? 0 : n - 1);
    const Vector h = in_units(values_at(ranks, mesh, data.flux, n - 1), 1, "--flux");
    const auto solution = computed_on(file, [&] { return solver.solve(f, g, h); });
    log.warn(warning_of(solution.compatibility));
    warn_of_negative(ranks, mesh, side, log);

    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vector& u = solution.values;
    Solved answer{facts_of(
        mesh, side, 0,
        in_words(on, 0, n,
                 {.values = !arguments.boundary.empty(), .flow = !arguments.flux.empty()}))};
    answer.boundary = arguments.conditions.natural ? "natural"
                      : data.essential_where       ? "mixed"
                                                   : "dirichlet";
    answer.unknowns = mesh.cells.degree(k).count;
    answer.min = ranks.least(u.size() > 0 ? u.minCoeff() : infinity);
    answer.max = ranks.largest(u.size() > 0 ? u.maxCoeff() : -infinity);
    answer.report = solution.report;
    answer.free_components = solution.compatibility.free_components;
    if (data.exact)
        answer.errors = errors_of(ranks, mesh, side, u - values_at(ranks, mesh, data.exact, k));
    if (!arguments.mesh.out.empty()) {
        log.timing.begin("write");
        write_pvtu(ranks, arguments.mesh.out, mesh, {{"u", k, u}});
    }
    tell(ranks, mesh, answer, log, arguments.mesh.mesh.tell);
}

} // namespace

void add_shared_poisson(CLI::App& app, const Ranks& ranks) {
    const auto [command, arguments] = add_command<SharedPoissonArguments>(
        app, "poisson", "solves Delta u = f, Delta = -div grad",
        [ranks](const SharedPoissonArguments& given) { run_poisson(ranks, given); });
    add_shared_arguments(*command, arguments->mesh);
    add_star(*command, arguments->mesh.mesh, StarKind::automatic);
    command->add_option("--rhs", arguments->rhs, "EXPR\tthe right-hand side f")->required();
    command->add_option("--exact", arguments->exact, "EXPR\texact solution to compare u with");
    add_side(*command, arguments->poisson.side);
    auto* boundary = command->add_option("--boundary", arguments->boundary,
                                         "EXPR\tvalues of u on the boundary (Dirichlet), instead "
                                         "of 0");
    add_conditions(*command, arguments->conditions,
                   "no values given on the boundary, only --flux (Neumann); u has mean 0",
                   "give values only at boundary facets where this is not 0, --flux elsewhere")
        ->excludes(boundary);
    command->add_option("--flux", arguments->flux,
                        "EXPR\toutward derivative of u elsewhere on the boundary, instead of 0");
    command->add_option("--engine", arguments->poisson.engine.name,
                        "NAME\tpetsc.cg-hypre, petsc.cg-gamg, petsc.mumps, or auto");
    command->add_option("--petsc", arguments->poisson.engine.options,
                        "OPTIONS\toptions for PETSc, such as '-ksp_type fcg -ksp_monitor'; unused "
                        "ones are an error");
    add_picture(*command, arguments->mesh.out, "u", false);
    command->remove_option(command->get_option("--essential-on"));
    refuse_options(*command, {"--conductivity", "--essential-on", "--isolines", "--float32"});
    command->footer(
        "Several ranks support only circumcentric stars: if the automatic ones differ, use --star "
        "circumcentric, or a single process. Files are as for `polydec poisson`; every rank reads "
        "them as a whole.\n\nExamples:\n"
        "  mpirun -n 4 polydec-mpi poisson engine.pdm --side primal --rhs 1 -o u.pvtu\n"
        "  srun polydec-mpi poisson grid.pdm --side dual --rhs 'sin(x)' --natural "
        "--petsc '-ksp_view'");
}

} // namespace polydec::tools
