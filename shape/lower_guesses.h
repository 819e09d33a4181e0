// SPDX-License-Identifier: MIT
#pragma once

#include "shape/form_family.h"

namespace polydec {

struct LowerGuesses {
    Vector values;
    DenseMatrix vectors;
};

/// Numbers s at which eigenvalues of Q(s) vanish, one per column of X, with their vectors; the j-th
/// one belongs to the j-th smallest eigenvalue. They are nearly the best lower bounds that counts
/// can prove. X has the unknowns of approximate eigenfunctions, `values` their approximate
/// eigenvalues. Uses the Rayleigh-Ritz method for s-dependent matrices and a step of residual
/// inverse iteration (Neumaier 1985). The results are guesses and prove nothing.
LowerGuesses lower_guesses(const FormFamily& family, DenseMatrix X, const Vector& values,
                           const std::string& engine, int domain_dimension);

} // namespace polydec
