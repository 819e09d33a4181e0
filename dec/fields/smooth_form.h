// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <functional>

namespace polydec {

/// A k-form on R^N: maps a point to its N over k coefficients at dx_I, for the k-subsets I of
/// 0..N-1 in lexicographic order. For k = 1 these are the components of the vector field whose
/// circulation the form is.
using SmoothForm = std::function<Vector(const Vector& point)>;

/// A function as a 0-form; on R^N also the density f dx_1 ^ .. ^ dx_N, which has one coefficient as
/// well.
SmoothForm function_form(std::function<double(const Vector& point)> function);

/// The 1-form whose integrals along curves are the circulation of a vector field of N components.
SmoothForm circulation_form(std::function<Vector(const Vector& point)> field);

/// The (N-1)-form i_X vol. Its integral over an oriented hypersurface is the flux of the field X:
/// the outward flux on boundary facets that are oriented as the boundary of cells of positive
/// determinant. Its derivative is div X vol.
SmoothForm flux_form(std::function<Vector(const Vector& point)> field);

/// Value of a form, or of another callable called `what`, at a point. Throws InvalidInput, naming
/// the point, unless the value has `size` finite numbers.
Vector checked_value(const SmoothForm& form, const Vector& point, Index size, const char* what);

} // namespace polydec
