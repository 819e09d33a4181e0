// SPDX-License-Identifier: MIT
#pragma once

#include "dec/fields/interior_product.h"
#include "dec/forms/cochain.h"

#include <memory>

namespace polydec {

/// Interior product and Lie derivative of primal k-forms without matrices: built once per mesh, for
/// solvers whose field changes at every step. Equal to rounding to interior_product, lie_derivative
/// and inflow, in linear time and a fraction of theirs; fields and forms are as there.
/// A handle: copies cost nothing.
class LieDerivative {
public:
    /// Throws InvalidInput unless k is in 0..n, and if only lengths are known.
    LieDerivative(const Discretization& mesh, int k, Sampling sampling);

    /// i_X a, a (k-1)-form; empty for k = 0. All members throw InvalidInput for forms of another
    /// kind, and like interior_product for a field that does not fit.
    Cochain interior_product(const Points& field, const Cochain& form) const;

    /// L_X a, a k-form.
    Cochain operator()(const Points& field, const Cochain& form) const;

    /// The term that outside values of a k-form add to -L_X a where the field flows in: a k-form.
    /// Upwind transport of a form with outside values g is da/dt = -L_X a + inflow of g.
    Cochain inflow(const Points& field, const Cochain& outside) const;

private:
    struct Parts;

    std::shared_ptr<const Parts> parts_;
};

} // namespace polydec
