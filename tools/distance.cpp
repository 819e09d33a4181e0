// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "base/lists.h"
#include "dec/discretization/cell_data.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/chosen_cells.h"
#include "io/meshes/mesh_files.h"
#include "io/pictures/draw_cells.h"
#include "io/source_file.h"
#include "solvers/surfaces/geodesic_distance.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/expression.h"
#include "tools/form_values.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

namespace polydec::tools {

namespace {

struct DistanceArguments {
    MeshArguments mesh;
    GeodesicOptions geodesic;
    std::vector<std::string> from, from_on;
    std::vector<Index> to;
    std::string from_where;
    PictureArguments picture;
};

/// A shortest path, from a vertex of the file.
struct ToldPath {
    Index to;
    SurfacePath path;
};

/// "exact up to rounding", or the accuracy of the other method.
const char* accuracy(DistanceMethod method) {
    return method == DistanceMethod::exact ? "exact up to rounding" : "smoothed by the heat method";
}

/// The points that it passes, with those on both sides of a seam.
std::vector<std::vector<double>> points_of(const Mesh& lines) {
    std::vector<std::vector<double>> points;
    for (Eigen::Index i = 0; i < lines.points.rows(); ++i) {
        const auto row = lines.points.row(i);
        std::vector<double> point(row.begin(), row.end());
        if (points.empty() || i % 2 == 1 || (row - lines.points.row(i - 1)).norm() > 1e-12)
            points.push_back(std::move(point));
    }
    return points;
}

struct Distances {
    DistanceMethod method = DistanceMethod::exact;
    std::vector<Index> from;
    Index farthest = 0;
    Index raised = 0; ///< negative values, raised to 0
    double max = 0, mean = 0;
    std::vector<ToldPath> paths; ///< with the sources' numbers in the file

    void write(JsonWriter& json) const {
        json.member("from", from);
        json.member("farthest", farthest);
        json.member("max", max);
        json.member("mean", mean);
        json.member("raised", raised);
        json.member("method", name(method));
        if (paths.empty())
            return;
        json.objects("paths", paths, [&](const auto& one) {
            json.member("to", one.to);
            json.member("from", one.path.source);
            json.member("length", one.path.length);
            json.member("points", points_of(one.path.lines));
        });
    }

