// SPDX-License-Identifier: MIT
#include "meshes/tetrahedralize.h"
#include "tools/common.h"
#include "tools/generate.h"
#include "tools/help.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <array>
#include <memory>

namespace polydec::tools {

namespace {

struct FillArguments {
    std::string mesher;
    std::filesystem::path surface, out;
    MesherOptions options;
    std::vector<std::array<double, 3>> holes;
    JoiningArguments joining;
    TellOptions tell;
};

void fill(const FillArguments& arguments) {
    check_output_file(arguments.out, and_pages({".mesh", ".nsc", ".pdm"}));
    Points holes(static_cast<Eigen::Index>(arguments.holes.size()), 3);
    for (Eigen::Index i = 0; i < holes.rows(); ++i)
        holes.row(i) = Eigen::RowVector3d(arguments.holes[i].data());

    Mesh surface, mesh;
    {
        const ProgressLine progress("read");
        surface = read_joined(arguments.surface, arguments.joining);
        progress(arguments.mesher);
        mesh = tetrahedralize(surface, arguments.options, holes);
    }
    Log log;
    log.warn(surface.warnings);
    log.warn(mesh.warnings);
    write_generated(arguments.out, mesh, log, arguments.tell);
}

void fill_if_asked(CLI::App& command, const FillArguments& arguments) {
    if (!command.get_subcommands().empty())
        return;
    if (arguments.mesher.empty())
        throw CLI::ValidationError("generate",
                                   one_of(commands_of(command))(arguments.surface.string()));
    for (const char* name : {"SURFACE", "--out"})
        command.get_option(name)->required();
    if (arguments.surface.empty() || arguments.out.empty())
        throw CLI::RequiredError("generate");
    fill(arguments);
}

} // namespace

void add_fill(CLI::App& generate) {
    const auto arguments = std::make_shared<FillArguments>();
    auto& options = arguments->options;
    auto* mesher = generate.add_option(
        "--mesher", arguments->mesher,
        "NAME\tfill the closed surface SURFACE with tetrahedra by this mesher: tetgen");
    mesher->check(one_of({"tetgen"})); // also where its program is missing: the library says so
    generate
        .add_option("SURFACE", arguments->surface, "with --mesher: mesh file of a closed surface")
        ->each(note_input);
    generate
        .add_option("--quality", options.quality,
                    "Q\tlargest ratio of circumradius to shortest edge, at least 0.613; below "
                    "1.2 the mesher may not end")
        ->needs(mesher);
    generate.add_option("--volume", options.largest_volume, "V\tlargest volume of a tetrahedron")
        ->needs(mesher);
    generate
        .add_option("--hole", arguments->holes, "X Y Z\tpoint of a part to leave empty; repeatable")
        ->allow_extra_args(false)
        ->needs(mesher);
    generate
        .add_flag_callback(
            "--keep-boundary", [&options] { options.boundary = BoundarySplitting::forbidden; },
            "add no points to the surface")
        ->needs(mesher);
    generate.add_option("--seconds", options.seconds, "S\tstop the mesher after S seconds")
        ->needs(mesher);
    add_joining(generate, arguments->joining);
    generate.get_option("--weld")->needs(mesher);
    generate.get_option("--join-hanging")->needs(mesher);
    generate.add_option("-o,--out", arguments->out,
                        "FILE\ttetrahedra: .mesh .nsc .pdm, or a page: .html .png .svg");
    add_common_options(generate, arguments->tell);
    generate.get_option("--json")->needs(mesher);
    generate.callback([&generate, arguments] { fill_if_asked(generate, *arguments); });
}

} // namespace polydec::tools
