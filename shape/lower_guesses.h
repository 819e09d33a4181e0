// SPDX-License-Identifier: MIT
#pragma once

#include "shape/form_family.h"

namespace polydec {

struct LowerGuesses {
    Vector values;
    DenseMatrix vectors;
};

/// Numbers s, one for each column of X, with the vectors, at which eigenvalues of Q(s) come to 0,
/// the j-th one for the j-th smallest: nearly the best lower bounds that counts can prove. X has
/// unknowns of nearly such functions, values are about theirs. By the method of Rayleigh and Ritz
/// for s-dependent matrices and a step of residual inverse iteration (Neumaier 1985); what comes
/// out is a guess, and proves nothing.
LowerGuesses lower_guesses(const FormFamily& family, DenseMatrix X, const Vector& values,
                           const std::string& engine, int domain_dimension);

} // namespace polydec
