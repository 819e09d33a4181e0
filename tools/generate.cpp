// SPDX-License-Identifier: MIT
#include "tools/generate.h"

#include "base/printable.h"
#include "io/meshes/mesh_files.h"
#include "meshes/generate.h"
#include "tools/commands.h"
#include "tools/options.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <array>
#include <memory>
#include <vector>

namespace polydec::tools {

namespace {

struct Size {
    const char* option;
    const char* help;
    int value;
};

struct Surface {
    const char* name;
    const char* help;
    std::vector<Size> sizes; // one or two
    std::function<Mesh(int, int)> make;
};

const std::vector<Surface>& surfaces() {
    static const std::vector<Surface> list{
        {"grid",
         "unit square of squares, each split",
         {{"--nx", "N\tsquares along x", 16}, {"--ny", "N\tsquares along y", 16}},
         [](int a, int b) { return grid(a, b); }},
        {"hexagons",
         "unit square of hexagons, each fanned",
         {{"--columns", "N\thexagons in each row", 16}},
         [](int a, int) { return hexagons(a); }},
        {"well-centered",
         "unit square of acute triangles",
         {{"--rows", "N\tpairs of rows", 8}},
         [](int a, int) { return well_centered(a); }},
        {"uv-sphere",
         "unit sphere of planar quads, each split, and pole triangles",
         {{"--meridians", "N\tmeridians", 32}, {"--bands", "N\tbands from pole to pole", 16}},
         [](int a, int b) { return uv_sphere(a, b); }},
        {"icosphere",
         "unit sphere from the icosahedron",
         {{"--frequency", "N\tparts of an icosahedron's edge", 8}},
         [](int a, int) { return icosphere(a); }},
        {"goldberg",
         "unit sphere of planar hexagons and twelve pentagons, each fanned",
         {{"--frequency", "N\tparts of an icosahedron's edge", 8}},
         [](int a, int) { return goldberg(a); }},
        {"torus",
         "torus of planar quads, each split",
         {{"--major", "N\tquads around the axis", 32}, {"--minor", "N\tquads around the tube", 16}},
         [](int a, int b) { return torus(a, b); }},
        {"moebius",
         "Moebius strip, not orientable",
         {{"--around", "N\tquads around", 32}, {"--across", "N\tquads across", 4}},
         [](int a, int b) { return moebius(a, b); }},
        {"flange",
         "machine part with hub and bore, all faces split quads",
         {{"--segments", "N\tsegments around the axis", 48}},
         [](int a, int) { return flange(a); }},
    };
    return list;
}

void add_surface(CLI::App& generate, const Surface& surface) {
    const auto sizes = std::make_shared<std::array<int, 2>>();
    auto* command = add_generator(generate, surface.name, surface.help, [&surface, sizes] {
        return surface.make((*sizes)[0], (*sizes)[1]);
    });
    for (std::size_t i = 0; i < surface.sizes.size(); ++i) {
        (*sizes)[i] = surface.sizes[i].value;
        command->add_option(surface.sizes[i].option, (*sizes)[i], surface.sizes[i].help);
    }
}

} // namespace

CLI::App* add_generator(CLI::App& generate, const char* name, const char* help,
                        std::function<Mesh()> make) {
    auto* command = generate.add_subcommand(name, help)->group("Meshes");
    const auto out = std::make_shared<std::filesystem::path>();
    const auto options = std::make_shared<TellOptions>();
    command
        ->add_option(
            "-o,--out", *out,
            "FILE\tmesh file: .off .obj .ply .stl .mesh .nsc .pdm, or a page: .html .png .svg")
        ->required();
    add_common_options(*command, *options);
    add_page_options(*command);
    command->callback([out, options, make = std::move(make)] {
        check_output_file(*out,
                          and_pages({".off", ".obj", ".ply", ".stl", ".mesh", ".nsc", ".pdm"}));
        check_page_options(*out);
        Log log;
        write_generated(*out, make(), log, *options);
    });
    return command;
}

void write_generated(const std::filesystem::path& out, const Mesh& mesh, Log& log,
                     const TellOptions& options) {
    if (is_page(out)) {
        const Discretization cells = discretize(mesh);
        check_drawable(cells);
        log.warn(cells.warnings());
        write_page(out, draw_page(cells, out.stem().string()), log);
    } else
        write_mesh(out, mesh);
    const auto members = [&](JsonWriter& json) {
        json.member("out", out.string());
        json.member("points", mesh.points.rows());
        json.member("simplices", mesh.simplices.rows());
        json.member("dimension", mesh.dimension());
        json.member("ambient_dimension", mesh.ambient_dimension());
    };
    const auto words = [&](Text& text) {
        text("{}: {} points, {} simplices of dimension {}\n", printable(out.string()),
             mesh.points.rows(), mesh.simplices.rows(), mesh.dimension());
    };
    tell({members, words}, log, options);
}

void add_generate(CLI::App& app) {
    auto* command = app.add_subcommand(
        "generate", "generates a mesh by NAME, or fills SURFACE with tetrahedra (--mesher)");
    command->require_subcommand(0, 1);
    add_fill(*command);
    command->footer(
        "Examples:\n  polydec generate uv-sphere --meridians 64 --bands 32 -o sphere.off\n"
        "  polydec generate kuhn --cells 3 3 3 3 -o tesseracts.nsc\n"
        "  polydec generate fcc --cells 8 4 4 --edge 0.25 -o bar.mesh\n"
        "  polydec generate --mesher tetgen --quality 1.4 sphere.off -o ball.mesh");
    for (const auto& surface : surfaces())
        add_surface(*command, surface);
    add_lattices(*command);
}

} // namespace polydec::tools
