// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "meshes/unit_of_length.h"
#include "solvers/surfaces/geodesic_distance.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/messages.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <numeric>

namespace polydec::tools {

namespace {

struct DistanceArguments {
    MeshArguments mesh;
    GeodesicOptions geodesic;
    std::vector<Index> from;
    PictureArguments picture;
};

/// The 0-cells of these vertices of the input.
std::vector<Index> cells_of(const Discretization& mesh, const std::vector<Index>& vertices) {
    const auto& K = mesh.input();
    std::vector<Index> numbers(static_cast<std::size_t>(K.size(0))), cells;
    std::iota(numbers.begin(), numbers.end(), 0);
    numbers = K.vertex_numbers(std::move(numbers));
    for (const Index v : vertices) {
        const auto place = std::lower_bound(numbers.begin(), numbers.end(), v);
        if (place == numbers.end() || *place != v)
            throw InvalidInput(fmt::format("--from {}: no triangle has such a vertex; vertices are "
                                           "numbered from 0, the last one is {}",
                                           v, numbers.back()));
        cells.push_back(static_cast<Index>(place - numbers.begin()));
    }
    return cells;
}

void draw(const Discretization& mesh, const DistanceArguments& arguments, const Vector& distance,
          const Log& log) {
    PageText text;
    text.title = fmt::format("{}: geodesic distance", arguments.mesh.mesh.filename().string());
    text.facts = {fmt::format("Distance along the surface from vertex {}, by the heat method.",
                              fmt::join(arguments.from, ", "))};
    const NamedForm form("distance", {Side::primal, 0, distance}, "in units of length of the file");
    write_picture(arguments.picture, mesh, {form}, std::move(text), {{"from", arguments.from}},
                  log);
}

struct Distances : Answer {
    std::vector<Index> from;
    Index farthest = 0;
    Index raised = 0; ///< values below 0 that were raised to it
    double max = 0, mean = 0;

    void write(JsonWriter& json) const override {
        json.member("from", from);
        json.member("farthest", farthest);
        json.member("max", max);
        json.member("mean", mean);
        json.member("raised", raised);
    }

    void write(Text& text) const override {
        text("distance along the surface, {} source{}\n  farthest: vertex {} at {:.10g}\n  mean "
             "over the vertices: {:.10g}\n",
             from.size(), from.size() == 1 ? "" : "s", farthest, max, mean);
    }
};

void run_distance(const DistanceArguments& arguments) {
    Log log;
    check_picture(arguments.picture, arguments.mesh.mesh);
    const Discretization mesh = load(arguments.mesh, log);
    if (mesh.dimension() != 2)
        throw InvalidInput(fmt::format("{} has cells of dimension {}: distances are found on "
                                       "surfaces",
                                       arguments.mesh.mesh.string(), mesh.dimension()));
    if (!arguments.picture.out.empty())
        check_drawable(mesh);
    log.timing.begin("solve");
    const auto sources = cells_of(mesh, arguments.from);
    const auto found = computed_on(arguments.mesh.mesh, [&] {
        const Progress progress;
        progress("solve");
        return GeodesicDistance(mesh, arguments.geodesic).to(sources);
    });
    const Vector& distance = found.values;
    const Index raised = found.raised;
    log.warn(found.warnings);
    if (!arguments.picture.out.empty()) {
        log.timing.begin("write");
        draw(mesh, arguments, distance, log);
    }

    Eigen::Index farthest = 0;
    distance.maxCoeff(&farthest);
    Distances answer;
    answer.from = arguments.from;
    answer.farthest = cell_vertices(mesh, 0, static_cast<Index>(farthest)).front();
    answer.max = distance[farthest];
    answer.mean = distance.mean();
    answer.raised = raised;
    tell(answer, log, arguments.mesh.tell);
}

} // namespace

void add_distance(CLI::App& app) {
    auto* command =
        app.add_subcommand("distance", "geodesic distance from vertices, by the heat method");
    const auto arguments = std::make_shared<DistanceArguments>();
    add_mesh_arguments(*command, arguments->mesh);
    command->add_option("--from", arguments->from, "the vertices it is 0 at")->required();
    command
        ->add_option("--time-scale", arguments->geodesic.time_scale,
                     "heat flows for this times the squared mean length of edges")
        ->capture_default_str();
    add_picture(*command, arguments->picture, "the distances");
    add_isolines(*command, arguments->picture);
    command->add_option("--engine", arguments->geodesic.linear_solver, "linear solver")
        ->capture_default_str();
    command->footer("Every component of the surface needs a vertex. Triangles far from Delaunay "
                    "spoil the\nresult: --delaunay helps.\n\nExamples:\n"
                    "  polydec distance bunny.ply --from 0 -o distance.vtu\n"
                    "  polydec distance part.stl --delaunay --from 12 871 --json");
    command->callback([arguments] { run_distance(*arguments); });
}

} // namespace polydec::tools
