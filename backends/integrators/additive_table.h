// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// The coefficients of an additive Runge-Kutta method for y' = f + g: stages Y_i = y + h sum_j
/// (E_ij f_j + I_ij g_j) at the times c_i, of which E is strictly lower triangular and I lower
/// triangular with 0 first and then one number on its diagonal; both with the weights b.
struct AdditiveTable {
    int order = 0;
    int embedded_order = 0; ///< 0: there is no embedded method
    Vector times = {};
    DenseMatrix explicit_part = {}; ///< E
    DenseMatrix implicit_part = {}; ///< I; empty: f alone
    Vector weights = {};
    Vector error_weights = {}; ///< b less those of the embedded method

    Eigen::Index stages() const { return times.size(); }

    /// Whether the end of a step is the state of its last stage, and whether the rate g at its
    /// beginning matters.
    bool ends_at_last_stage(bool has_f, bool has_g) const;
    bool uses_first_stiff_rate() const;
};

/// 5(4), seven stages, of which the last one is the first of the next step.
/// Source: Dormand and Prince 1980.
const AdditiveTable& dormand_prince();

/// ARK4(3)6L[2]SA: the implicit part is L-stable, its first stage explicit and its last one the
/// end of the step. Source: Kennedy and Carpenter 2003.
const AdditiveTable& kennedy_carpenter();

/// Backward Euler, and the implicit midpoint rule: for a linear g alone the scheme of Crank and
/// Nicolson. With f the pairs (1,2,1) and (1,2,2), of orders 1 and 2.
/// Source: Ascher, Ruuth, Spiteri 1997.
const AdditiveTable& backward_euler();
const AdditiveTable& implicit_midpoint();

} // namespace polydec
