// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// What is known of a flow at a facet of the boundary: the flux through it or the pressure, and the
/// velocity along it or that it has no vorticity.
enum class FlowBoundary {
    free_slip, ///< the flux, and no vorticity: a wall that holds nothing back
    no_slip,   ///< the flux, and the velocity along the wall
    open,      ///< the pressure, and no vorticity: the fluid enters and leaves as it likes
    pressure,  ///< the pressure, and the velocity along the facet
};

} // namespace polydec
