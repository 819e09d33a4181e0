// SPDX-License-Identifier: MIT
#include "solvers/spectra/spectrum.h"

#include "base/errors.h"
#include "base/printable.h"
#include "dec/discretization/fingerprint.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "io/checkpoint.h"
#include "io/pictures/draw_fields.h"
#include "shape/shape.h"
#include "shape/shape_spectrum.h"
#include "system/memory.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/outputs.h"
#include "tools/picture.h"
#include "tools/shape_answer.h"
#include "tools/spectrum_answer.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace polydec::tools {

namespace {

struct SpectrumArguments {
    MeshArguments mesh;
    Side side = Side::primal;
    int degree = 0;
    SpectrumOptions spectrum;
    ConditionArguments conditions;
    bool certify = true;
    PictureArguments picture;
    std::filesystem::path checkpoint;
    bool resume = false;
    bool of_shape = false;
    ShapeSpectrumOptions shape = {};
    std::vector<double> below; ///< counts of the shape instead of its spectrum
};

/// Vectors as they are found, in a file, and what it is of.
class FoundModes {
public:
    FoundModes(const std::filesystem::path& path, const FormSpace& space)
        : path_(path), problem_(polydec::Fingerprint().add("spectrum").add(space).value()) {}

    /// None if there is no file yet.
    DenseMatrix read() const {
        if (!std::filesystem::exists(path_))
            return {};
        const auto state = read_checkpoint(path_, problem_).state;
        DenseMatrix result(state.empty() ? 0 : state.front().size(), std::ssize(state));
        for (std::size_t i = 0; i < state.size(); ++i) {
            if (state[i].size() != result.rows())
                throw InvalidInput(
                    fmt::format("{} contains vectors of different sizes: run without --resume",
                                printable(path_.string())),
                    {.path = path_});
            result.col(static_cast<Index>(i)) = state[i];
        }
        return result;
    }

    void write(const DenseMatrix& vectors) const {
        Checkpoint checkpoint{problem_, static_cast<std::uint64_t>(vectors.cols())};
        for (Index i = 0; i < vectors.cols(); ++i)
            checkpoint.state.emplace_back(vectors.col(i));
        write_checkpoint(path_, checkpoint);
    }

private:
    std::filesystem::path path_;
    std::uint64_t problem_;
};

/// Eigensolvers keep a few vectors for each eigenpair. More than there are is another's to tell.
void check_cost(const FormSpace& space, Index count) {
    if (count > space.size())
        return;
    constexpr double vectors_each = 3;
    const double rows = space.size();
    check_memory(vectors_each * count * rows * sizeof(double),
                 fmt::format("a spectrum of {} eigenpairs of {} values", count, rows));
}

void draw(const SpectrumArguments& arguments, const Discretization& mesh, const Eigenvalues& answer,
          const Log& log) {
    const auto& out = arguments.picture.out;
    if (!is_page(out))
        return write_vtu(out, draw_modes(mesh, answer.spectrum), arguments.picture.vtu);
    Page page =
        draw_page(mesh, answer.spectrum,
                  fmt::format("{}: modes, {} {}-forms", arguments.mesh.mesh.filename().string(),
                              name(arguments.side), arguments.degree));
    auto& facts = page.text.facts;
    facts.insert(facts.begin() + 1, {answer.facts.conditions, in_words(answer.facts.stars)});
    write_page(out, std::move(page), log);
}

void run_spectrum(SpectrumArguments arguments) {
    Log log;
    const ConditionValues asked(arguments.conditions);
    check_picture(arguments.picture);
    if (!arguments.checkpoint.empty())
        check_output_file(arguments.checkpoint, {".checkpoint"});
    const Discretization mesh = load(arguments.mesh, log, arguments.picture.out);
    const FormSpace space = asked.space(mesh, arguments.side, arguments.degree, log.mesh);
    check_cost(space, arguments.spectrum.count);
    std::optional<Index> resumed;
    if (!arguments.checkpoint.empty()) {
        const FoundModes modes(arguments.checkpoint, space);
        if (arguments.resume)
            arguments.spectrum.start = modes.read();
        resumed = static_cast<Index>(arguments.spectrum.start.cols());
        arguments.spectrum.found = [modes](const DenseMatrix& found) { modes.write(found); };
    }
    log.timing.begin("solve");
    auto result = computed_on(log.mesh, [&] {
        const ProgressLine progress;
        arguments.spectrum.progress = [&](std::string_view what) { progress(what); };
        if (!arguments.certify)
            arguments.spectrum.certification = Certification::waived;
        return spectrum(space, arguments.spectrum);
    });
    const double seconds = log.timing.end();
    log.warn(result.warnings);
    const Eigenvalues answer{result,
                             {space.side(), space.degree(), space.in_words(), mesh.chosen_stars()},
                             seconds,
                             resumed};
    if (!arguments.picture.out.empty()) {
        log.timing.begin("write");
        draw(arguments, mesh, answer, log);
    }
    tell(answer, log, arguments.mesh.tell);
}

/// Of the simplices that were given, after flips: merged cells are no part of the shape.
void run_spectrum_of_shape(SpectrumArguments arguments) {
    Log log;
    const ConditionValues asked(arguments.conditions);
    arguments.mesh.merge = false;
    arguments.mesh.star = StarKind::galerkin; // shapes do not use stars
    const Discretization mesh = load(arguments.mesh, log);
    const auto boundary = asked.on(mesh).value_or(built_in_conditions(Side::primal));
    const std::string words =
        in_words(boundary_counts(mesh.complex(), boundary), arguments.degree, mesh.dimension());
    log.timing.begin("solve");
    ShapeSpectrumOptions& options = arguments.shape;
    options.degree = arguments.degree;
    options.count = arguments.spectrum.count;
    options.linear_solver = arguments.spectrum.linear_solver;
    options.eigen_solver = arguments.spectrum.eigen_solver;
    const FlippedShape shape = flipped(shape_of(mesh, boundary));
    const Index before = mesh.passage().is_identity() ? 0 : mesh.passage().flips().statistics.flips;
    const int n = mesh.dimension();
    const ShapeFacts facts{options.degree, options.level, n, before + shape.flips, words};
    if (!arguments.below.empty()) {
        ShapeCounts answer{facts, arguments.below, {}, shape.shape.pieces.size(n)};
        const CountOptions counting{options.degree, options.level, options.linear_solver};
        for (const double s : arguments.below) {
            answer.counts.push_back(
                computed_on(log.mesh, [&] { return count_below(shape.shape, s, counting); }));
            log.warn(answer.counts.back().warnings);
        }
        answer.seconds = log.timing.end();
        return tell(answer, log, arguments.mesh.tell);
    }
    const auto found = computed_on(log.mesh, [&] {
        const ProgressLine progress;
        options.progress = [&](std::string_view what) { progress(what); };
        return shape_spectrum(shape.shape, options);
    });
    ShapeEigenvalues answer{facts, found};
    answer.seconds = log.timing.end();
    log.warn(found.warnings);
    tell(answer, log, arguments.mesh.tell);
}

void add_shape(CLI::App& command, SpectrumArguments& arguments) {
    auto* of_shape = command
                         .add_flag("--of-shape", arguments.of_shape,
                                   "enclose the eigenvalues of the shape itself, not its mesh, for "
                                   "0-forms, n-forms, and 1-forms on surfaces; cells are not "
                                   "merged, and edges of surfaces are flipped")
                         ->excludes("--side");
    for (const char* const other : {"--star", "--tolerance", "--angle-tolerance", "--centers",
                                    "--out", "--checkpoint", "--no-certificate"})
        of_shape->excludes(command.get_option(other));
    command
        .add_option("--level", arguments.shape.level,
                    "N\twith --of-shape: bounds of order 2 (1) or 4 (2)")
        ->needs(of_shape);
    command
        .add_option("--width", arguments.shape.width,
                    "W\twith --of-shape: warn where (upper - lower) / upper bound exceeds W")
        ->needs(of_shape);
    command
        .add_option("--below", arguments.below,
                    "X ..\twith --of-shape: count the eigenvalues below each X instead")
        ->needs(of_shape)
        ->excludes("--count")
        ->excludes("--width");
    command
        .add_option(
            "--max-triangles", arguments.shape.max_triangles,
            "N\twith --of-shape: bisect simplices where bounds are wider than --width, up to "
            "N simplices (default: 0)")
        ->needs(of_shape);
}

} // namespace

