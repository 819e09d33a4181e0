// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// The Whitney form of a primal k-form on simplices, at one point of n-simplex `top`: the sum over
/// its k-faces I of the value on I times k! sum_p (-1)^p lambda_(I_p) dlambda_(I_0) ^ .. (p
/// omitted) .. ^ dlambda_(I_k). `barycentric`: the n+1 barycentric coordinates of the point,
/// vertices ascending.
///
/// Returns a k-covector of R^N, tangent to the simplex: its coefficients at dx_I for the k-subsets
/// I of 0..N-1 in lexicographic order; units: values times length^-k. Its integral over a k-face is
/// the value there. Exact for constant forms on flat meshes. Only its restrictions to shared faces
/// are continuous from simplex to simplex. Source: Whitney 1957, ch. IV, sec. 27. Throws
/// InvalidInput for dual forms, forms of another complex, a `top` out of range, and coordinates
/// that are not n+1 numbers of sum 1.
Vector whitney_form(const Pieces& complex, const Points& points, const Cochain& form, Index top,
                    const Vector& barycentric);

/// The Whitney form at the centroids of the n-simplices: one row of N over k coefficients per
/// simplex. Throws like whitney_form.
DenseMatrix whitney_at_centroids(const Pieces& complex, const Points& points, const Cochain& form);

/// The same for a form on merged cells, lifted to the simplices of the input: `top` is such a
/// simplex, and each has a row. Exact for constant forms on flat meshes. For many points, call
/// lifted(mesh, form) once. Throw like the overloads above, and like lifted.
Vector whitney_form(const Discretization& mesh, const Cochain& form, Index top,
                    const Vector& barycentric);
DenseMatrix whitney_at_centroids(const Discretization& mesh, const Cochain& form);

} // namespace polydec
