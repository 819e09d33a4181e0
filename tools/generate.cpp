// SPDX-License-Identifier: MIT
#include "meshes/generate.h"

#include "backends/registry.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "meshes/tetrahedralize.h"
#include "tools/commands.h"
#include "tools/common.h"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <memory>

namespace polydec::tools {

namespace {

struct Arguments {
    std::filesystem::path out;
    int a = 0, b = 0;
};

struct Size {
    const char* option;
    const char* help;
    int value;
};

struct Generator {
    const char* name;
    const char* help;
    std::vector<Size> sizes; // one or two
    std::function<Mesh(int, int)> make;
};

const std::vector<Generator>& generators() {
    static const std::vector<Generator> list{
        {"grid",
         "unit square of squares, each split",
         {{"--nx", "squares along x", 16}, {"--ny", "squares along y", 16}},
         [](int a, int b) { return grid(a, b); }},
        {"hexagons",
         "unit square of hexagons, each fanned",
         {{"--columns", "hexagons to a row", 16}},
         [](int a, int) { return hexagons(a); }},
        {"well-centered",
         "unit square of acute triangles",
         {{"--rows", "pairs of rows", 8}},
         [](int a, int) { return well_centered(a); }},
        {"uv-sphere",
         "unit sphere of planar quads, each split, and pole triangles",
         {{"--meridians", "meridians", 32}, {"--bands", "bands from pole to pole", 16}},
         [](int a, int b) { return uv_sphere(a, b); }},
        {"icosphere",
         "unit sphere from the icosahedron",
         {{"--frequency", "parts of an icosahedron's edge", 8}},
         [](int a, int) { return icosphere(a); }},
        {"goldberg",
         "unit sphere of planar hexagons and twelve pentagons, each fanned",
         {{"--frequency", "parts of an icosahedron's edge", 8}},
         [](int a, int) { return goldberg(a); }},
        {"torus",
         "torus of planar quads, each split",
         {{"--major", "quads around the axis", 32}, {"--minor", "quads around the tube", 16}},
         [](int a, int b) { return torus(a, b); }},
        {"moebius",
         "Moebius strip, not orientable",
         {{"--around", "quads around", 32}, {"--across", "quads across", 4}},
         [](int a, int b) { return moebius(a, b); }},
        {"flange",
         "machine part with hub and bore, all faces split quads",
         {{"--segments", "segments around the axis", 48}},
         [](int a, int) { return flange(a); }},
        {"kuhn",
         "unit cube of any dimension as a grid of cubes of n! simplices each",
         {{"--dimension", "dimension n", 3}, {"--cells", "cubes along each axis", 4}},
         [](int a, int b) { return kuhn(a, b); }},
        {"bcc",
         "unit cube as body-centered lattice, tetrahedra",
         {{"--cells", "cubes along each axis", 4}},
         [](int a, int) { return bcc(a); }},
        {"fcc",
         "unit cube as face-centered lattice, tetrahedra",
         {{"--cells", "cubes along each axis", 4}},
         [](int a, int) { return fcc(a); }},
    };
    return list;
}

void write(const std::filesystem::path& out, const Mesh& mesh) {
    write_mesh(out, mesh);
    fmt::print("{}: {} points, {} simplices of dimension {}\n", out.string(), mesh.points.rows(),
               mesh.simplices.rows(), mesh.dimension());
}

void run(const Generator& generator, const Arguments& arguments) {
    write(arguments.out, generator.make(arguments.a, arguments.b));
}

struct FillArguments {
    std::string mesher;
    std::filesystem::path surface, out;
    MesherOptions options;
    std::vector<std::array<double, 3>> holes;
};

void fill(const FillArguments& arguments) {
    Points holes(static_cast<Eigen::Index>(arguments.holes.size()), 3);
    for (Eigen::Index i = 0; i < holes.rows(); ++i)
        holes.row(i) = Eigen::RowVector3d(arguments.holes[static_cast<std::size_t>(i)].data());

    Mesh surface, mesh;
    {
        const Progress progress;
        progress("read");
        surface = read_mesh(arguments.surface);
        progress(arguments.mesher);
        mesh = tetrahedralize(surface, arguments.options, holes, arguments.mesher);
    }
    for (const Mesh* told : {&surface, &mesh})
        for (const auto& warning : told->warnings)
            warn(warning);
    write(arguments.out, mesh);
}

/// One of the meshers that are known, also where its program is missing: then that is told.
std::string check_mesher(const std::string& name) {
    std::string known;
    for (const auto& engine : engines()) {
        if (engine.kind != EngineKind::mesher)
            continue;
        if (engine.name == name)
            return {};
        known += (known.empty() ? "" : " or ") + engine.name;
    }
    return fmt::format("expected {}, not '{}'", known, name);
}

void fill_if_asked(const CLI::App& command, const FillArguments& arguments) {
    if (!command.get_subcommands().empty())
        return;
    if (arguments.mesher.empty() && arguments.surface.empty())
        throw CLI::RequiredError("The name of a mesh, or --mesher,");
    if (arguments.mesher.empty())
        throw CLI::ValidationError(
            fmt::format("there is no '{}' here", arguments.surface.string()));
    for (const char* name : {"SURFACE", "--out"})
        if (command.count(name) == 0)
            throw CLI::RequiredError(name);
    fill(arguments);
}

/// The command itself, without the name of a mesh, fills a surface.
void add_fill(CLI::App& command) {
    const auto arguments = std::make_shared<FillArguments>();
    auto& options = arguments->options;
    auto* mesher = command.add_option("--mesher", arguments->mesher,
                                      "fill the closed surface SURFACE with tetrahedra: tetgen");
    mesher->check(check_mesher);
    command.add_option("SURFACE", arguments->surface, "mesh file of a closed surface");
    command
        .add_option("--quality", options.quality,
                    "most circumradius over shortest edge, 1.2 or more")
        ->needs(mesher);
    command.add_option("--volume", options.largest_volume, "largest volume of a tetrahedron")
        ->needs(mesher);
    command.add_option("--hole", arguments->holes, "a point x y z of a part to be left empty")
        ->allow_extra_args(false)
        ->needs(mesher);
    command
        .add_flag_callback(
            "--keep-boundary", [&options] { options.boundary = BoundarySplitting::forbidden; },
            "put no new points on the surface")
        ->needs(mesher);
    command.add_option("--seconds", options.seconds, "stop the mesher after this time")
        ->capture_default_str()
        ->needs(mesher);
    command.add_option("-o,--out", arguments->out, "mesh file of tetrahedra: .mesh .nsc");
    command.callback([&command, arguments] { fill_if_asked(command, *arguments); });
}

} // namespace

void add_generate(CLI::App& app) {
    auto* command = app.add_subcommand("generate", "makes a mesh");
    command->require_subcommand(0, 1);
    add_fill(*command);
    command->footer(
        "Examples:\n  polydec generate uv-sphere --meridians 64 --bands 32 -o sphere.off\n"
        "  polydec generate kuhn --dimension 4 --cells 3 -o tesseracts.nsc\n"
        "  polydec generate --mesher tetgen --quality 1.4 sphere.off -o ball.mesh");
    for (const auto& generator : generators()) {
        auto* one = command->add_subcommand(generator.name, generator.help);
        const auto arguments = std::make_shared<Arguments>();
        int* targets[] = {&arguments->a, &arguments->b};
        for (std::size_t i = 0; i < generator.sizes.size(); ++i) {
            *targets[i] = generator.sizes[i].value;
            one->add_option(generator.sizes[i].option, *targets[i], generator.sizes[i].help)
                ->capture_default_str();
        }
        one->add_option("-o,--out", arguments->out, "mesh file: .off .obj .ply .stl .mesh .nsc")
            ->required();
        one->callback([&generator, arguments] { run(generator, *arguments); });
    }
}

} // namespace polydec::tools
