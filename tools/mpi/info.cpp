// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "dec/stars/star.h"
#include "distributed/connected.h"
#include "distributed/piece_rows.h"
#include "io/diagnosis_json.h"
#include "meshes/unit_of_length.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <map>
#include <set>

namespace polydec::tools {

namespace {

/// What `info` tells of a mesh as far as it is known without homology.
struct SharedInfo {
    std::string mesh;
    int dimension = 0, ambient_dimension = 0;
    BeforeAndAfter<std::vector<GlobalIndex>> cells;
    BeforeAndAfter<GlobalIndex> euler;
    GlobalIndex components = 0;
    bool orientable = true;
    std::optional<double> volume;
    GlobalIndex degenerate = 0, boundary_degenerate = 0, branching_degenerate = 0;
    std::vector<StarNumbers> stars;
    std::map<GlobalIndex, GlobalIndex> vertices_per_cell;
    GlobalIndex merged_simplices = 0; ///< pieces of cells of several pieces

    void write(JsonWriter& json) const {
        json.member("dimension", dimension);
        json.member("ambient_dimension", ambient_dimension);
        json.object("cells", [&] {
            json.member("input", cells.input);
            json.member("merged", cells.merged);
        });
        json.object("euler", [&] {
            json.member("input", euler.input);
            json.member("merged", euler.merged);
        });
        json.member("components", components);
        json.member("orientable", orientable);
        json.member("volume", volume);
        json.object("facets", [&] {
            json.member("degenerate", degenerate);
            json.member("boundary_degenerate", boundary_degenerate);
            json.member("branching_degenerate", branching_degenerate);
        });
        write_star_numbers(json, "stars", stars);
        json.object("vertices_per_cell", [&] {
            for (const auto& [vertices, count] : vertices_per_cell)
                json.member(std::to_string(vertices), count);
        });
        if (dimension < 3 && dimension > 1)
            json.object("concyclic", [&] {
                json.member("edges", cells.input[1] - cells.merged[1]);
                json.member("faces", merged_simplices);
                json.member("percent", 100.0 * static_cast<double>(merged_simplices) /
                                           static_cast<double>(cells.input[2]));
            });
    }

