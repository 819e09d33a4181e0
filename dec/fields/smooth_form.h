// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <functional>

namespace polydec {

/// A k-form on R^N: at a point, its coefficients at dx_I for the k-subsets I of 0..N-1 in
/// lexicographic order, N over k of them. For k = 1 these are the components of the vector field
/// whose circulation it is.
using SmoothForm = std::function<Vector(const Vector& point)>;

/// A function as a 0-form; on R^N also the density f dx_1 ^ .. ^ dx_N, which has one coefficient
/// too.
SmoothForm function_form(std::function<double(const Vector& point)> function);

/// The 1-form whose integrals along curves are the circulation of a vector field of N components.
SmoothForm circulation_form(std::function<Vector(const Vector& point)> field);

/// The (N-1)-form i_X vol: its integral over an oriented hypersurface is the flux of the field X,
/// which counts outward on the facets of the boundary of cells of positive determinant, oriented as
/// that boundary. d of it is div X vol.
SmoothForm flux_form(std::function<Vector(const Vector& point)> field);

/// What a form, or another callable of this name, gives at a point. Throws InvalidInput, naming the
/// point, unless that is so many finite numbers.
Vector checked_value(const SmoothForm& form, const Vector& point, Index size, const char* what);

} // namespace polydec
