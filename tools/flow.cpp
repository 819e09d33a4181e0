// SPDX-License-Identifier: MIT
#include "solvers/flow/flow.h"

#include "base/errors.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/chosen_cells.h"
#include "solvers/flow/flow_data.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/component_values.h"
#include "tools/form_values.h"
#include "tools/in_time.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace polydec::tools {

namespace {

struct FlowArguments {
    MeshArguments mesh;
    TimeArguments time;
    std::string vorticity, velocity, boundary_velocity, no_slip_where, open_where, rotation;
    std::vector<std::string> no_slip_on, open_on; ///< physical groups
    FlowOptions flow;
    FlowScheme scheme = FlowScheme::implicit_midpoint;
};

struct Given {
    std::optional<SiteValues> vorticity, rotation; ///< at vertices
    ComponentValues velocity, boundary, no_slip, open;
    std::vector<std::string> no_slip_on, open_on;

    explicit Given(const FlowArguments& arguments)
        : vorticity(if_given<SiteValues>("--vorticity", arguments.vorticity)),
          rotation(if_given<SiteValues>("--rotation", arguments.rotation)),
          velocity("--velocity", arguments.velocity),
          boundary("--boundary-velocity", arguments.boundary_velocity),
          no_slip("--no-slip-where", arguments.no_slip_where),
          open("--open-where", arguments.open_where),
          no_slip_on(arguments.no_slip_on),
          open_on(arguments.open_on) {}

    FlowOptions options(const Discretization& mesh, FlowOptions options) const {
        const Points facets = facet_sites(mesh);
        std::vector<FlowFacets> chosen;
        const auto choose = [&](FlowBoundary kind, const ComponentValues& where,
                                const std::vector<std::string>& groups, const char* name) {
            if (where.given()) {
                std::vector<bool> marks;
                for (const double value : where.at(facets))
                    marks.push_back(value != 0);
                chosen.push_back({kind, std::move(marks), name});
            }
            for (const std::string& group : groups)
                chosen.push_back(
                    {kind, facets_in(mesh, {group}), fmt::format("the group {}", group)});
        };
        choose(FlowBoundary::no_slip, no_slip, no_slip_on, "--no-slip-where");
        choose(FlowBoundary::open, open, open_on, "--open-where");
        options.facets = flow_boundary(mesh.complex(), chosen);
        if (boundary.given()) {
            const Points given = boundary.at(facets, facets.cols());
            options.boundary_flux = flux_through_boundary(mesh, given);
            const auto& kinds = options.facets;
            if (std::find(kinds.begin(), kinds.end(), FlowBoundary::no_slip) != kinds.end() ||
                options.boundary_flux.isZero(0)) // or refused: no facet uses any part of it
                options.wall_velocity = given;
        }
        if (rotation && mesh.dimension() != 2)
            throw InvalidInput(fmt::format("--rotation is no vorticity of the frame in dimension "
                                           "{}: expected a surface",
                                           mesh.dimension()));
        if (rotation)
            options.rotation = vertex_values(mesh, *rotation, cell_centers(mesh, 0));
        return options;
    }

    /// Fluxes that a flow begins with; to be projected.
    Vector start(const Discretization& mesh, Log& log) const {
        const Points sites = cell_centers(mesh, 0);
        const auto moving = [&](const Vector& numbers, Vector fluxes) {
            log.warn(warning_of_rest(numbers, fluxes));
            return fluxes;
        };
        if (vorticity) {
            const Vector numbers = vertex_values(mesh, *vorticity, sites);
            return moving(numbers, flow_of_vorticity(mesh, numbers));
        }
        if (velocity.given()) {
            const Points vectors = velocity.at(sites, sites.cols());
            return moving(vectors.reshaped(), flow_of_velocity(mesh, vectors));
        }
        return Vector::Zero(mesh.complex().size(mesh.dimension() - 1));
    }
};

std::string boundary_in_words(const std::vector<FlowBoundary>& facets, const CellComplex& complex) {
    const std::vector<BoundaryFacet> boundary = boundary_facets(complex);
    if (boundary.empty())
        return "no boundary";
    const auto count = [&](FlowBoundary kind) {
        return std::count_if(boundary.begin(), boundary.end(),
                             [&](const BoundaryFacet& on) { return facets[on.facet] == kind; });
    };
    return fmt::format("boundary facets: {} with free slip, {} without slip, {} open",
                       count(FlowBoundary::free_slip), count(FlowBoundary::no_slip),
                       count(FlowBoundary::open));
}

struct Flowed {
    FormFacts facts; // of the flux
    Ran ran;
    double viscosity, exchange_time, divergence;
    std::optional<double> circulation, energy, relative_energy, enstrophy, most, least;

