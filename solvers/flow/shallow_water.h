// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

#include <memory>
#include <vector>

namespace polydec {

struct ShallowWaterOptions {
    double gravity = 1;
    Vector rotation = {}; ///< vorticity of the frame at vertices, 2 Omega sin(latitude); or empty
    Vector bottom = {};   ///< height of the bottom in each cell; or empty
};

/// Shallow water on surfaces, cells of any polygon: dh/dt + div(h u) = 0 and du/dt + i_(h u) q =
/// -d(|u|^2 / 2 + g (h + b)), q = (rotation + du) / h the potential vorticity. The depth h is a
/// dual 0-form, u a dual 1-form along the duals of edges, so that w = star^-1 u is its flux. Walls
/// are not crossed and have free slip. The term of the vorticity is that of Advection, which does
/// no work, and kinetic energy and mass fluxes are derivatives of the energy: mass is kept to
/// rounding, energy but for steps in time, whatever the mesh. Marched by
/// Evolution (see below). Needs positive diagonal stars. All is
/// in the units of the input.
/// Source: Thuburn, Ringler, Skamarock, Klemp 2009 and Ringler et al. 2010 for the form; Arakawa,
/// Lamb 1981 for the principle.
class ShallowWater {
public:
    /// Throws InvalidInput for n other than 2, like Advection, where the star of edges is not
    /// positive or a matrix, and for data of other sizes.
    ShallowWater(const Discretization& mesh, const ShallowWaterOptions& options = {});

    /// Or its rate of change.
    struct State {
        Vector depth; ///< size(2) values, above 0
        Vector flux;  ///< w, size(1) values, 0 at the boundary
    };

    /// They all throw InvalidInput for states of other sizes, and naming the cell where the depth
    /// is not above 0.
    State rate(const State& state) const;

    /// The rates of the depth and the flux, as the reaction of an Evolution. Not a number where the
    /// depth is not above 0, so that an integrator takes a shorter step instead.
    std::vector<Vector> operator()(double time, const std::vector<Cochain>& forms) const;

    /// A step that waves and the flow allow: 1 over how often they cross a cell in a second.
    double stable_step(const State& state) const;

    double mass(const State& state) const;
    double energy(const State& state) const;

    /// q at the vertices, and the sum of h q^2 / 2 over their duals.
    Vector potential_vorticity(const State& state) const;
    double potential_enstrophy(const State& state) const;

private:
    struct Parts;

    std::shared_ptr<const Parts> parts_;
};

} // namespace polydec
