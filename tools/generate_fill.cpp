// SPDX-License-Identifier: MIT
#include "meshes/tetrahedralize.h"
#include "tools/common.h"
#include "tools/generate.h"
#include "tools/options.h"
#include "tools/outputs.h"

#include <fmt/format.h>

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
    check_output_file(arguments.out, {".mesh", ".nsc", ".pdm", ".html"},
                      mesh_files(arguments.surface));
    Points holes(static_cast<Eigen::Index>(arguments.holes.size()), 3);
    for (Eigen::Index i = 0; i < holes.rows(); ++i)
        holes.row(i) = Eigen::RowVector3d(arguments.holes[static_cast<std::size_t>(i)].data());

    Mesh surface, mesh;
    {
        const Progress progress;
        progress("read");
        surface = read_joined(arguments.surface, arguments.joining);
        progress(arguments.mesher);
        mesh = tetrahedralize(surface, arguments.options, holes);
    }
    Log log;
    for (const Mesh* told : {&surface, &mesh})
        for (const auto& warning : told->warnings)
            log.warn(warning);
    write_generated(arguments.out, mesh, log, arguments.tell);
}

/// The one mesher there is, also where its program is missing: then the library says so.
std::string check_mesher(const std::string& name) {
    return name == "tetgen" ? "" : fmt::format("expected tetgen, not '{}'", name);
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

} // namespace

void add_fill(CLI::App& generate) {
    const auto arguments = std::make_shared<FillArguments>();
    auto& options = arguments->options;
    auto* mesher = generate.add_option("--mesher", arguments->mesher,
                                       "fill the closed surface SURFACE with tetrahedra: tetgen");
    mesher->check(check_mesher);
    generate.add_option("SURFACE", arguments->surface, "mesh file of a closed surface");
    generate
        .add_option("--quality", options.quality,
                    "most circumradius over shortest edge, 1.2 or more")
        ->needs(mesher);
    generate.add_option("--volume", options.largest_volume, "largest volume of a tetrahedron")
        ->needs(mesher);
    generate.add_option("--hole", arguments->holes, "a point x y z of a part to be left empty")
        ->allow_extra_args(false)
        ->needs(mesher);
    generate
        .add_flag_callback(
            "--keep-boundary", [&options] { options.boundary = BoundarySplitting::forbidden; },
            "put no new points on the surface")
        ->needs(mesher);
    generate.add_option("--seconds", options.seconds, "stop the mesher after this time")
        ->capture_default_str()
        ->needs(mesher);
    add_joining(generate, arguments->joining);
    generate.get_option("--weld")->needs(mesher);
    generate.get_option("--join-hanging")->needs(mesher);
    generate.add_option("-o,--out", arguments->out, "mesh file of tetrahedra: .mesh .nsc .pdm");
    add_common_options(generate, arguments->tell);
    generate.get_option("--json")->needs(mesher);
    generate.callback([&generate, arguments] { fill_if_asked(generate, *arguments); });
}

} // namespace polydec::tools
