// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// The coefficients of an additive Runge-Kutta method for y' = f + g: stages Y_i = y + h sum_j
/// (E_ij f_j + I_ij g_j) at the times c_i, of which E is strictly lower triangular and I lower
/// triangular with 0 first and then one number on its diagonal; both with the weights b.
struct AdditiveTable {
    int order = 0;
    int embedded_order = 0;
    Vector times = {};
    DenseMatrix explicit_part = {}; ///< E
    DenseMatrix implicit_part = {}; ///< I; empty: f alone
    Vector weights = {};
    Vector error_weights = {}; ///< b less those of the embedded method

    Eigen::Index stages() const { return times.size(); }
};

/// 5(4), seven stages, of which the last one is the first of the next step.
/// Source: Dormand and Prince 1980.
const AdditiveTable& dormand_prince();

/// ARK4(3)6L[2]SA: the implicit part is L-stable, its first stage explicit and its last one the
/// end of the step. Source: Kennedy and Carpenter 2003.
const AdditiveTable& kennedy_carpenter();

} // namespace polydec
