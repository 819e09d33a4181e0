// SPDX-License-Identifier: MIT
#include "solvers/darcy.h"

#include "dec/forms/derivative.h"
#include "solvers/dual_fluxes.h"

#include <utility>

namespace polydec {

namespace {

PoissonOptions with_dual_side(PoissonOptions options) {
    options.side = Side::dual;
    return options;
}

} // namespace

DarcySolver::DarcySolver(const Discretization& discretization, PoissonOptions options)
    : poisson_(discretization, with_dual_side(options)), complex_(discretization.complex()) {
    const int n = complex_.dimension();
    const auto essential = essential_cells(complex_, options.boundary);
    volumes_ = discretization.volumes().primal(n);
    areas_ = discretization.volumes().primal(n - 1);
    weights_ = dual_fluxes(discretization, essential, options.conductivity).weights;
    divergence_ = derivative(complex_, n - 1);
    essential_ = essential[n - 1];
}

DarcyFlow DarcySolver::solve(const Vector& source, const Vector& pressures, const Vector& outflow) {
    const int n = complex_.dimension();
    const Vector p = poisson_.solve(source, pressures, -outflow);

    // through a facet flows its weight times the difference of the pressures on its sides
    Vector difference = divergence_.transpose() * p;
    const auto& counts = complex_.coface_counts(n - 1);
    const SparseMatrix cofaces = divergence_.transpose();
    Vector open = Vector::Zero(areas_.size()); // of the facets that close a balance
    Vector flux(areas_.size());
    for (Index f = 0; f < flux.size(); ++f) {
        const bool boundary = counts[f] == 1;
        const double outward = boundary ? SparseMatrix::InnerIterator(cofaces, f).value() : 0;
        if (boundary && essential_[f]) {
            difference[f] -= outward * pressures[f];
            open[f] = weights_[f] == 0 ? areas_[f] : 0;
        }
        flux[f] = boundary && !essential_[f] ? outward * outflow[f] * areas_[f]
                                             : weights_[f] * difference[f];
    }

    const SparseMatrix sides = divergence_.cwiseAbs();
    const Vector missing = volumes_.cwiseProduct(source) - divergence_ * flux;
    const Vector room = sides * open;
    for (Index f = 0; f < flux.size(); ++f)
        if (open[f] > 0) {
            const SparseMatrix::InnerIterator cell(cofaces, f);
            flux[f] = cell.value() * missing[cell.col()] * open[f] / room[cell.col()];
        }
    return {{Side::dual, 0, p}, {Side::primal, n - 1, std::move(flux)}};
}

} // namespace polydec
