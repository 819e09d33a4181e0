// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/cochain.h"

#include <memory>
#include <string>

namespace polydec {

/// A form as the sum of an exact, a coexact and a harmonic one, orthogonal in the inner product of
/// its side.
struct HodgeParts {
    Cochain exact, coexact, harmonic;
    Cochain potential;   ///< of the same side, degree k-1: d potential = exact
    Cochain copotential; ///< of the other side, degree n-k-1: d copotential = star coexact
};

/// Decomposes forms of one side and degree with one factorization for each part. The normal
/// equations of d, whose kernel is large, are solved on a largest regular minor of d (see
/// regular_minor), where they are positive definite; so all that is needed is that the star of
/// these forms is positive, and no Betti number need be known. Those of the coexact part invert the
/// star; where it is a matrix, copotential and part are found together (see SaddleSolver).
///
/// On the whole complex the exact part of a primal form is orthogonal to coclosed forms that do not
/// flow through the boundary, that of a dual form to all coclosed ones. For other conditions hand
/// over the complex and the stars of conditioned_complex.
class HodgeSolver {
public:
    /// Throws InvalidInput if there is no such degree or, naming the cells, if the star of these
    /// forms is not positive; what the engine throws where it fails.
    HodgeSolver(const Cells& cells, Side side, int degree, const std::string& engine = "auto");
    HodgeSolver(HodgeSolver&&) noexcept;
    ~HodgeSolver();

    /// Throws InvalidInput if the form is of another kind or has values that are not finite.
    HodgeParts decompose(const Cochain& form) const;

    /// Harmonic forms, b_k of them on the absolute complex: columns of norm 1, orthogonal to each
    /// other, closed and coclosed. They span what the homology generators, as dual forms, become
    /// without their exact part.
    DenseMatrix harmonic_forms() const;

private:
    struct Parts;

    CellComplex complex_;
    Side side_;
    int degree_, k_;
    std::unique_ptr<Parts> parts_;
};

/// The decomposition by a solver made for it.
HodgeParts hodge_decomposition(const Cells& cells, const Cochain& form,
                               const std::string& engine = "auto");

/// The harmonic forms by a solver made for them.
DenseMatrix harmonic_forms(const Cells& cells, Side side, int degree,
                           const std::string& engine = "auto");

} // namespace polydec