    void write(Text& text) const {
        text("distance along the surface, {} source{}\n  farthest: vertex {} at {:.10g}\n  mean "
             "over the vertices: {:.10g}\n  {}\n",
             from.size(), from.size() == 1 ? "" : "s", farthest, max, mean, accuracy(method));
        for (const auto& [to, path] : paths)
            text("  path from vertex {} to {}: {} straight piece{} of length {:.10g}\n",
                 path.source, to, path.lines.simplices.rows(),
                 path.lines.simplices.rows() == 1 ? "" : "s", path.length);
    }
};

/// The 0-cells that the options choose, ascending.
std::vector<Index> sources(const Discretization& mesh, const DistanceArguments& arguments,
                           const std::optional<SiteValues>& where) {
    std::vector<Index> cells, numbers;
    if (!arguments.from_on.empty())
        cells = vertices_on(mesh, arguments.from_on);
    if (where) {
        const Vector values = vertex_values(mesh, *where, cell_centers(mesh, 0));
        for (Index v = 0; v < values.size(); ++v)
            if (values[v] != 0)
                cells.push_back(v);
        if (values.isZero(0))
            throw InvalidInput(fmt::format("--from-where is 0 at all {} vertices", values.size()));
    }
    for (const auto& word : arguments.from)
        if (word == "boundary")
            for (const Index v : boundary_vertices(mesh))
                cells.push_back(v);
        else
            numbers.push_back(group_tag({}, 0, word).value());
    const auto named = cells_of_vertices(mesh, "--from", numbers);
    cells.insert(cells.end(), named.begin(), named.end());
    sort_unique(cells);
    return cells;
}

std::vector<Index> numbers_of(const Discretization& mesh, std::vector<Index> cells) {
    for (Index& cell : cells)
        cell = cell_vertices(mesh, 0, cell).front();
    return cells;
}

/// Whether paths or isolines are asked for, which windows tell.
bool wants_windows(const DistanceArguments& arguments) {
    return arguments.geodesic.method == DistanceMethod::exact &&
           (!arguments.to.empty() || arguments.picture.isolines > 0);
}

std::vector<ToldPath> paths_to(const Discretization& mesh, const DistanceArguments& arguments,
                               const SurfacePaths& paths) {
    std::vector<ToldPath> told;
    for (const Index v : arguments.to) {
        told.push_back({v, paths.from(cells_of_vertices(mesh, "--to", {v}).front())});
        Index& source = told.back().path.source;
        source = numbers_of(mesh, {source}).front();
    }
    return told;
}

/// All paths, as segments, each with the number of the path and its length.
LevelSets lines_of(const std::vector<ToldPath>& paths) {
    LevelSets all;
    Eigen::Index rows = 0, width = 0;
    for (const auto& told : paths) {
        rows += told.path.lines.simplices.rows();
        width = told.path.lines.points.cols();
    }
    all.mesh.points.resize(2 * rows, width);
    all.mesh.simplices.resize(rows, 2);
    Index at = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const Mesh& lines = paths[i].path.lines;
        all.mesh.points.middleRows(2 * Eigen::Index(at), lines.points.rows()) = lines.points;
        for (Eigen::Index s = 0; s < lines.simplices.rows(); ++s, ++at) {
            all.mesh.simplices.row(at) << 2 * at, 2 * at + 1;
            all.levels.push_back(static_cast<Index>(i));
            all.owners.push_back(static_cast<Index>(i));
        }
    }
    return all;
}

void write_lines(const DistanceArguments& arguments, const LevelSets& lines, const Vector& levels,
                 const char* array) {
    if (lower_extension(arguments.picture.out) == ".obj")
        return write_mesh(arguments.picture.out, lines.mesh);
    write_vtu(arguments.picture.out, draw_levels(lines, levels, array), arguments.picture.vtu);
}

void draw(const Discretization& mesh, const DistanceArguments& arguments, const Distances& answer,
          const Vector& distance, const SurfacePaths* windows, const Log& log) {
    if (windows != nullptr && arguments.picture.isolines > 0) {
        const Vector levels = equal_levels(distance, arguments.picture.isolines);
        return write_lines(arguments, windows->isolines(levels), levels, "distance");
    }
    const LevelSets lines = lines_of(answer.paths);
    if (!answer.paths.empty() && !is_page(arguments.picture.out)) {
        Vector lengths(answer.paths.size());
        for (Eigen::Index i = 0; i < lengths.size(); ++i)
            lengths[i] = answer.paths[std::size_t(i)].path.length;
        return write_lines(arguments, lines, lengths, "length");
    }
    const auto& from = answer.from;
    const std::string fact =
        fmt::format("Distance along the surface from {}, {}.",
                    from.size() > 9 ? fmt::format("{} vertices", from.size())
                                    : fmt::format("vertex {}", fmt::join(from, ", ")),
                    accuracy(answer.method));
    const NamedForm form("distance", {Side::primal, 0, distance}, "in units of length of the file");
    write_picture(arguments.picture, mesh, {form}, page_of(log, "geodesic distance", {fact}),
                  {{"from", from}}, log, lines.mesh);
}

void run_distance(const DistanceArguments& arguments) {
    Log log;
    const auto where = if_given<SiteValues>("--from-where", arguments.from_where);
    if (!where && arguments.from.empty() && arguments.from_on.empty())
        throw CLI::ValidationError(
            "distance needs sources: --from VERTEX, --from-where EXPR or --from-on GROUP");
    check_picture(arguments.picture);
    const Discretization mesh = load(arguments.mesh, log);
    if (mesh.dimension() != 2)
        throw InvalidInput(fmt::format("{} has cells of dimension {}: distances need a surface",
                                       arguments.mesh.mesh.string(), mesh.dimension()));
    if (!arguments.picture.out.empty())
        check_drawable(mesh);
    if (!arguments.to.empty() && arguments.geodesic.method == DistanceMethod::heat)
        throw InvalidInput("--to: shortest paths need exact distances; omit --method heat");
    log.timing.begin("solve");
    const auto chosen = sources(mesh, arguments, where);
    const auto from = numbers_of(mesh, chosen);
    const auto found = computed(
        log, "solve", [&] { return GeodesicDistance(mesh, arguments.geodesic).to(chosen); });
    const Vector& distance = found.values;
    log.warn(found.warnings);
    Eigen::Index farthest = 0;
    distance.maxCoeff(&farthest);
    Distances answer;
    answer.method = arguments.geodesic.method;
    answer.from = from;
    answer.farthest = cell_vertices(mesh, 0, static_cast<Index>(farthest)).front();
    answer.max = distance[farthest];
    answer.mean = distance.mean();
    answer.raised = found.raised;
    std::optional<SurfacePaths> windows;
    if (wants_windows(arguments))
        windows.emplace(mesh, chosen);
    if (!arguments.to.empty())
        answer.paths = paths_to(mesh, arguments, *windows);
    if (!arguments.picture.out.empty()) {
        log.timing.begin("write");
        draw(mesh, arguments, answer, distance, windows ? &*windows : nullptr, log);
    }
    tell(answer, log, arguments.mesh.tell);
}

} // namespace

