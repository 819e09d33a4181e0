// SPDX-License-Identifier: MIT
#include "tools/mpi/shared_mesh.h"

#include "base/errors.h"
#include "distributed/mesh_file.h"
#include "system/memory.h"
#include "tools/command_line.h"
#include "tools/messages.h"
#include "tools/outputs.h"

#include <fmt/format.h>

#include <ctime>

namespace polydec::tools {

namespace {

/// What a computation took on all ranks.
struct Effort {
    int ranks;
    GlobalIndex cells, held;   ///< n-simplices of the whole, and those that ranks hold, copies too
    double most_cpu, mean_cpu; ///< seconds
    GlobalIndex most_sent;     ///< bytes
    GlobalIndex most_memory;   ///< bytes of a rank, at its peak
    std::vector<Stage> stages; ///< of the busiest rank

    void write(JsonWriter& json) const {
        json.object("ranks", [&] {
            json.member("count", ranks);
            json.member("cells", cells);
            json.member("cells_held", held);
            json.member("cpu_seconds", most_cpu);
            json.member("mean_cpu_seconds", mean_cpu);
            json.member("bytes_sent", most_sent);
            json.member("peak_memory", most_memory);
            if (!stages.empty())
                json.object("stages", [&] { write_stages(json); });
        });
    }

    void write(Text& text) const {
        text("{} rank{}: {:.1f} % of the cells are held twice; {:.2f} s of CPU, {:.1f} MB sent and "
             "{:.0f} MB of memory at most\n",
             ranks, ranks == 1 ? "" : "s",
             100.0 * static_cast<double>(held - cells) / static_cast<double>(cells), most_cpu,
             1e-6 * static_cast<double>(most_sent), 1e-6 * static_cast<double>(most_memory));
        if (!stages.empty())
            text("\nbusiest rank   CPU, s  sent, MB  memory so far, MB\n");
        for (const Stage& stage : stages)
            text("  {:<12} {:8.3f} {:9.1f} {:18.0f}\n", stage.name, stage.cpu,
                 1e-6 * static_cast<double>(stage.sent),
                 1e-6 * static_cast<double>(stage.peak_memory));
    }

    void write_stages(JsonWriter& json) const {
        for (const Stage& stage : stages)
            json.object(stage.name, [&] {
                json.member("cpu_seconds", stage.cpu);
                json.member("bytes_sent", stage.sent);
                json.member("peak_memory", stage.peak_memory);
            });
    }
};

/// Collective: the largest effort of any rank for each stage, identical on all ranks.
std::vector<Stage> busiest(const Ranks& ranks, std::vector<Stage> stages) {
    for (Stage& stage : stages) {
        stage.cpu = ranks.largest(stage.cpu);
        stage.sent = ranks.largest(stage.sent);
        stage.peak_memory = ranks.largest(stage.peak_memory);
    }
    return stages;
}

} // namespace

void refuse_options(CLI::App& command, const std::vector<std::string>& options) {
    for (const std::string& option : options) {
        const auto refuse = [option, name = command.get_name()](const CLI::results_t&) -> bool {
            throw OneProcessOnly(option, name);
        };
        command.add_option(option, refuse, "")->group("")->expected(0, 1);
    }
}

void add_shared_arguments(CLI::App& command, SharedArguments& arguments) {
    add_merge_arguments(
        command, arguments.mesh,
        "mesh file: .pdm or another binary one of simplices (.ply, .msh, .vtu), read in parts by "
        "all ranks, or any that polydec reads, read as a whole by rank 0");
    command
        .add_option("--owners", arguments.owners,
                    "NAME\thow vertices are distributed over ranks: morton (neighbors together), "
                    "file (in file order), or ptscotch (few edges cut, for long solves); affects "
                    "time, not results")
        ->default_str("morton")
        ->transform(enumerator({"morton", "file", "ptscotch"}));
    refuse_options(command, {"--centers", "--keep-groups", "--peel", "--delaunay", "--weld",
                             "--join-hanging", "--refine"});
}

SharedProgress::SharedProgress(const Ranks& ranks) : ranks_(ranks) {
    if (ranks.rank() == 0)
        ranks.listen([this](std::string_view what) { progress_(what); });
}

SharedProgress::~SharedProgress() {
    if (ranks_.rank() == 0)
        ranks_.listen({});
}

Log log_of(const Ranks& ranks) {
    return {Timing([ranks] { return ranks.bytes_sent(); })};
}

DistributedMesh load(const Ranks& ranks, const SharedArguments& arguments, Log& log) {
    const SharedProgress progress(ranks);
    const auto& file = arguments.mesh.mesh;
    log.timing.begin("read");
    DistributedMesh mesh = computed_on(file, [&] {
        MeshSlice slice = read_slice(ranks, file);
        if (arguments.mesh.angle_tolerance && slice.dimension() != 2)
            throw InvalidInput(fmt::format("--angle-tolerance is for surfaces, but the cells have "
                                           "dimension {}: use --tolerance",
                                           slice.dimension()));
        log.timing.begin("owners");
        const auto owners = vertex_owners(ranks, slice, arguments.owners);
        return discretize(ranks, std::move(slice), owners, merge_options(arguments.mesh),
                          [&](std::string_view stage) { log.timing.begin(stage); });
    });
    mesh.star = arguments.mesh.star;
    log.timing.end();
    log.warn(mesh.warnings);
    return mesh;
}

BoundaryCounts boundary_counts(const Ranks& ranks, const DistributedMesh& mesh,
                               const BoundaryConditions& conditions) {
    const int n = mesh.dimension();
    const auto& first = mesh.cells.degree(n - 1).first;
    BoundaryCounts on;
    for (std::size_t f = 0; f < first.size(); ++f)
        if (mesh.local.complex.coface_counts(n - 1)[first[f]] == 1) {
            ++on.facets;
            if (conditions.at(static_cast<Index>(f)) == BoundaryCondition::essential)
                ++on.essential;
        }
    return {.facets = ranks.sum(on.facets), .essential = ranks.sum(on.essential)};
}

FormFacts facts_of(const DistributedMesh& mesh, Side side, int degree, std::string conditions) {
    return {side, degree, std::move(conditions),
            ChosenStars(HodgeStars(mesh.cells.volumes), StarKind::circumcentric)};
}

void tell(const Ranks& ranks, const DistributedMesh& mesh, const Answer& answer, Log& log,
          const TellOptions& options) {
    log.timing.end();
    const auto& tops = mesh.local.degrees.back();
    const double cpu = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    const Effort took{ranks.size(),
                      tops.count,
                      ranks.sum(tops.size()),
                      ranks.largest(cpu),
                      ranks.sum(cpu) / ranks.size(),
                      ranks.largest(ranks.bytes_sent()),
                      ranks.largest(peak_memory()),
                      options.timing ? busiest(ranks, log.timing.stages()) : std::vector<Stage>()};
    const auto members = [&](JsonWriter& json) {
        answer.json(json);
        took.write(json);
    };
    const auto words = [&](Text& text) {
        answer.text(text);
        took.write(text);
    };
    tell({members, words}, log, options);
}

void check_output_file(const Ranks& ranks, const std::filesystem::path& out,
                       const char* extension) {
    ranks.together("output", [&] {
        if (ranks.rank() == 0 && !out.empty())
            check_output_file(out, {extension});
    });
}

void add_picture(CLI::App& command, std::filesystem::path& out, const std::string& what,
                 bool required) {
    command
        .add_option("-o,--out", out,
                    "FILE\twrite " + what +
                        " as .pvtu, with a folder of the same name for a .vtu file per rank")
        ->required(required);
}

} // namespace polydec::tools
