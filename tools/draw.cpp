// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "base/printable.h"
#include "io/pictures/draw_structure.h"
#include "io/pictures/svg_drawing.h"
#include "io/pictures/upright_view.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/outputs.h"

namespace polydec::tools {

namespace {

struct DrawArguments {
    MeshArguments mesh;
    LessonOptions shown;
    std::vector<double> eye;
    std::filesystem::path out;
};

void run_draw(DrawArguments arguments) {
    Log log;
    if (arguments.out.empty())
        arguments.out = arguments.mesh.mesh.stem().string() + ".svg";
    check_output_file(arguments.out, {".svg", ".png", ".pdf"});
    check_drawing_file(arguments.out);
    const Discretization mesh = load(arguments.mesh, log);
    if (!arguments.eye.empty() && is_flat(mesh.measured_points()))
        throw InvalidInput(fmt::format("--eye: {} lies in a plane, seen from above: omit it",
                                       printable(log.mesh.string())));
    if (!arguments.eye.empty())
        arguments.shown.structure.view.eye = Eigen::Map<const Vector>(arguments.eye.data(), 3);
    const SvgDrawing drawing =
        computed_on(log.mesh, [&] { return draw_lesson(mesh, arguments.shown); });
    log.timing.begin("write");
    write_drawing(arguments.out, drawing);
    const std::string out = arguments.out.string();
    const auto members = [&](JsonWriter& json) {
        json.member("out", out);
        json.member("vertices", mesh.complex().size(0));
        json.member("edges", mesh.complex().size(1));
        json.member("cells", mesh.complex().size(mesh.dimension()));
        json.member("shapes", drawing.shapes.size());
    };
    tell({members, [&](Text& text) { text("{}\n", printable(out)); }}, log, arguments.mesh.tell);
}

} // namespace

void add_draw(CLI::App& app) {
    const auto [command, arguments] = add_command<DrawArguments>(
        app, "draw", "draws cells, duals and numbers of a small mesh, for teaching", run_draw);
    LessonOptions& lesson = arguments->shown;
    StructureOptions& shown = lesson.structure;
    command->add_flag("--duals", shown.duals, "draw the dual mesh");
    command->add_flag("--dual-orientations", shown.dual_orientations,
                      "draw the dual mesh with orientations of dual edges");
    command->add_flag("--both-duals", lesson.both_duals,
                      "draw the circumcentric and the barycentric dual side by side");
    command->add_option("--cell", shown.cell, "V\tfill the dual cell of vertex V");
    command->add_option("--matrix", lesson.matrix,
                        "K\tboundary matrix of the K-cells beside the drawing");
    command
        ->add_option("--explode", lesson.explode,
                     "F\tmove the cells of a solid apart, by F times their distance from the "
                     "middle")
        ->check(check_not_negative);
    command->add_flag("--numbers", shown.numbers,
                      "number vertices, edges and cells like the matrices of `operators`");
    command->add_flag("--orientations", shown.orientations, "draw orientations of edges and cells");
    command->add_flag("--circumcircles", shown.circumcircles, "draw circumcircles of the cells");
    command->add_option("--title", shown.view.title, "TITLE\ttitle above the drawing");
    command->add_option("--width", shown.view.width, "PIXELS\twidth of the drawing")
        ->check(CLI::Range(100.0, 20000.0));
    command
        ->add_option("--eye", arguments->eye, "X Y Z\tdirection to the eye, for surfaces in space")
        ->expected(3);
    add_mesh_arguments(*command, arguments->mesh);
    command->add_option("-o,--out", arguments->out,
                        "FILE\tthe drawing, .svg, or .png or .pdf by rsvg-convert or cairosvg "
                        "(default: the mesh's name with .svg, in the current folder)");
    command->footer("Shows merged cells and the edges that merging removed; --no-merge shows the "
                    "triangles. Solids show their cells and numbers; `view` shows more.\n\n"
                    "Examples:\n"
                    "  polydec draw square.off --duals --circumcircles\n"
                    "  polydec draw square.off --no-merge --numbers --orientations -o square.svg\n"
                    "  polydec draw square.off --cell 4 --dual-orientations --matrix 1\n"
                    "  polydec draw cube.mesh --no-merge --explode 0.5 --numbers -o cube.pdf\n"
                    "  polydec draw goldberg.off --duals --eye 1 -2 0.5 --title Hexagons");
}

} // namespace polydec::tools