void add_spectrum(CLI::App& app) {
    const auto [command, arguments] = add_command<SpectrumArguments>(
        app, "spectrum",
        "computes the smallest eigenpairs of the Laplace-de Rham operator, certified",
        [](const SpectrumArguments& given) {
            given.of_shape ? run_spectrum_of_shape(given) : run_spectrum(given);
        });
    add_forms(*command, arguments->side, arguments->degree);
    command->add_option("--count", arguments->spectrum.count, "N\tnumber of eigenpairs");
    command->add_flag("!--no-certificate", arguments->certify,
                      "skip the proof that no eigenvalue is missing");
    add_mesh_arguments(*command, arguments->mesh, StarKind::automatic);
    add_conditions(*command, arguments->conditions);
    add_robin(*command, arguments->conditions, "0");
    add_fixed(*command, arguments->conditions, "values 0");
    add_picture(*command, arguments->picture, "the modes");
    auto* checkpoint =
        command->add_option("--checkpoint", arguments->checkpoint,
                            "FILE\tsave eigenvectors to this .checkpoint file, batch by batch");
    command
        ->add_flag("--resume", arguments->resume,
                   "resume from the checkpoint if it exists, and certify again; --count may "
                   "differ, all other options must be the same")
        ->needs(checkpoint);
    add_engine(*command, arguments->spectrum.linear_solver);
    command->add_option("--eigen-engine", arguments->spectrum.eigen_solver,
                        "NAME\teigensolver; see `polydec backends`");
    add_shape(*command, *arguments);
    command->footer(
        "Dual K-forms live on the (n-K)-cells. The output states the boundary condition that was "
        "used.\n\nExamples:\n"
        "  polydec spectrum fandisk.off --count 20 -o modes.vtu\n"
        "  polydec spectrum sphere.obj --side dual --degree 1 --count 16 --json\n"
        "  polydec spectrum plate.msh --side dual --natural\n"
        "  polydec spectrum plate.msh --robin 2.5\n"
        "  polydec spectrum spot.obj --of-shape --count 5 --width 2e-4\n"
        "  polydec spectrum engine.msh --count 1000 --checkpoint engine.checkpoint --resume "
        "--json");
}

} // namespace polydec::tools
