// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "examples/paper/console.h"
#include "io/draw_cells.h"
#include "io/draw_overlay.h"
#include "io/vtu.h"
#include "io/write_mesh.h"
#include "tools/commands.h"
#include "tools/common.h"

#include <fmt/format.h>

#include <memory>

namespace polydec::tools {

namespace {

struct Arguments {
    MeshArguments mesh;
    std::filesystem::path out;
};

void write(const std::filesystem::path& out, const Discretization& mesh) {
    if (mesh.dimension() > 3)
        throw InvalidInput(fmt::format("{}: no format holds merged cells of dimension {}; the "
                                       "subcommand operators writes them as matrices",
                                       out.string(), mesh.dimension()));
    if (out.extension() == ".vtu") {
        auto grid = mesh.intrinsic ? draw_overlay(mesh) : draw_cells(mesh, mesh.dimension());
        if (!mesh.tags.empty())
            grid.cell_data.push_back({"tag", mesh.tags});
        write_vtu(out, grid);
    } else if (mesh.dimension() == 2)
        write_mesh(out, polygon_mesh(mesh));
    else
        throw InvalidInput(fmt::format("{}: merged cells of dimension {} cannot be written in this "
                                       "format: use .vtu",
                                       out.string(), mesh.dimension()));
}

void run(const Arguments& arguments) {
    Timing timing;
    const Discretization mesh = load(arguments.mesh, timing);
    timing.begin("write");
    write(arguments.out, mesh);
    const int n = mesh.dimension();
    console::print("{}: {} cells of dimension {} merged into {}\n", arguments.out.string(),
                   mesh.input().size(n), n, mesh.complex().size(n));
    print_timing(arguments.mesh, timing);
}

} // namespace

void add_merge(CLI::App& app) {
    auto* command = app.add_subcommand("merge", "writes the merged complex");
    const auto arguments = std::make_shared<Arguments>();
    add_mesh_arguments(*command, arguments->mesh, JsonOption::none);
    command->add_option("-o,--out", arguments->out, ".off .obj .ply (surfaces) or .vtu")
        ->required();
    command->footer("With --delaunay polygons have edges that cross the input's triangles: the "
                    "triangles are\nwritten as they are cut by them.\n\nExamples:\n  polydec merge "
                    "fandisk.off -o fandisk-polygons.obj\n"
                    "  polydec merge cubes.nsc -o cubes.vtu");
    command->callback([arguments] { run(*arguments); });
}

} // namespace polydec::tools
