// SPDX-License-Identifier: MIT
#include "tools/common.h"

#include "base/errors.h"
#include "dec/advice.h"
#include "dec/stars/star_kind.h"
#include "examples/paper/console.h"
#include "io/meshes/length_file.h"
#include "meshes/peel.h"
#include "meshes/periodic.h"
#include "tools/component_values.h"
#include "tools/messages.h"
#include "tools/options.h"

#include <fmt/format.h>

#include <array>
#include <set>
#include <unistd.h>
#include <variant>
#include <vector>

namespace polydec::tools {

namespace {

constexpr std::array star_kinds{StarKind::circumcentric, StarKind::hybrid, StarKind::galerkin,
                                StarKind::barycentric, StarKind::automatic};

}

StarKind star_kind(const std::string& text) {
    for (const StarKind kind : star_kinds)
        if (text == name(kind))
            return kind;
    return StarKind::circumcentric;
}

namespace {

/// What was read may have points or lengths alone, or be glued.
template <class Read>
Discretization discretize_checked(const MeshArguments& arguments, Read mesh,
                                  const DiscretizeOptions& options,
                                  const std::function<void(std::string_view)>& stage) {
    if (arguments.angle_tolerance && mesh.dimension() != 2)
        throw InvalidInput(fmt::format("--angle-tolerance is for surfaces, but {} has cells of "
                                       "dimension {}: use --tolerance",
                                       arguments.mesh.string(), mesh.dimension()));
    if (options.delaunay != Delaunay::off && mesh.dimension() != 2)
        throw InvalidInput(fmt::format("--delaunay is for surfaces, but {} has cells of dimension "
                                       "{}: leave it out",
                                       arguments.mesh.string(), mesh.dimension()));
    if (options.star == StarKind::hybrid && mesh.dimension() != 2)
        throw InvalidInput(fmt::format("--star hybrid is for surfaces, but {} has cells of "
                                       "dimension {}: take galerkin or automatic",
                                       arguments.mesh.string(), mesh.dimension()));
    return discretize(std::move(mesh), options, stage);
}

/// With zeros for coordinates that are left out, as 1,0 of a plane in space.
Vector translation(const std::string& text, Index coordinates) {
    Vector result = *vector_of(text);
    if (result.size() < coordinates)
        result.conservativeResizeLike(Vector::Zero(coordinates));
    return result;
}

/// Where the translations and other isometries take the vertices.
std::vector<Points> images(const Mesh& mesh, const MeshArguments& arguments) {
    std::vector<Points> result;
    const Index coordinates = mesh.ambient_dimension();
    for (const std::string& text : arguments.glue) {
        const ComponentValues map("--glue", text);
        result.push_back(mesh.points);
        if (map.size() + 1 == coordinates) // x+1; 1-y of a plane in space
            result.back().leftCols(map.size()) = map.at(mesh.points, map.size());
        else
            result.back() = map.at(mesh.points, coordinates);
    }
    for (const std::string& period : arguments.periods) {
        const Vector by = translation(period, coordinates);
        result.emplace_back(); // nowhere, if it has more coordinates, which is told
        if (by.size() == coordinates)
            result.back() = mesh.points.rowwise() + by.transpose();
    }
    return result;
}

/// What a file holds, glued along translations and isometries, or as it is.
std::variant<Mesh, LengthMesh, PeriodicMesh> read_glued(const MeshArguments& arguments) {
    if (is_length_file(arguments.mesh)) {
        if (!arguments.periods.empty() || !arguments.glue.empty())
            throw InvalidInput(
                fmt::format("{}: a file of lengths has no places that are taken to others; glue it "
                            "by giving vertices on both sides one number",
                            arguments.glue.empty() ? "--periodic" : "--glue"));
        if (arguments.joining.are_given())
            throw InvalidInput(
                fmt::format("{}: a file of lengths has no places at which vertices could coincide; "
                            "give those that are to be joined one number",
                            arguments.joining.hanging ? "--join-hanging" : "--weld"));
        return read_lengths(arguments.mesh);
    }
    Mesh mesh = read_joined(arguments.mesh, arguments.joining);
    if (arguments.peel)
        mesh = peeled(std::move(mesh));
    if (!arguments.glue.empty()) {
        const auto taken = images(mesh, arguments);
        return glue_by_images(std::move(mesh), taken);
    }
    if (arguments.periods.empty())
        return mesh;
    std::vector<Vector> translations;
    for (const std::string& period : arguments.periods)
        translations.push_back(translation(period, mesh.ambient_dimension()));
    return periodic(std::move(mesh), translations);
}

} // namespace

CLI::Option* add_merge_arguments(CLI::App& command, MeshArguments& arguments,
                                 const std::string& mesh_help) {
    command.add_option("MESH", arguments.mesh, mesh_help)->required();
    auto* tolerance = command.add_option("--tolerance", arguments.tolerance,
                                         "merge facets with relative dual length up to this");
    tolerance->capture_default_str()->check(check_not_negative);
    auto* angle = command.add_option("--angle-tolerance", arguments.angle_tolerance,
                                     "merge by opposite angles instead, radians (surfaces)");
    angle->check(check_not_negative)->excludes(tolerance);
    auto* none = command.add_flag("!--no-merge", arguments.merge, "merge nothing");
    none->excludes(tolerance)->excludes(angle);
    add_common_options(command, arguments.tell);
    command.add_flag("--timing", arguments.tell.timing, "tell the seconds each stage took");
    return angle;
}

MergeOptions merge_options(const MeshArguments& arguments) {
    if (!arguments.merge)
        return {MergeCriterion::none, arguments.tolerance};
    if (arguments.angle_tolerance)
        return {MergeCriterion::angle, *arguments.angle_tolerance};
    return {MergeCriterion::dual_length, arguments.tolerance};
}

void add_mesh_arguments(CLI::App& command, MeshArguments& arguments) {
    auto* angle =
        add_merge_arguments(command, arguments,
                            "mesh file: .off .obj .ply .stl .mesh .msh .node .ele .vtk .vtu .nsc;\n"
                            "polygons become Delaunay triangles, hexahedra, wedges and pyramids\n"
                            "tetrahedra; of cells of higher order the corners are read\n"
                            ".pdm, or .nsl, which has lengths of edges alone");
    command
        .add_option("--centers", arguments.centers,
                    "where dual cells have their corners: circumcenters, or centroids,\n"
                    "which make every dual positive but are less exact (nothing merges)")
        ->capture_default_str()
        ->check(CLI::IsMember({"circumcenters", "centroids"}));
    auto* groups = command.add_flag("--keep-groups", arguments.keep_groups,
                                    "merge no cells of different physical groups");
    command
        .add_option("--periodic", arguments.periods,
                    "glue the mesh to itself along this translation, such as 1,0; may be\n"
                    "given again. Expressions and pictures are on the mesh that was glued")
        ->check(check_vector);
    command.add_option("--glue", arguments.glue,
                       "glue it along an isometry as well, given by where it takes a point,\n"
                       "such as 'x+1; 1-y'");
    add_joining(command, arguments.joining);
    command.add_flag("--peel", arguments.peel,
                     "leave out flat cells on the boundary of a solid first");
    command
        .add_flag("--delaunay{flips}", arguments.delaunay,
                  "flip edges of a surface first, so that no dual is negative;\n"
                  "=split-boundary divides boundary edges too")
        ->check(CLI::IsMember({"flips", "split-boundary"}))
        ->excludes(angle)
        ->excludes(groups);
}

void add_star(CLI::App& command, MeshArguments& arguments, StarKind kind) {
    arguments.star = name(kind);
    std::set<std::string> kinds;
    for (const StarKind known : star_kinds)
        kinds.insert(name(known));
    command
        .add_option("--star", arguments.star,
                    "inner products of forms: circumcentric (dual over primal volume),\n"
                    "galerkin (Whitney forms; positive on every mesh), hybrid (surfaces:\n"
                    "galerkin where circumcentric is not positive), barycentric\n"
                    "(inconsistent for degrees 1 .. n-1), or automatic: the first of\n"
                    "circumcentric, hybrid and galerkin that is positive here")
        ->capture_default_str()
        ->check(CLI::IsMember(kinds));
}

CLI::Option* add_side(CLI::App& command, Side& side) {
    const auto read = [](std::string& text) {
        for (const Side known : {Side::primal, Side::dual})
            if (text == name(known)) {
                text = std::to_string(static_cast<int>(known));
                return std::string();
            }
        return fmt::format("expected primal or dual, not '{}'", text);
    };
    return command.add_option("--side", side, "where the forms live: primal or dual cells")
        ->transform(CLI::Validator(read, "primal|dual"));
}

Discretization load(const MeshArguments& arguments, Log& log) {
    const Progress progress;
    const auto stage = [&](std::string_view what) {
        log.timing.begin(what);
        progress(what);
    };
    const MergeOptions merging = merge_options(arguments);
    DiscretizeOptions options;
    options.criterion = merging.criterion;
    options.tolerance = merging.tolerance;
    if (!arguments.delaunay.empty())
        options.delaunay =
            arguments.delaunay == "flips" ? Delaunay::flips : Delaunay::flips_and_splits;
    if (arguments.centers == "centroids")
        options.centers = Centers::centroids();
    if (arguments.keep_groups)
        options.materials = Materials::keep_apart;
    options.star = star_kind(arguments.star);

    stage("read");
    auto result = computed_on(arguments.mesh, [&] {
        return std::visit(
            [&](auto given) {
                return discretize_checked(arguments, std::move(given), options, stage);
            },
            read_glued(arguments));
    });
    log.timing.end();
    log.warn(result.warnings());
    return result;
}

std::string in_words(const ChosenStars& stars) {
    if (stars.kind == StarKind::hybrid)
        return fmt::format("hybrid stars, Galerkin's on {:.3g} % of the cells",
                           100 * stars.galerkin_share());
    return fmt::format("{} stars", name(stars.kind));
}

Progress::Progress() : visible_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (visible_)
        console::tell("\r\033[K");
}

void Progress::operator()(std::string_view what) const {
    if (!visible_)
        return;
    console::tell(fmt::format("\r\033[K{} ..", what));
}

} // namespace polydec::tools
