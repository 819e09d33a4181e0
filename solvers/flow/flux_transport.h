// SPDX-License-Identifier: MIT
#pragma once

#include "dec/fields/interior_product.h"
#include "dec/forms/operator.h"

#include <vector>

namespace polydec {

/// Transport of a density by fluxes: d rho/dt + div(rho u) = 0 for a dual 0-form rho, the density
/// in each n-cell, and the flux w of u, a primal (n-1)-form, which need not be free of divergence
/// and may be another one at every call. What leaves a cell through a facet enters the next, so the
/// mass, the sum of density times volume, changes by what crosses the boundary alone, to rounding.
/// Upwind, through a facet goes the density of the cell that it leaves: of first order; steps up to
/// stable_step make no new extremes where d w = 0, and nothing negative anywhere. Centered, the
/// mean of both: of second order on symmetric cells, without loss of squares where d w = 0. What
/// flows in through the boundary has a density that is given.
class FluxTransport {
public:
    /// Throws InvalidInput, naming a facet, if cells branch or are not oriented alike.
    explicit FluxTransport(const Cells& cells, Sampling sampling = Sampling::upwind);

    /// Mass through each facet, as it is oriented: size(n-1). outside has a density for each facet,
    /// of which those count where the flux goes in through the boundary; empty: 0. They all throw
    /// InvalidInput for other numbers of values.
    Vector mass_flux(const Vector& flux, const Vector& density, const Vector& outside = {}) const;

    /// d rho/dt: size(n).
    Vector rate(const Vector& flux, const Vector& density, const Vector& outside = {}) const;

    /// The time in which so much leaves some cell as is in it. Infinity at rest.
    double stable_step(const Vector& flux) const;

    /// What is in the cells: the sum of density times volume.
    double mass(const Vector& density) const;

    /// What crosses the boundary, outwards, per time.
    double outflow(const Vector& mass_flux) const;

private:
    struct Sides {
        Index back, front; ///< a flux above 0 goes from one to the other; -1 outside
    };

    CellComplex complex_;
    Vector volumes_;
    Sampling sampling_;
    std::vector<Sides> sides_; // of facets
};

} // namespace polydec
