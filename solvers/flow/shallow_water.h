// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"

#include <vector>

namespace polydec {

struct ShallowWaterOptions {
    double gravity = 1;
    Vector rotation = {}; ///< vorticity of the frame at vertices, 2 Omega sin(latitude); or empty
    Vector bottom = {};   ///< height of the bottom in each cell; or empty
};

/// Shallow water on surfaces with cells of any shape: dh/dt + div(h u) = 0 and du/dt + i_(h u) q =
/// -d(|u|^2 / 2 + g (h + b)), with q = (rotation + du) / h the potential vorticity. The depth h is
/// a dual 0-form, u a dual 1-form, known by its flux w = star^-1 u. Walls are closed and slip. Mass
/// is conserved to rounding, energy up to the error of time steps, on every mesh: the vorticity
/// term does no work (see Advection), and kinetic energy and mass fluxes are derivatives of the
/// energy. Needs positive diagonal stars. Evolution marches it. All is in the units of the input.
/// Source: Thuburn, Ringler, Skamarock, Klemp 2009 and Ringler et al. 2010 for the form; Arakawa,
/// Lamb 1981 for the principle.
class ShallowWater {
public:
    /// Throws InvalidInput for n other than 2, for a star of edges that is not positive or is a
    /// matrix, for data of wrong sizes, and like Advection.
    ShallowWater(const Discretization& mesh, const ShallowWaterOptions& options = {});

    /// A state, or its rate of change.
    struct State {
        Vector depth; ///< size(2) values, above 0
        Vector flux;  ///< w, size(1) values, 0 at the boundary
    };

    /// All members that take a State throw InvalidInput for wrong sizes and, naming the cell, for a
    /// depth that is not above 0.
    State rate(const State& state) const;

    /// The rates of the depth and the flux, as the reaction of an Evolution. Not a number where the
    /// depth is not above 0, so that an integrator takes a shorter step instead.
    std::vector<Vector> operator()(double time, const std::vector<Cochain>& forms) const;

    /// Stable time step of explicit schemes, for waves and advection.
    double stable_step(const State& state) const;

    double mass(const State& state) const;
    double energy(const State& state) const;

    /// q at the vertices, size(0), and the sum of h q^2 / 2 over their duals.
    Vector potential_vorticity(const State& state) const;
    double potential_enstrophy(const State& state) const;

private:
    struct Parts;

    Shared<const Parts> parts_;
};

} // namespace polydec
