// SPDX-License-Identifier: MIT
#include "solvers/darcy.h"

#include "dec/forms/derivative.h"
#include "meshes/unit_of_length.h"
#include "solvers/mixed_poisson.h"

#include <utility>

namespace polydec {

namespace {

PoissonOptions with_dual_side(PoissonOptions options) {
    options.side = Side::dual;
    return options;
}

} // namespace

DarcySolver::DarcySolver(const Discretization& mesh, const PoissonOptions& options)
    : DarcySolver(mesh.complex(), mesh.volumes(), PoissonSolver(mesh, with_dual_side(options)),
                  options.boundary) {}

DarcySolver::DarcySolver(const Cells& cells, const PoissonOptions& options)
    : DarcySolver(cells.complex(), cells.volumes(), PoissonSolver(cells, with_dual_side(options)),
                  options.boundary) {}

DarcySolver::DarcySolver(const CellComplex& complex, const CellVolumes& volumes,
                         PoissonSolver poisson, const BoundaryConditions& conditions)
    : poisson_(std::move(poisson)),
      complex_(complex),
      volumes_(volumes),
      essential_(essential_cells(complex, conditions)[complex.dimension() - 1]) {
    refuse_robin(complex, conditions, "Darcy's problem");
}

DarcyFlow DarcySolver::solve(const Vector& source, const Vector& pressures,
                             const Vector& outflow) const {
    poisson_.check(source, pressures, -outflow);
    DarcyFlow flow = solve_in_unit(poisson_.in_unit(source, 2, "sources"), pressures,
                                   poisson_.in_unit(outflow, 1, "outflow"));
    flow.flux.values =
        form_in_input_units(flow.flux.values, poisson_.unit_, complex_.dimension() - 2, "fluxes");
    return flow;
}

DarcyFlow DarcySolver::solve_in_unit(const Vector& source, const Vector& pressures,
                                     const Vector& outflow) const {
    const int n = complex_.dimension();
    if (poisson_.mixed_)
        return mixed_flow(source, pressures, outflow);
    const auto [columns, report, compatibility, warnings] =
        poisson_.solve_in_unit(source, pressures, -outflow);
    const Vector p = columns;
    const SparseMatrix divergence = derivative(complex_, n - 1);
    const Vector &areas = volumes_.primal(n - 1), &weights = poisson_.facet_weights();

    // through a facet flows its weight times the difference of the pressures on its sides
    Vector difference = divergence.transpose() * p;
    const auto& counts = complex_.coface_counts(n - 1);
    const SparseMatrix cofaces = divergence.transpose();
    Vector open = Vector::Zero(areas.size()); // of the facets that close a balance
    Vector flux(areas.size());
    for (Index f = 0; f < flux.size(); ++f) {
        const bool boundary = counts[f] == 1;
        const double outward = boundary ? SparseMatrix::InnerIterator(cofaces, f).value() : 0;
        if (boundary && essential_[f]) {
            difference[f] -= outward * pressures[f];
            open[f] = weights[f] == 0 ? areas[f] : 0;
        }
        flux[f] = boundary && !essential_[f] ? outward * outflow[f] * areas[f]
                                             : weights[f] * difference[f];
    }

    const SparseMatrix sides = divergence.cwiseAbs();
    const Vector missing = volumes_.primal(n).cwiseProduct(source) - divergence * flux;
    const Vector room = sides * open;
    for (Index f = 0; f < flux.size(); ++f)
        if (open[f] > 0) {
            const SparseMatrix::InnerIterator cell(cofaces, f);
            flux[f] = cell.value() * missing[cell.col()] * open[f] / room[cell.col()];
        }
    return {{Side::dual, 0, p},
            {Side::primal, n - 1, std::move(flux)},
            report,
            compatibility,
            warnings};
}

DarcyFlow DarcySolver::mixed_flow(const Vector& source, const Vector& pressures,
                                  const Vector& outflow) const {
    const int n = complex_.dimension();
    auto flow = poisson_.mixed_->solve(volumes_.primal(n).cwiseProduct(source), pressures,
                                       volumes_.primal(n - 1).cwiseProduct(outflow));
    return {{Side::dual, 0, std::move(flow.values)},
            {Side::primal, n - 1, std::move(flow.flux)},
            std::move(flow.report),
            flow.compatibility,
            warning_of(flow.compatibility)};
}

} // namespace polydec