    Flowed(const FormFacts& known, const Ran& how, const IncompressibleFlow& flow,
           const Vector& start, const Vector& w)
        : facts(known),
          ran(how),
          viscosity(flow.options().viscosity),
          exchange_time(flow.exchange_time(w)),
          divergence(flow.divergence(w)) {
        if (flow.mesh().dimension() == 2) // numbers of edges in space have arbitrary signs
            circulation = in_range([&] { return flow.circulations(w).sum(); });
        if (!start.isZero(0))
            relative_energy = in_range([&] { return flow.relative_energy(w, start); });
        energy = in_range([&] { return flow.energy(w); });
        enstrophy = in_range([&] { return flow.enstrophy(w); });
        most = in_range([&] { return flow.vorticity(w).maxCoeff(); });
        least = in_range([&] { return flow.vorticity(w).minCoeff(); });
    }

    void write(JsonWriter& json) const {
        ran.write(json);
        json.member("viscosity", viscosity);
        if (std::isfinite(exchange_time))
            json.member("exchange_time", exchange_time);
        json.member("energy", energy);
        json.member("relative_energy", relative_energy);
        json.member("enstrophy", enstrophy);
        json.member("circulation", circulation);
        json.member("divergence", divergence);
        json.member("min_vorticity", least);
        json.member("max_vorticity", most);
        facts.write_conditions(json);
    }

    void write(Text& text) const {
        text("incompressible flow of viscosity {:.6g}, {}\n  {}\n  {}\n", viscosity, ran.in_words(),
             facts.conditions, in_words(facts.stars));
        text("  energy {}{}; enstrophy {}\n", in_digits(energy), in_words(relative_energy),
             in_digits(enstrophy));
        text("  {}divergence {:.2g}; vorticity from {} to {}\n",
             circulation ? fmt::format("circulation {:.3g} in all; ", *circulation) : "",
             divergence, in_digits(least, 6), in_digits(most, 6));
    }
};

/// Steps are measured by how fast the content of cells is exchanged: by the flow, and by walls.
double own_step(const IncompressibleFlow& flow, const Vector& w, const FlowArguments& arguments) {
    const Points& walls = flow.options().wall_velocity;
    const int n = flow.mesh().dimension();
    double time = flow.exchange_time(w);
    if (walls.size() > 0) {
        const double size =
            flow.mesh().unit() * std::pow(flow.mesh().volumes().primal(n).minCoeff(), 1.0 / n);
        time = std::min(time, size / walls.rowwise().norm().maxCoeff());
    }
    const double part = arguments.scheme == FlowScheme::imex ? 0.8 : 0.4;
    return std::min(part * time, arguments.time.until / 20);
}

std::vector<NamedForm> shown(const IncompressibleFlow& flow, const Vector& w) {
    const Discretization& mesh = flow.mesh();
    const int n = mesh.dimension();
    return {flux_vectors("velocity", mesh, {Side::primal, n - 1, w},
                         "the velocity, in units of length/time"),
            NamedForm("vorticity", {Side::primal, n - 2, flow.vorticity(w)},
                      n > 2 ? "the vorticity" : "the vorticity, in units of 1/time"),
            NamedForm("pressure", flow.pressure(w),
                      "the pressure over the density, in units of length^2/time^2")};
}

void run_flow(const FlowArguments& arguments) {
    Log log;
    const Given given(arguments);
    if (!given.vorticity && !given.velocity.given() && !given.boundary.given())
        throw CLI::ValidationError("flow needs --vorticity EXPR, --velocity VECTOR or "
                                   "--boundary-velocity VECTOR: else the fluid stays at rest");
    check_time(arguments.time);
    const Discretization mesh = load(arguments.mesh, log, arguments.time.out);
    const FlowOptions options = given.options(mesh, arguments.flow);
    log.timing.begin("solve");
    const auto flow = computed(log, "factorize", [&] { return IncompressibleFlow(mesh, options); });
    const Vector asked = given.start(mesh, log), start = flow.project(asked);
    log.warn(warning_of_rest(asked, start));
    const TimeSteps steps = time_steps(arguments.time, own_step(flow, start, arguments));
    Flow moving(flow, start, {.time_step = steps.length, .scheme = arguments.scheme});
    log.warn(moving.warnings());
    const FormFacts facts{Side::primal, mesh.dimension() - 1,
                          boundary_in_words(options.facets, mesh.complex()), mesh.chosen_stars()};
    const std::string what =
        fmt::format("an incompressible flow of viscosity {:.6g}", arguments.flow.viscosity);
    const March march{"flow", page_of(log, "flow", facts.beside(what)), steps,
                      [&](const Run&) { return shown(flow, moving.flux()); }};
    const Ran ran = march_to_end(moving, march, arguments.time, mesh, log);
    tell(Flowed(facts, ran, flow, start, moving.flux()), log, arguments.mesh.tell);
}

} // namespace

