// SPDX-License-Identifier: MIT
#include "meshes/tetgen/run_tetgen.h"

#include "base/errors.h"
#include "base/listed.h"
#include "base/lists.h"
#include "meshes/edges.h"
#include "meshes/tetgen/tetgen_files.h"
#include "system/child_process.h"
#include "system/held_signals.h"
#include "system/temporary_folder.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string_view>
#include <tuple>

namespace polydec {

namespace {

namespace fs = std::filesystem;

constexpr const char* surface_file = "mesh.smesh";

/// One mesh that is being made.
struct TetgenRun {
    const TetgenInput& input;
    const MesherOptions& options;
    fs::path program, folder;
};

fs::path require_program() {
    const auto program = find_program("tetgen");
    if (!program)
        throw BackendUnavailable("the mesher `tetgen` needs the program tetgen, which is not on "
                                 "PATH\nTo get it: apt-get install tetgen (Debian package "
                                 "tetgen).");
    return *program;
}

void write_input(const TetgenRun& run) {
    const auto path = run.folder / surface_file;
    std::ofstream file(path, std::ios::binary);
    file << smesh_text(run.input);
    file.close();
    if (!file)
        throw IoError(fmt::format("cannot write {}: is the disk full?", path.string()),
                      {.path = path});
}

/// Counting from zero (z) and quietly (Q).
std::string switches(const TetgenRun& run) {
    const auto& options = run.options;
    std::string text = "-zQp";
    if (options.boundary == BoundarySplitting::forbidden)
        text += "Y";
    if (options.quality > 0.0)
        text += fmt::format("q{:.6f}", options.quality);
    if (options.largest_volume > 0.0) {
        const double volume = std::ldexp(options.largest_volume, -3 * run.input.exponent);
        text += fmt::format("a{:e}", std::clamp(volume, 1e-200, 1e200));
    }
    return text;
}

ChildOutcome start(const TetgenRun& run, const std::string& how) {
    const ChildLimits limits{.seconds = run.options.seconds, .bytes = run.options.bytes};
    return run_child(run.program, {how, surface_file}, run.folder, limits);
}

std::string in_gibibytes(std::size_t bytes) {
    return fmt::format("{:.3g} GiB", static_cast<double>(bytes) / std::pow(2.0, 30));
}

/// The last line that it printed, which tells of a failed assertion, say.
std::string last_words(std::string_view output) {
    constexpr std::string_view blanks = " \t\r\n";
    constexpr std::size_t most = 300;
    output = output.substr(0, output.find_last_not_of(blanks) + 1);
    output = output.substr(output.find_last_of('\n') + 1); // npos + 1 is 0
    return std::string(output.substr(0, most));
}

/// TetGen does not say by itself which facets cross, but it has a mode that looks for them.
void refuse_crossing_facets(const TetgenRun& run) {
    const auto facets = static_cast<Index>(run.input.triangles.rows());
    const auto pairs = crossing_facets(start(run, "-zd").output, facets);
    if (pairs.empty())
        return;
    const auto name = [&](Index i) {
        return fmt::format("{} and {}", facet_name(run.input.given, pairs[i].first),
                           facet_name(run.input.given, pairs[i].second));
    };
    throw InvalidInput(fmt::format(
        "mesher: {} of facets cross or overlap: {}\n"
        "Facets may meet only in common corners and edges: repair the surface there.",
        counted(pairs.size(), "pair", "pairs"), listed(numbers_below(std::ssize(pairs)), name)));
}

[[noreturn]] void fail(const TetgenRun& run, const ChildOutcome& outcome) {
    const auto& options = run.options;
    if (outcome.end == ChildEnd::interrupted)
        throw SolverFailure("tetgen was stopped because this program received a signal to end");
    if (outcome.end == ChildEnd::timed_out)
        throw SolverFailure(
            fmt::format("tetgen was stopped because it did not finish within {} seconds\n"
                        "Allow more time, larger tetrahedra or less quality.",
                        options.seconds));

    refuse_crossing_facets(run);

    // it does not say that an allocation failed, so what it had tells
    const bool was_killed = outcome.end == ChildEnd::signaled;
    const bool file_too_long = was_killed && outcome.code == SIGXFSZ;
    const bool no_memory = outcome.output.find("bad_alloc") != std::string::npos ||
                           outcome.peak_bytes > options.bytes / 2;
    if (was_killed && (file_too_long || no_memory))
        throw SolverFailure(
            fmt::format("tetgen failed, probably at its memory limit of {}; it used {}\n"
                        "Allow more memory, larger tetrahedra or less quality.",
                        in_gibibytes(options.bytes), in_gibibytes(outcome.peak_bytes)));
    const auto words = last_words(outcome.output);
    throw SolverFailure(
        fmt::format("tetgen {} {}{}\n"
                    "Probable cause: facets that almost touch, points that are almost equal, "
                    "angles near 0, or too little memory; repair the surface.",
                    was_killed ? "was ended by a signal," : "ended with exit code",
                    was_killed ? ::strsignal(outcome.code) : fmt::format("{}", outcome.code),
                    words.empty() ? "" : ", saying: " + words));
}

[[noreturn]] void fail_empty(const TetgenRun& run) {
    refuse_crossing_facets(run);
    throw SolverFailure(fmt::format("tetgen made no tetrahedra\nProbable cause: {}.",
                                    run.input.holes.rows() > 0
                                        ? "the holes remove everything"
                                        : "the points lie almost in one plane"));
}

/// TetGen orients all tetrahedra alike, and the sum tells how, whatever rounding does to flat ones.
void orient_alike(const Points& points, Simplices& cells) {
    double volume = 0.0;
    for (const auto& corners : cells.rowwise())
        volume += edges_at_first(points, corners).determinant();
    if (volume < 0.0)
        cells.col(2).swap(cells.col(3));
}

} // namespace

TetgenOutput run_tetgen(const TetgenInput& input, const MesherOptions& options) {
    const auto program = require_program();
    const HeldSignals held; // outlives the folder: a signal is delivered when that is gone
    const TemporaryFolder folder;
    const TetgenRun run{input, options, program, folder.path()};
    write_input(run);

    const auto outcome = start(run, switches(run));
    if (outcome.end != ChildEnd::exited || outcome.code != 0)
        fail(run, outcome);
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(run.folder / "mesh.1.ele", ignored)))
        fail_empty(run);
    TetgenOutput output;
    output.points = read_tetgen_points(run.folder / "mesh.1.node");
    output.tetrahedra = read_tetgen_cells(run.folder / "mesh.1.ele", output.points.rows());
    if (output.tetrahedra.rows() == 0)
        fail_empty(run);
    orient_alike(output.points, output.tetrahedra);
    std::tie(output.faces, output.facets) =
        read_tetgen_faces(run.folder / "mesh.1.face", output.points.rows(),
                          static_cast<Index>(input.triangles.rows()));
    return output;
}

} // namespace polydec
