// SPDX-License-Identifier: MIT
#pragma once

#include "dec/fields/interior_product.h"
#include "dec/forms/cochain.h"

#include <memory>

namespace polydec {

/// What vector fields do to primal k-forms, without matrices: made once from a mesh, for solvers
/// whose field is another one at every step. To rounding what interior_product, lie_derivative and
/// inflow make, in linear time and a fraction of theirs; fields and forms are as there.
/// A handle: copies cost nothing.
class LieDerivative {
public:
    /// Throws InvalidInput unless k is one of 0..n, and where only lengths are known.
    LieDerivative(const Discretization& mesh, int k, Sampling sampling);

    /// i_X a, a (k-1)-form; empty for k = 0. They all throw InvalidInput for forms of another kind,
    /// and like interior_product for a field that does not fit.
    Cochain interior_product(const Points& field, const Cochain& form) const;

    /// L_X a, a k-form.
    Cochain operator()(const Points& field, const Cochain& form) const;

    /// What values of a k-form outside add to -L_X a where the field flows in: a k-form. Upwind
    /// transport of a form that is g outside is da/dt = -L_X a + inflow of g.
    Cochain inflow(const Points& field, const Cochain& outside) const;

private:
    struct Parts;

    std::shared_ptr<const Parts> parts_;
};

} // namespace polydec