    void write(Text& text) const {
        text("{}\ndimension {} in {} coordinates, volume {}\n", printable(mesh), dimension,
             ambient_dimension, in_digits(volume, 6));
        text("cells of degree 0 .. {}\n  input    {}\n  merged   {}\n", dimension,
             fmt::join(cells.input, ", "), fmt::join(cells.merged, ", "));
        std::vector<std::string> sizes;
        for (const auto& [vertices, count] : vertices_per_cell)
            sizes.push_back(fmt::format("{} with {}", count, vertices));
        text("  merged {}-cells by vertices: {}\n", dimension, fmt::join(sizes, ", "));
        text("topology\n  Euler characteristic {}, components {}, {}\n", euler.input, components,
             orientable ? "orientable" : "not orientable");
        text("degenerate dual edges\n  {} between two cells, {} on the boundary, {} at branching "
             "facets\n",
             degenerate, boundary_degenerate, branching_degenerate);
        text("Hodge stars after merging\n  {:<7}{:>14}{:>14}{:>14}{:>10}{:>8}\n", "degree", "min",
             "max", "min abs", "negative", "zero");
        for (std::size_t k = 0; k < stars.size(); ++k)
            text("  {:<7}{:>14}{:>14}{:>14}{:>10}{:>8}\n", k, in_digits(stars[k].min, 6),
                 in_digits(stars[k].max, 6), in_digits(stars[k].min_abs, 6), stars[k].negative,
                 stars[k].zero);
    }
};

StarNumbers star_numbers(const Ranks& ranks, const DistributedMesh& mesh, int k) {
    const HodgeStar star(mesh.cells.volumes, k);
    const Vector own = star.diagonal();
    const int power = mesh.dimension() - 2 * k;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool any = own.size() > 0;
    const auto shown = [&](double value) { return in_input_units(value, mesh.unit, power); };
    const double largest = ranks.largest(any ? own.cwiseAbs().maxCoeff() : 0.0),
                 least = ranks.least(any ? own.cwiseAbs().minCoeff() : infinity);
    StarNumbers numbers;
    numbers.min = shown(ranks.least(any ? own.minCoeff() : infinity));
    numbers.max = shown(ranks.largest(any ? own.maxCoeff() : -infinity));
    numbers.min_abs = shown(least);
    numbers.negative =
        static_cast<std::size_t>(ranks.sum(static_cast<GlobalIndex>(star.negatives().size())));
    numbers.zero =
        static_cast<std::size_t>(ranks.sum(static_cast<GlobalIndex>(star.zeros().size())));
    if (numbers.zero == 0)
        numbers.condition = largest / least;
    return numbers;
}

/// How many cells have so many vertices, and how many simplices are not alone in theirs.
void count_vertices(const Ranks& ranks, const DistributedMesh& mesh, SharedInfo& info) {
    const LocalComplex& local = mesh.local;
    const int n = mesh.dimension();
    const Simplices& tops = local.complex.simplices(n);
    const OwnPieces pieces(ranks, local, mesh.cells.degree(n), n);
    const auto write = [&](Index t, GlobalIndex* corners) {
        for (const Index v : tops.row(t))
            *corners++ = local.vertices[v];
    };
    std::map<GlobalIndex, GlobalIndex> own;
    GlobalIndex merged = 0;
    Index left = 0; // pieces of the cell that are still to come
    std::set<GlobalIndex> of_cell;
    pieces.visit<GlobalIndex>(n + 1, write, [&](Index cell, const GlobalIndex* corners) {
        if (left == 0) {
            left = pieces.begins()[cell + 1] - pieces.begins()[cell];
            merged += left > 1 ? left : 0;
        }
        of_cell.insert(corners, corners + n + 1);
        if (--left == 0) {
            ++own[std::ssize(of_cell)];
            of_cell.clear();
        }
    });
    info.merged_simplices = ranks.sum(merged);
    struct Count {
        GlobalIndex vertices, cells;
    };
    std::vector<Count> counts;
    for (const auto& [vertices, cells] : own)
        counts.push_back({vertices, cells});
    for (const auto& [vertices, cells] : ranks.of_all(counts))
        info.vertices_per_cell[vertices] += cells;
}

void run_info(const Ranks& ranks, const SharedArguments& arguments) {
    Log log = log_of(ranks);
    const DistributedMesh mesh = load(ranks, arguments, log);
    log.timing.begin("diagnose");
    const int n = mesh.dimension();
    SharedInfo info;
    info.mesh = arguments.mesh.mesh.string();
    info.dimension = n;
    info.ambient_dimension = static_cast<int>(mesh.places.cols());
    for (int k = 0; k <= n; ++k) {
        const GlobalIndex input = mesh.local.degree(k).count, merged = mesh.cells.degree(k).count;
        info.cells.input.push_back(input);
        info.cells.merged.push_back(merged);
        info.euler.input += k % 2 == 0 ? input : -input;
        info.euler.merged += k % 2 == 0 ? merged : -merged;
        info.stars.push_back(star_numbers(ranks, mesh, k));
    }
    info.components = component_count(ranks, mesh.local);
    info.orientable = mesh.local.orientable;
    info.volume = in_input_units(ranks.sum(mesh.cells.volumes.primal(n).sum()), mesh.unit, n);
    info.degenerate = mesh.merged.degenerate_interior;
    info.boundary_degenerate = mesh.merged.degenerate_boundary;
    info.branching_degenerate = mesh.merged.degenerate_branching;
    count_vertices(ranks, mesh, info);
    tell(ranks, mesh, info, log, arguments.mesh.tell);
}

} // namespace

void add_shared_info(CLI::App& app, const Ranks& ranks) {
    const auto [command, arguments] = add_command<SharedArguments>(
        app, "info", "describes the mesh before and after merging",
        [ranks](const SharedArguments& given) { run_info(ranks, given); });
    add_shared_arguments(*command, *arguments);
    refuse_options(*command, {"--star", "--out"});
    command->footer("`polydec info` also reports Betti numbers and properties of the operators.\n"
                    "\n"
                    "Example:\n"
                    "  mpirun -n 4 polydec-mpi info engine.pdm --json");
}

} // namespace polydec::tools
