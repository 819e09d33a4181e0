// SPDX-License-Identifier: MIT
#pragma once

#include "shape/count_below.h"
#include "shape/forms.h"

#include <string>

namespace polydec {

/// The safe direction to move s if a count cannot be trusted; counts are monotone in s.
enum class Direction { down, up };

/// Negative eigenvalues of Q(s) or, if the count is not trusted, of Q at an s moved by at most 1e-6
/// of s. Throws SolverFailure if no count can be trusted.
Index trusted_count(const FormFamily& family, double s, Direction direction,
                    const std::string& engine, int domain_dimension);

/// The eigenvalues below s of a shape with these forms; `ratio` as in metric_ratio.
CountBelow enclosed_count(const Shape& shape, const FormFamily& conforming, const FormFamily& lower,
                          double s, double ratio, const std::string& engine);

/// Throws InvalidInput unless the level is 1 or 2.
void check_level(int level);

/// A warning that these simplices limit bounds to below `limit`, where s was requested.
std::string warning_of_large(const Shape& shape, const std::vector<Index>& simplices, double s,
                             double limit);

} // namespace polydec
