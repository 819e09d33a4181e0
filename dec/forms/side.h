// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Primal k-forms live on the k-cells, dual k-forms on the duals of the (n-k)-cells.
enum class Side { primal, dual };

inline const char* name(Side side) {
    return side == Side::primal ? "primal" : "dual";
}

} // namespace polydec
