// SPDX-License-Identifier: MIT
#include "solvers/spectrum.h"

#include "dec/star.h"
#include "io/draw_cells.h"
#include "io/draw_modes.h"
#include "meshes/unit_of_length.h"
#include "tools/commands.h"
#include "tools/common.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace polydec::tools {

namespace {

struct Arguments {
    MeshArguments mesh;
    SpectrumOptions spectrum;
    bool certify = true;
    std::filesystem::path out;
};

struct Eigenvalues : Answer {
    const Spectrum& spectrum;
    double seconds;

    Eigenvalues(const Spectrum& spectrum, double seconds) : spectrum(spectrum), seconds(seconds) {}

    void write(JsonWriter& json) const override {
        const auto& certificate = spectrum.certificate;
        json.member("side", name(spectrum.side));
        json.member("degree", spectrum.degree);
        json.member("eigenvalues", spectrum.eigenvalues);
        json.member("radii", spectrum.radii);
        json.member("residuals", spectrum.residuals);
        json.object("certificate", [&] {
            json.member("shift", certificate.shift);
            json.member("below_shift", certificate.below_shift);
            json.member("returned_below_shift", certificate.returned_below_shift);
            json.member("complete", certificate.complete);
        });
        json.member("linear_solver", spectrum.linear_solver);
        json.member("eigen_solver", spectrum.eigen_solver);
        json.member("seconds", seconds);
    }

    void write(Text& text) const override {
        text("Laplace-de Rham operator on {} {}-forms, {} smallest eigenvalues\n\n{:>5}  {:>20}  "
             "{:>10}  {:>10}\n",
             name(spectrum.side), spectrum.degree, spectrum.eigenvalues.size(), "", "eigenvalue",
             "radius", "residual");
        for (Index i = 0; i < spectrum.eigenvalues.size(); ++i)
            text("{:>5}  {:>20.12g}  {:>10.2e}  {:>10.2e}\n", i, spectrum.eigenvalues[i],
                 spectrum.radii[i], spectrum.residuals[i]);
        const auto& certificate = spectrum.certificate;
        if (certificate.complete)
            text("\ncertified: {} eigenvalues lie below {:.8g} by inertia, {} were computed, each "
                 "within its radius of the value\n",
                 certificate.below_shift, certificate.shift, certificate.returned_below_shift);
        else
            text("\nnot certified: copies of multiple eigenvalues may be missing\n");
        text("{} with {}, {:.2f} s\n", spectrum.eigen_solver, spectrum.linear_solver, seconds);
    }
};

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

/// What is measured in length^-2, in the units of the file. What is rounding beside the largest
/// number may vanish; radii then grow by what is lost there.
void use_input_units(Spectrum& spectrum, double unit) {
    if (unit == 1)
        return;
    auto& shift = spectrum.certificate.shift; // behind them all, where they are rounding alone
    const double largest = std::max(spectrum.eigenvalues.cwiseAbs().maxCoeff(), std::abs(shift));
    in_input_units(Vector::Constant(1, largest), unit, -2, "eigenvalues");
    const auto convert = [&](double& value) { value = std::ldexp(value, -2 * std::ilogb(unit)); };
    std::for_each(spectrum.eigenvalues.begin(), spectrum.eigenvalues.end(), convert);
    std::for_each(spectrum.residuals.begin(), spectrum.residuals.end(), convert);
    std::for_each(spectrum.radii.begin(), spectrum.radii.end(), convert);
    convert(shift);
    // the value and the radius are each off by half of the least number there is
    for (double& radius : spectrum.radii)
        if (radius < std::numeric_limits<double>::min())
            radius += std::numeric_limits<double>::denorm_min();
}

void run(Arguments arguments) {
    Log log;
    const Discretization mesh = load(arguments.mesh, log);
    if (!arguments.out.empty())
        check_drawable(mesh.dimension(), static_cast<int>(mesh.points.cols()));
    log.timing.begin("solve");
    const auto since = std::chrono::steady_clock::now();
    auto result = [&] {
        const Progress progress;
        arguments.spectrum.progress = [&](std::string_view what) { progress(what); };
        if (!arguments.certify)
            arguments.spectrum.certification = Certification::waived;
        return spectrum(mesh, arguments.spectrum);
    }();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - since;

    if (const auto spurious = spurious_eigenvalues(mesh, result))
        log.warn(*spurious);
    if (!arguments.out.empty()) {
        log.timing.begin("write");
        write_vtu(arguments.out, mesh, result);
    }
    use_input_units(result, mesh.unit);
    tell(Eigenvalues(result, seconds.count()), log, arguments.mesh.tell);
}

} // namespace

void add_spectrum(CLI::App& app) {
    auto* command = app.add_subcommand(
        "spectrum", "smallest eigenpairs of the Laplace-de Rham operator, certified");
    const auto arguments = std::make_shared<Arguments>();
    add_mesh_arguments(*command, arguments->mesh);
    add_side(*command, arguments->spectrum.side)->required();
    command->add_option("--degree", arguments->spectrum.degree, "degree of the forms")->required();
    command->add_option("--count", arguments->spectrum.count, "how many eigenpairs")
        ->capture_default_str();
    command->add_option("-o,--out", arguments->out, "write the modes to this .vtu file");
    command->add_flag("!--no-certificate", arguments->certify, "do without the proof");
    command->add_option("--engine", arguments->spectrum.linear_solver, "linear solver")
        ->capture_default_str();
    command->add_option("--eigen-engine", arguments->spectrum.eigen_solver, "eigensolver")
        ->capture_default_str();
    command->footer(
        "Dual K-forms live on the (n-K)-cells.\n\nExamples:\n"
        "  polydec spectrum fandisk.off --side primal --degree 0 --count 20 -o modes.vtu\n"
        "  polydec spectrum sphere.obj --side dual --degree 1 --count 16 --json");
    command->callback([arguments] { run(*arguments); });
}

} // namespace polydec::tools
