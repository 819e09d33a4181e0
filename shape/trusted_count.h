// SPDX-License-Identifier: MIT
#pragma once

#include "shape/count_below.h"
#include "shape/forms.h"

#include <string>

namespace polydec {

/// Where a count goes that cannot be trusted: what counts is monotone in s.
enum class Direction { down, up };

/// Negative eigenvalues of Q(s), or, where these cannot be told, of one by 1e-6 of s lower or
/// higher at most. Throws SolverFailure if none of them can.
Index trusted_count(const FormFamily& family, double s, Direction direction,
                    const std::string& engine, int domain_dimension);

/// The eigenvalues below s of a shape with these forms, `ratio` as of metric_ratio.
CountBelow enclosed_count(const Shape& shape, const FormFamily& conforming, const FormFamily& lower,
                          double s, double ratio, const std::string& engine);

/// The levels that there are: 1 and 2. Throws InvalidInput for others.
void check_level(int level);

/// That these simplices allow bounds below `limit` alone, where s is wanted.
std::string warning_of_large(const Shape& shape, const std::vector<Index>& simplices, double s,
                             double limit);

} // namespace polydec
