// SPDX-License-Identifier: MIT
#include "distributed/spectrum.h"

#include "base/errors.h"
#include "distributed/shared_picture.h"
#include "tools/messages.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"
#include "tools/spectrum_answer.h"

#include <fmt/format.h>

namespace polydec::tools {

namespace {

struct SharedSpectrumArguments {
    SharedArguments mesh;
    Side side = Side::primal;
    int degree = 0;
    SpectrumOptions spectrum;
    bool certify = true;
};

/// The modes on vertices or n-cells, which a picture shows.
std::vector<SharedValues> modes_to_show(const Spectrum& spectrum, int k) {
    std::vector<SharedValues> values;
    for (Index i = 0; i < spectrum.modes.cols(); ++i)
        values.push_back({fmt::format("mode_{}", i), k, spectrum.modes.col(i)});
    return values;
}

void run_spectrum(const Ranks& ranks, SharedSpectrumArguments arguments) {
    Log log = log_of(ranks);
    check_output_file(ranks, arguments.mesh.out, ".pvtu");
    const DistributedMesh mesh = load(ranks, arguments.mesh, log);
    const int n = mesh.dimension();
    const Side side = arguments.side;
    const int degree = arguments.degree;
    const int k = side == Side::primal ? degree : n - degree;
    if (!arguments.mesh.out.empty() && k != 0 && k != n)
        throw InvalidInput(fmt::format("cannot write {}: several ranks write only functions on "
                                       "vertices and cells; omit the file",
                                       arguments.mesh.out.string()));
    log.timing.begin("solve");
    if (!arguments.certify)
        arguments.spectrum.certification = Certification::waived;
    auto result = computed_on(arguments.mesh.mesh.mesh, [&] {
        const SharedProgress progress(ranks);
        return spectrum(ranks, mesh, side, degree, arguments.spectrum);
    });
    const double seconds = log.timing.end();
    use_input_units(result, n, mesh.unit);
    if (ranks.any(result.modes.cols() == 0)) // values of one rank may be out of range
        result.modes.resize(result.modes.rows(), 0);
    log.warn(result.warnings);
    if (!arguments.mesh.out.empty()) {
        log.timing.begin("write");
        write_pvtu(ranks, arguments.mesh.out, mesh, modes_to_show(result, k));
    }
    log.warn(warning_of_rough_values(result.rough));
    const BoundaryCounts on = boundary_counts(ranks, mesh, built_in_conditions(side));
    const Eigenvalues answer{result, facts_of(mesh, side, degree, in_words(on, degree, n)),
                             seconds};
    tell(ranks, mesh, answer, log, arguments.mesh.mesh.tell);
}

} // namespace

void add_shared_spectrum(CLI::App& app, const Ranks& ranks) {
    const auto [command, arguments] = add_command<SharedSpectrumArguments>(
        app, "spectrum",
        "computes the smallest eigenpairs of the Laplace-de Rham operator, certified",
        [ranks](const SharedSpectrumArguments& given) { run_spectrum(ranks, given); });
    add_shared_arguments(*command, arguments->mesh);
    add_star(*command, arguments->mesh.mesh, StarKind::automatic);
    add_forms(*command, arguments->side, arguments->degree);
    command->add_option("--count", arguments->spectrum.count, "N\tnumber of eigenpairs");
    add_picture(*command, arguments->mesh.out, "modes on vertices or cells", false);
    command->add_flag("!--no-certificate", arguments->certify,
                      "skip the proof that no eigenvalue is missing");
    refuse_options(*command,
                   {"--natural", "--essential-where", "--engine", "--eigen-engine", "--float32"});
    command->footer(
        "Several ranks support only circumcentric stars, which must be positive. Primal "
        "forms have no flow through the boundary (Neumann), dual ones values 0 "
        "(Dirichlet).\n\n"
        "Example:\n  mpirun -n 4 polydec-mpi spectrum sphere.pdm --side dual --degree "
        "0 --count 20 -o modes.pvtu");
}

} // namespace polydec::tools
