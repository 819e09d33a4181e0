// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// What is known of a flow at a facet of the boundary.
enum class FlowBoundary {
    free_slip, ///< the flux; the wall holds nothing back: no vorticity on it
    no_slip,   ///< the flux and the velocity along the wall
    open,      ///< the pressure: the flow goes in and out as it likes
};

} // namespace polydec
