// SPDX-License-Identifier: MIT
#include "meshes/generate.h"

#include "io/write_mesh.h"
#include "tools/commands.h"
#include "tools/common.h"

#include <fmt/format.h>

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

void run(const Generator& generator, const Arguments& arguments) {
    const Mesh mesh = generator.make(arguments.a, arguments.b);
    write_mesh(arguments.out, mesh);
    fmt::print("{}: {} points, {} simplices of dimension {}\n", arguments.out.string(),
               mesh.points.rows(), mesh.simplices.rows(), mesh.dimension());
}

} // namespace

void add_generate(CLI::App& app) {
    auto* command = app.add_subcommand("generate", "makes a mesh");
    command->require_subcommand(1);
    command->footer(
        "Examples:\n  polydec generate uv-sphere --meridians 64 --bands 32 -o sphere.off\n"
        "  polydec generate kuhn --dimension 4 --cells 3 -o tesseracts.nsc");
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
