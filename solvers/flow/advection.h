// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "dec/discretization/discretization.h"
#include "dec/fields/lie_derivative.h"
#include "dec/forms/cochain.h"
#include "dec/forms/operator.h"

#include <vector>

namespace polydec {

/// Advection of flows in vector-invariant form: the force i_u omega that a flow with the fluxes w
/// (a primal (n-1)-form) meets in the vorticity z, along the duals of facets, size(n-1) values. z
/// is the primal (n-2)-form star^-1 omega: for n = 2 the vorticity at vertices, for n = 3 its
/// circulation along edges. Any n >= 2, cells of any shape, lengths alone.
///
/// In each n-cell P the mean velocity is Perot's, the sum over its facets of w(f) r_f / |P| with
/// r_f from the centroid of P to that of f, w positive outwards. In the cone C of a facet over the
/// centroid what lacks of w(f) is added along its normal, less the mean of all that is added; there
/// z is its Whitney form at the facet. Then w' . A(z) w = sum over cones of |C| z ^ u ^ u', which
/// is antisymmetric in u and u': A(z) is an antisymmetric matrix on every mesh, and does no work to
/// rounding. For constant z and u on flat cells A(z) w is exactly the integral of i_u omega from
/// centroid to centroid: along dual edges but for a gradient of cells, which the pressure takes.
/// Source: Mullen et al. 2009 for the principle; Perot 2000 for the mean velocity; Eymard,
/// Gallouet, Herbin 2010 for what is added in cones. All is in the units of the input.
class Advection {
public:
    /// Throws InvalidInput for n < 2, naming facets where cells are not oriented alike or branch,
    /// and naming a cell that lies on both sides of a facet.
    explicit Advection(const Discretization& mesh);

    int dimension() const;

    /// A(z) w; z has size(n-2) values, w size(n-1), or else InvalidInput is thrown.
    Vector operator()(const Vector& z, const Vector& w) const;

    /// A(z): size(n-1) x size(n-1), antisymmetric.
    SparseMatrix matrix(const Vector& z) const;

    /// |u|^2 / 2 in each n-cell.
    Vector kinetic_energy(const Vector& w) const;

    /// How often a second the content of an n-cell is exchanged, at most: half the sum of |w| over
    /// its facets, over its volume. Explicit steps must be about as short as its inverse.
    double exchange_rate(const Vector& w) const;

private:
    struct Parts;

    Shared<const Parts> parts_;
};

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
    /// InvalidInput for other numbers of values, and for values that are not finite.
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
