// SPDX-License-Identifier: MIT
#include "tools/common.h"

#include "base/errors.h"
#include "dec/discretization/advice.h"
#include "dec/stars/star.h"
#include "examples/paper/console.h"
#include "io/diagnosis_json.h"
#include "io/meshes/mesh_files.h"
#include "meshes/periodic.h"
#include "meshes/tidy.h"
#include "tools/component_values.h"
#include "tools/outputs.h"

#include <fmt/format.h>

#include <unistd.h>
#include <variant>
#include <vector>

namespace polydec::tools {

namespace {

/// What was read may have points or lengths alone, or be glued.
template <class Read>
Discretization discretize_checked(const MeshArguments& arguments, Read mesh,
                                  const DiscretizeOptions& options, const Progress& stage) {
    const auto check = [&](bool is_asked, const char* option, const char* remedy) {
        if (is_asked && mesh.dimension() != 2)
            throw InvalidInput(
                fmt::format("{} is for surfaces, but {} has cells of dimension {}: {}", option,
                            arguments.mesh.string(), mesh.dimension(), remedy));
    };
    check(arguments.angle_tolerance.has_value(), "--angle-tolerance", "use --tolerance");
    check(options.delaunay != Delaunay::off, "--delaunay", "omit the option");
    check(options.star == StarKind::hybrid, "--star hybrid", "use galerkin or automatic");
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
            throw InvalidInput(fmt::format("{}: a file of lengths has no points to map; to glue "
                                           "it, give vertices on both sides the same number",
                                           arguments.glue.empty() ? "--periodic" : "--glue"));
        if (arguments.joining.are_given())
            throw InvalidInput(
                fmt::format("{}: a file of lengths has no points that could coincide; to join "
                            "vertices, give them the same number",
                            arguments.joining.hanging ? "--join-hanging" : "--weld"));
        if (arguments.peel)
            throw InvalidInput("--peel: a file of lengths has no points to tell flat cells by; "
                               "remove the cells from the file");
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
    command.add_option("MESH", arguments.mesh, mesh_help)->required()->each(note_input);
    auto* tolerance = command.add_option("--tolerance", arguments.tolerance,
                                         "T\tmerge across facets of relative dual length up to T");
    tolerance->check(check_not_negative);
    auto* angle =
        command.add_option("--angle-tolerance", arguments.angle_tolerance,
                           "A\ton surfaces, merge by opposite angles instead, in radians");
    angle->check(check_not_negative)->excludes(tolerance);
    auto* none = command.add_flag("!--no-merge", arguments.merge, "merge no cells");
    none->excludes(tolerance)->excludes(angle);
    add_common_options(command, arguments.tell);
    command.add_flag("--timing", arguments.tell.timing, "report how long each stage took");
    return angle;
}

MergeOptions merge_options(const MeshArguments& arguments) {
    if (!arguments.merge)
        return {MergeCriterion::none, arguments.tolerance};
    if (arguments.angle_tolerance)
        return {MergeCriterion::angle, *arguments.angle_tolerance};
    return {MergeCriterion::dual_length, arguments.tolerance};
}

void add_mesh_arguments(CLI::App& command, MeshArguments& arguments, std::optional<StarKind> star) {
    if (star)
        add_star(command, arguments, *star);
    auto* angle = add_merge_arguments(
        command, arguments,
        "mesh file: .off .obj .ply .stl .mesh .msh .node .ele .vtk .vtu .nsc .pdm, or .nsl (edge "
        "lengths); divides polygons, hexahedra, ..; curved cells by corners");
    command
        .add_option("--centers", arguments.centers,
                    "NAME\tcircumcenters (default), or centroids: no merging, barycentric stars")
        ->check(one_of({"circumcenters", "centroids"}));
    auto* groups =
        command.add_flag("--keep-groups", arguments.keep_groups,
                         "keep cells and facets of different physical groups apart when merging");
    command
        .add_option(
            "--periodic", arguments.periods,
            "X,Y\tglue along this translation, repeatable; expressions and pictures stay unglued")
        ->check(check_vector);
    command
        .add_option("--glue", arguments.glue,
                    "MAP\tglue along an isometry, given by the image of a point: 'x+1; 1-y'")
        ->each([](const std::string& map) {
            for (const std::string& part : divided(map))
                note_input(part);
        });
    add_joining(command, arguments.joining);
    command.add_flag("--peel", arguments.peel,
                     "first remove flat cells on the boundary of a solid");
    command.add_option("--refine", arguments.refine,
                       "LENGTH\tfirst bisect cells until no edge is longer; groups are kept");
    command
        .add_flag(
            "--delaunay{flips}", arguments.delaunay,
            "[=split-boundary]\tsurfaces: flip (and split boundary) edges against negative duals")
        ->check(one_of({"flips", "split-boundary"}))
        ->excludes(angle)
        ->excludes(groups);
}

void add_star(CLI::App& command, MeshArguments& arguments, StarKind kind) {
    arguments.star = kind;
    command
        .add_option("--star", arguments.star,
                    "NAME\tinner products: circumcentric (dual over primal volume), galerkin "
                    "(Whitney forms, positive), hybrid (galerkin where needed), "
                    "barycentric (inconsistent, degrees 1 .. n-1), automatic (first "
                    "positive)")
        ->transform(enumerator({"circumcentric", "galerkin", "hybrid", "barycentric", "automatic"}))
        ->default_str(name(kind));
}

void add_side(CLI::App& command, Side& side) {
    command.add_option("--side", side, "SIDE\twhere the forms live: primal or dual cells")
        ->transform(enumerator({name(Side::primal), name(Side::dual)}))
        ->default_str(name(side));
}

void add_forms(CLI::App& command, Side& side, int& degree) {
    add_side(command, side);
    command.add_option("--degree", degree,
                       fmt::format("K\tdegree of the forms (default: {})", degree));
}

void add_engine(CLI::App& command, std::string& engine) {
    command.add_option("--engine", engine, "NAME\tlinear solver; see `polydec backends`");
}

Discretization load(const MeshArguments& arguments, Log& log,
                    const std::filesystem::path& picture) {
    const ProgressLine progress;
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
    options.star = arguments.star;
    options.refine = arguments.refine;

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
    log.mesh = arguments.mesh;
    if (!picture.empty())
        check_drawable(result);
    return result;
}

std::string in_words(const ChosenStars& stars) {
    if (stars.kind == StarKind::hybrid)
        return fmt::format("hybrid stars, Galerkin's on {:.3g} % of the cells",
                           100 * stars.galerkin_share());
    const bool is_mixed = stars.kind == StarKind::galerkin && stars.stars.dimension() > 1 &&
                          stars.stars[0].is_diagonal();
    return fmt::format("{} stars{}", name(stars.kind), is_mixed ? ", diagonal for functions" : "");
}

void FormFacts::write_form(JsonWriter& json) const {
    json.member("side", name(side));
    json.member("degree", degree);
}

void FormFacts::write_conditions(JsonWriter& json) const {
    json.member("conditions", conditions);
    write_stars(json, stars);
}

std::vector<std::string> FormFacts::beside(const std::string& equation) const {
    return {equation, conditions, in_words(stars)};
}

ProgressLine::ProgressLine(std::string_view what) : visible_(isatty(STDERR_FILENO) != 0) {
    if (!what.empty())
        (*this)(what);
}

ProgressLine::~ProgressLine() {
    if (visible_)
        console::tell("\r\033[K");
}

void ProgressLine::operator()(std::string_view what) const {
    if (!visible_)
        return;
    console::tell(fmt::format("\r\033[K{} ..", what));
}

} // namespace polydec::tools
