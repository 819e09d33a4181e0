// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "io/meshes/mesh_files.h"
#include "io/pictures/draw_cells.h"
#include "io/source_file.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/outputs.h"
#include "tools/picture.h"
#include "tools/written.h"

#include <fmt/format.h>

namespace polydec::tools {

namespace {

struct MergeArguments {
    MeshArguments mesh;
    PictureArguments picture;
};

void write_merged(const MergeArguments& arguments, const Discretization& mesh, const Log& log) {
    const auto& out = arguments.picture.out;
    if (mesh.dimension() > 3)
        throw InvalidInput(fmt::format("{}: no file format stores merged cells of dimension {}; "
                                       "`polydec operators` writes them as matrices",
                                       out.string(), mesh.dimension()));
    if (lower_extension(out) == ".vtu")
        write_vtu(out, draw_mesh(mesh), arguments.picture.vtu);
    else if (is_page(out))
        write_page(out, draw_page(mesh, arguments.mesh.mesh.filename().string()), log);
    else if (mesh.dimension() == 2)
        write_mesh(out, polygon_mesh(mesh));
    else
        throw InvalidInput(fmt::format("{}: merged cells of dimension {} cannot be written in this "
                                       "format: use .vtu",
                                       out.string(), mesh.dimension()));
}

void run_merge(const MergeArguments& arguments) {
    Log log;
    const auto& out = arguments.picture.out;
    check_output_file(out, and_pages({".off", ".obj", ".ply", ".vtu"}));
    check_float32(arguments.picture);
    check_page_options(out);
    const Discretization mesh = load(arguments.mesh, log);
    log.timing.begin("write");
    write_merged(arguments, mesh, log);
    const int n = mesh.dimension();
    tell(merged(out.string(), n, mesh.input().size(n), mesh.complex().size(n)), log,
         arguments.mesh.tell);
}

} // namespace

void add_merge(CLI::App& app) {
    const auto [command, arguments] =
        add_command<MergeArguments>(app, "merge", "writes the merged complex", run_merge);
    add_mesh_arguments(*command, arguments->mesh);
    command
        ->add_option("-o,--out", arguments->picture.out,
                     "FILE\tmerged cells: .off .obj .ply (surfaces), .vtu, .html, .png or .svg")
        ->required();
    add_float32(*command, arguments->picture);
    add_page_options(*command);
    command->footer("With --delaunay, edges of polygons cross the input's triangles: the "
                    "output has the triangles they cut.\n\nExamples:\n  polydec merge "
                    "fandisk.off -o fandisk-polygons.obj\n"
                    "  polydec merge cubes.nsc -o cubes.vtu");
}

} // namespace polydec::tools