void add_flow(CLI::App& app) {
    const auto [command, arguments] = add_command<FlowArguments>(
        app, "flow", "solves the equations of incompressible flow (Navier-Stokes, Euler)",
        run_flow);
    auto* vorticity = command->add_option(
        "--vorticity", arguments->vorticity,
        "EXPR\ton surfaces, vorticity at time 0 (a file has a number for each vertex), of a flow "
        "without harmonic part");
    command
        ->add_option("--velocity", arguments->velocity,
                     "VECTOR\tvelocity at time 0, such as '-y; x; 0'; its divergence-free part is "
                     "used, on surfaces its tangential part")
        ->excludes(vorticity);
    command
        ->add_option("--viscosity", arguments->flow.viscosity,
                     "NU\tviscosity (default: 0, Euler's equations)")
        ->check(check_not_negative);
    command->add_option("--rotation", arguments->rotation,
                        "EXPR\ton surfaces, vorticity of the frame, such as '2*z' on a planet");
    add_mesh_arguments(*command, arguments->mesh, StarKind::automatic);
    command->add_option("--boundary-velocity", arguments->boundary_velocity,
                        "VECTOR\tvelocity on the boundary: inflow, outflow, and motion of no-slip "
                        "walls");
    command->add_option("--no-slip-where", arguments->no_slip_where,
                        "EXPR\tno-slip walls at boundary facets where this is not 0; all others "
                        "have free slip, or are open");
    command->add_option("--open-where", arguments->open_where,
                        "EXPR\topen facets, with free inflow and outflow at total pressure 0");
    command->add_option("--no-slip-on", arguments->no_slip_on,
                        "GROUP ..\tno-slip walls in these physical groups (name or number), which "
                        "--keep-groups keeps apart");
    command->add_option("--open-on", arguments->open_on, "GROUP ..\topen facets in these groups");
    add_time(*command, arguments->time, "0.4 of the initial exchange time of a cell, 0.8 for imex");
    command
        ->add_option("--scheme", arguments->scheme,
                     "NAME\tmidpoint (order 2, conserves energy without viscosity) or imex (order "
                     "3, does not iterate)")
        ->transform(enumerator({"midpoint", "imex"}))
        ->default_str("midpoint");
    add_engine(*command, arguments->flow.linear_solver);
    command->footer(
        "Walls have free slip by default. On closed surfaces, the circulations\n"
        "around all vertices add up to 0.\n\n"
        "Examples:\n"
        "  polydec flow sphere.off --vorticity 'exp(-20*(x-1)^2-20*y^2)' --until 20 -o flow.html\n"
        "  polydec flow square.off --viscosity .01 --no-slip-where 1 \\\n"
        "      --boundary-velocity '(y>.999)*1; 0; 0' --scheme imex --until 20 -o cavity.pvd \\\n"
        "      --checkpoint cavity.checkpoint --resume");
}

} // namespace polydec::tools
