// SPDX-License-Identifier: MIT
#include "solvers/spectrum.h"

#include "dec/star.h"
#include "io/draw_cells.h"
#include "io/draw_modes.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace polydec::tools {

namespace {

struct Arguments {
    MeshArguments mesh;
    SpectrumOptions spectrum;
    ConditionArguments conditions;
    bool certify = true;
    std::filesystem::path out;
};

Json list(const Vector& values) {
    return std::vector<double>(values.begin(), values.end());
}

Json describe(const Spectrum& spectrum, double seconds) {
    const auto& certificate = spectrum.certificate;
    return {{"side", name(spectrum.side)},
            {"degree", spectrum.degree},
            {"eigenvalues", list(spectrum.eigenvalues)},
            {"residuals", list(spectrum.residuals)},
            {"certificate",
             {{"shift", certificate.shift},
              {"below_shift", certificate.below_shift},
              {"returned_below_shift", certificate.returned_below_shift},
              {"complete", certificate.complete}}},
            {"linear_solver", spectrum.linear_solver},
            {"eigen_solver", spectrum.eigen_solver},
            {"seconds", seconds}};
}

void print(const Spectrum& spectrum, const std::string& conditions, double seconds) {
    fmt::print("Laplace-de Rham operator on {} {}-forms, {} smallest eigenvalues\n{}\n\n"
               "{:>5}  {:>20}  {:>10}\n",
               name(spectrum.side), spectrum.degree, spectrum.eigenvalues.size(), conditions, "",
               "eigenvalue", "residual");
    for (Index i = 0; i < spectrum.eigenvalues.size(); ++i)
        fmt::print("{:>5}  {:>20.12g}  {:>10.2e}\n", i, spectrum.eigenvalues[i],
                   spectrum.residuals[i]);
    const auto& certificate = spectrum.certificate;
    if (certificate.complete)
        fmt::print("\ncertified: {} eigenvalues lie below {:.8g} by inertia, {} were computed\n",
                   certificate.below_shift, certificate.shift, certificate.returned_below_shift);
    else
        fmt::print("\nnot certified: copies of multiple eigenvalues may be missing\n");
    fmt::print("{} with {}, {:.2f} s\n", spectrum.eigen_solver, spectrum.linear_solver, seconds);
}

/// Negative duals make A indefinite; the negative eigenvalues they bring come first and mean
/// nothing.
std::optional<std::string> spurious_eigenvalues(const Discretization& mesh,
                                                const Spectrum& spectrum) {
    const int k =
        spectrum.side == Side::primal ? spectrum.degree : mesh.dimension() - spectrum.degree;
    const Vector& lambda = spectrum.eigenvalues;
    constexpr double rounding = 1e-9;
    const auto negative = std::count_if(lambda.begin(), lambda.end(), [&](double value) {
        return value < -rounding * lambda.cwiseAbs().maxCoeff();
    });
    std::size_t duals = 0;
    for (const int j : {k - 1, k + 1})
        if (j >= 0 && j <= mesh.dimension())
            duals += negative_star_cells(mesh.volumes, j).size();
    if (negative == 0 || duals == 0)
        return std::nullopt;
    return fmt::format("{} of the eigenvalues are negative and spurious: {} cells next to these "
                       "forms have a negative dual (the mesh is not Delaunay there){}",
                       negative, duals, flip_advice(mesh));
}

void run(Arguments arguments) {
    Timing timing;
    const Discretization mesh = load(arguments.mesh, timing);
    if (!arguments.out.empty())
        check_drawable(mesh.dimension(), static_cast<int>(mesh.points.cols()));
    const auto boundary = conditions(mesh, arguments.conditions)
                              .value_or(built_in_conditions(arguments.spectrum.side));
    timing.begin("solve");
    const auto since = std::chrono::steady_clock::now();
    const auto result = [&] {
        const Progress progress;
        arguments.spectrum.progress = [&](std::string_view what) { progress(what); };
        if (!arguments.certify)
            arguments.spectrum.certification = Certification::waived;
        return spectrum(mesh, boundary, arguments.spectrum);
    }();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - since;

    if (!arguments.out.empty()) {
        timing.begin("write");
        write_vtu(arguments.out, mesh, result);
    }
    Json answer = describe(result, seconds.count());
    const auto words = in_words(boundary, mesh.complex(), result.degree);
    answer["conditions"] = words;
    answer["warnings"] = mesh.warnings;
    if (const auto spurious = spurious_eigenvalues(mesh, result)) {
        warn(*spurious);
        answer["warnings"].push_back(*spurious);
    }
    add_timing(answer, arguments.mesh, timing);
    if (arguments.mesh.json) {
        fmt::print("{}\n", answer.dump());
        return;
    }
    print(result, words, seconds.count());
    print_timing(arguments.mesh, timing);
}

} // namespace

void add_spectrum(CLI::App& app) {
    auto* command = app.add_subcommand(
        "spectrum", "smallest eigenpairs of the Laplace-de Rham operator, certified");
    const auto arguments = std::make_shared<Arguments>();
    add_mesh_arguments(*command, arguments->mesh, JsonOption::offered);
    add_side(*command, arguments->spectrum.side)->required();
    command->add_option("--degree", arguments->spectrum.degree, "degree of the forms")->required();
    command->add_option("--count", arguments->spectrum.count, "how many eigenpairs")
        ->capture_default_str();
    add_conditions(*command, arguments->conditions,
                   "no flow through the boundary (Neumann); of forms of degree\n"
                   "1 .. n-1 the normal part is 0 there",
                   "values 0 (Dirichlet) at boundary facets where this is not 0, of\n"
                   "forms of degree 1 .. n-1 the tangential part; no flow through\n"
                   "the others");
    command->add_option("-o,--out", arguments->out, "write the modes to this .vtu file");
    command->add_flag("!--no-certificate", arguments->certify, "do without the proof");
    command->add_option("--engine", arguments->spectrum.linear_solver, "linear solver")
        ->capture_default_str();
    command->add_option("--eigen-engine", arguments->spectrum.eigen_solver, "eigensolver")
        ->capture_default_str();
    command->footer(
        "Dual K-forms live on the (n-K)-cells. On the boundary, primal forms have what --natural\n"
        "asks for unless told otherwise; dual forms have values 0 (Dirichlet), as by\n"
        "--essential-where 1. The answer says which condition held.\n\nExamples:\n"
        "  polydec spectrum fandisk.off --side primal --degree 0 --count 20 -o modes.vtu\n"
        "  polydec spectrum sphere.obj --side dual --degree 1 --count 16 --json\n"
        "  polydec spectrum plate.msh --side dual --degree 0 --natural");
    command->callback([arguments] { run(*arguments); });
}

} // namespace polydec::tools
