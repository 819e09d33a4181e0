// SPDX-License-Identifier: MIT
#include "tests/fuzz/laws.h"

#include "complex/homology.h"
#include "dec/discretization/diagnosis.h"
#include "dec/fields/cell_centers.h"
#include "dec/stars/star.h"
#include "solvers/sources/poisson.h"
#include "tests/fuzz/target.h"

#include <cmath>
#include <optional>

namespace polydec::fuzz {

namespace {

double binomial(int n, int k) {
    return k == 0 ? 1.0 : binomial(n - 1, k - 1) * n / k;
}

void require_volumes(const CellComplex& complex, const CellVolumes& volumes) {
    const int n = complex.dimension();
    require(volumes.dimension() == n, "there are volumes of every degree");
    for (int k = 0; k <= n; ++k) {
        require(volumes.primal(k).size() == complex.size(k) &&
                    volumes.dual(k).size() == complex.size(k),
                "every cell has a volume");
        require(volumes.primal(k).allFinite() && volumes.dual(k).allFinite(), "volumes are finite");
        require(volumes.primal(k).minCoeff() > 0, "volumes are positive");
        Vector values;
        if (accepts([&] { values = star(volumes, k).diagonal(); }))
            require(values.allFinite(), "stars are finite");
        if (accepts([&] { values = star(volumes, k).inverse(); }))
            require(values.allFinite(), "inverse stars are finite");
    }
}

/// sum |s||*s| = C(n,k) |K|, to what cancels in the duals.
void require_duals_that_fill(const CellVolumes& volumes) {
    const int n = volumes.dimension();
    const double whole = volumes.primal(n).sum();
    for (int k = 0; k <= n; ++k) {
        const double sum = volumes.primal(k).dot(volumes.dual(k));
        const double size = volumes.primal(k).dot(volumes.terms(k).vector());
        require(std::abs(sum - binomial(n, k) * whole) <= 1e-9 * size,
                "duals and cells fill the mesh");
    }
}

/// What `polydec info` tells.
void require_diagnosis(const Discretization& mesh) {
    const auto facts = diagnose(mesh);
    const auto is_told = [](const std::optional<double>& number) {
        return std::isfinite(number.value_or(0)); // none is what the units of the file cannot say
    };
    require(is_told(facts.volume) && facts.volume.value_or(1) > 0, "volumes are told");
    require(facts.components >= 1 && facts.boundary_components >= 0, "there are components");
    for (const auto& numbers : {facts.stars.input, facts.stars.merged})
        for (const auto& star : numbers)
            require(is_told(star.min) && is_told(star.max) && is_told(star.condition),
                    "stars are told as numbers");
    for (const auto& advice : facts.advice)
        require_message(in_words(advice, facts.dimension));
}

} // namespace

void require_laws(const Discretization& mesh) {
    for (const auto& warning : mesh.warnings())
        require_message(warning);
    require_topology(mesh.input());
    require_topology(mesh.complex());
    require(betti_numbers(mesh.input()) == betti_numbers(mesh.complex()),
            "merging keeps the topology");
    require_volumes(mesh.complex(), mesh.volumes());
    require_diagnosis(mesh);
    if (!mesh.passage().is_identity())
        return;
    require_volumes(mesh.input(), mesh.input_geometry().volumes());
    require_duals_that_fill(mesh.input_geometry().volumes());
}

void require_poisson(const Discretization& mesh) {
    for (const Side side : {Side::primal, Side::dual}) {
        accepts<SolverFailure>([&] {
            accepts([&] {
                const PoissonSolver solver({mesh, side, 0, {BoundaryCondition::essential}});
                const auto found = solver.solve(
                    {side, 0, Vector::Ones(sites(mesh, side).rows())},
                    {.values = Vector::LinSpaced(boundary_sites(mesh, side).rows(), 0.0, 1.0)});
                require(found.form.values.allFinite() && std::isfinite(found.report.residual),
                        "solutions are finite");
            });
        });
    }
}

} // namespace polydec::fuzz
