// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// The coefficients of an additive Runge-Kutta method for y' = f + g: stages Y_i = y + h sum_j
/// (E_ij f_j + I_ij g_j) at the times c_i. E is strictly lower triangular; I is lower triangular,
/// with 0 and then one number on its diagonal. Both have the weights b.
struct AdditiveTable {
    int order = 0;
    int embedded_order = 0; ///< 0: no embedded method
    Vector times = {};
    DenseMatrix explicit_part = {}; ///< E
    DenseMatrix implicit_part = {}; ///< I; empty: no g
    Vector weights = {};
    Vector error_weights = {}; ///< b minus the embedded weights

    Eigen::Index stages() const { return times.size(); }

    /// Whether a step ends in the state of its last stage, and whether the method uses the rate g
    /// at its beginning.
    bool ends_at_last_stage(bool has_f, bool has_g) const;
    bool uses_first_stiff_rate() const;
};

/// 5(4), seven stages; the last stage is the first of the next step. Source: Dormand and Prince
/// 1980.
AdditiveTable dormand_prince();

/// ARK4(3)6L[2]SA: the implicit part is L-stable, with an explicit first stage; the last stage ends
/// the step. Source: Kennedy and Carpenter 2003.
AdditiveTable kennedy_carpenter();

/// Backward Euler, and the implicit midpoint rule, which for a linear g alone is the Crank-Nicolson
/// scheme. With f, the pairs (1,2,1) and (1,2,2), of orders 1 and 2. Source: Ascher, Ruuth, Spiteri
/// 1997.
AdditiveTable backward_euler();
AdditiveTable implicit_midpoint();

} // namespace polydec
