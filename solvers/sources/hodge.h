// SPDX-License-Identifier: MIT
#pragma once

#include "dec/form_space.h"

#include <memory>
#include <string>

namespace polydec {

/// A form as the sum of an exact, a coexact and a harmonic one, orthogonal in the inner product of
/// its side.
struct HodgeParts {
    Cochain exact, coexact, harmonic;
    Cochain potential;   ///< of the same side, degree k-1: d potential = exact
    Cochain copotential; ///< of the other side, degree n-k-1: d copotential = star coexact, where
                         ///< the space fixes no values
};

/// Decomposes the forms of a space with one factorization for each part. The normal
/// equations of d, whose kernel is large, are solved on a largest regular minor of d (see
/// regular_minor), where they are positive definite; so all that is needed is that the star of
/// these forms is positive, and no Betti number need be known. Those of the coexact part invert the
/// star; where it is a matrix, copotential and part are found together (see SaddleSolver).
///
/// Parts of a form are forms of the space, and so are potentials of one degree less; values that it
/// fixes are 0, whatever those of the form are.
class HodgeSolver {
public:
    /// Throws InvalidInput for Robin's condition and, naming the cells, if the star of these forms
    /// is not positive; what the engine throws where it fails.
    explicit HodgeSolver(const FormSpace& space, const std::string& linear_solver = "auto");
    HodgeSolver(HodgeSolver&&) noexcept;
    ~HodgeSolver();

    /// Throws InvalidInput like FormSpace::check.
    HodgeParts decompose(const Cochain& form) const;

    /// Harmonic forms, as many as the Betti number of the cells inside the space: columns of norm
    /// 1, orthogonal to each other, closed and coclosed. They span what the homology generators, as
    /// dual forms, become without their exact part.
    DenseMatrix harmonic_forms() const;

private:
    struct Parts;

    FormSpace space_;
    std::unique_ptr<Parts> parts_;
};

/// The decomposition by a solver made for it.
HodgeParts hodge_decomposition(const FormSpace& space, const Cochain& form,
                               const std::string& linear_solver = "auto");

/// The harmonic forms by a solver made for them.
DenseMatrix harmonic_forms(const FormSpace& space, const std::string& linear_solver = "auto");

} // namespace polydec