void add_distance(CLI::App& app) {
    const auto [command, arguments] = add_command<DistanceArguments>(
        app, "distance", "computes geodesic distances from vertices, exactly", run_distance);
    command
        ->add_option("--from", arguments->from,
                     "VERTEX ..\tsources by number, or `boundary` for all boundary vertices")
        ->check([](const std::string& word) {
            return word == "boundary" || group_tag({}, 0, word)
                       ? std::string()
                       : fmt::format("expected a whole number or boundary, not '{}'", word);
        });
    command->add_option("--from-where", arguments->from_where,
                        "EXPR\tsources: vertices where this is not 0");
    command->add_option("--from-on", arguments->from_on,
                        "GROUP ..\tsources: vertices of these physical groups (name or number)");
    command->add_option("--to", arguments->to,
                        "VERTEX ..\talso find shortest paths to these; a page draws them too, a "
                        ".vtu file has only the paths");
    command
        ->add_option("--method", arguments->geodesic.method,
                     "NAME\texact (length of a shortest path, up to rounding) or heat (smoothed, "
                     "off by some percent of the greatest distance)")
        ->transform(enumerator({name(DistanceMethod::exact), name(DistanceMethod::heat)}))
        ->default_str(name(DistanceMethod::exact));
    command->add_option(
        "--time-scale", arguments->geodesic.time_scale,
        "C\tfor --method heat: heat flows for C times the squared mean edge length");
    add_mesh_arguments(*command, arguments->mesh);
    add_picture(*command, arguments->picture, "the distances");
    add_isolines(*command, arguments->picture);
    command->get_option("--isolines")->excludes("--to");
    add_engine(*command, arguments->geodesic.linear_solver);
    command->footer("Every component of the surface needs a source. Exact distances depend only on "
                    "the shape, not on its division into triangles. The heat method is inaccurate "
                    "where triangles are far from Delaunay: use --delaunay there.\n\nExamples:\n"
                    "  polydec distance bunny.ply --from 0 -o distance.vtu\n"
                    "  polydec distance bunny.ply --from 0 --to 1200 870 -o paths.html\n"
                    "  polydec distance plate.msh --from boundary -o distance.html\n"
                    "  polydec distance plate.msh --from-where 'x < .01' --json\n"
                    "  polydec distance part.stl --delaunay --method heat --from 12 871 --json");
}

} // namespace polydec::tools
