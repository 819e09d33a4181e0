// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "dec/boundary/form_space.h"

#include <string>

namespace polydec {

/// A form as the sum of an exact, a coexact and a harmonic form, orthogonal in the inner product of
/// its side on space.inside(). This is the one of all cells, unless the star is a matrix and the
/// space fixes values of dual forms: the inverse of a part of a matrix is no part of its inverse.
struct HodgeParts {
    Cochain exact, coexact, harmonic;
    // where the space fixes no values:
    Cochain potential;   ///< on the same side, degree k-1: d potential = exact
    Cochain copotential; ///< on the other side, degree n-k-1: d copotential = star coexact
};

/// Decomposes the forms of a space with one factorization per part. The normal equations of d have
/// a large kernel, so they are solved on a largest regular minor of d (see regular_minor), where
/// they are positive definite. The only requirement is a positive star of these forms; no Betti
/// number is needed. The equations of the coexact part invert the star. If the star is a matrix,
/// copotential and coexact part are found together (see SaddleSolver).
///
/// The parts of a form are forms of the space, and so are potentials of degree k-1. Values that the
/// space fixes are 0 in all of them, whatever they are in the form.
class HodgeSolver {
public:
    /// Throws InvalidInput for a Robin condition and, naming the cells, if the star of these forms
    /// is not positive. Passes on the engine's errors.
    explicit HodgeSolver(const FormSpace& space, const std::string& linear_solver = "auto");

    /// Throws InvalidInput like FormSpace::check.
    HodgeParts decompose(const Cochain& form) const;

    /// Basis of the harmonic forms, one column per Betti number of the cells inside the space.
    /// Columns have norm 1, are orthogonal to each other, closed and coclosed. They span the
    /// harmonic parts of the homology generators, taken as dual forms.
    DenseMatrix harmonic_forms() const;

private:
    struct Parts;

    FormSpace space_;
    Shared<Parts> parts_;
};

/// The Hodge decomposition of one form, with a solver made for it.
HodgeParts hodge_decomposition(const FormSpace& space, const Cochain& form,
                               const std::string& linear_solver = "auto");

/// The harmonic forms, with a solver made for them.
DenseMatrix harmonic_forms(const FormSpace& space, const std::string& linear_solver = "auto");

} // namespace polydec
