// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Exterior product of a dual k-form and a dual l-form on simplices, a dual (k+l)-form: the
/// integral over each dual cell of the product of fields that are constant on n-simplices. For
/// every n-simplex the field of a form is the Hodge star, in its plane, of the mean of the Whitney
/// form of star^-1 of the form; the product of both is integrated over the part of *s in that
/// simplex, s being the (n-k-l)-simplices.
///
/// Anticommutative, a ^ b = (-1)^(kl) b ^ a; exact for constant forms on flat complexes, on dual
/// cells cut off by the boundary too, so that the constant 1 is the unit for them. Leibniz' rule
/// holds for constants alone. The combinatorial product of dual cells, which counts corners
/// (Desbrun, Hirani, Leok, Marsden 2005), is not exact for constants. Time linear in the number of
/// incidences. volumes are those of `complex`.
///
/// Throws like check; like HodgeStar::inverse, naming the cells, where star_(n-k) or star_(n-l) has
/// a zero; and InvalidInput for primal forms and for k + l > n.
Cochain dual_wedge(const Geometry& geometry, const Cochain& a, const Cochain& b);

/// The product on the duals of merged cells: star^-1 of both forms is lifted to the pieces, and the
/// product there is averaged by volume over those of a cell. Anticommutative; exact for constant
/// forms where cells are flat. Throws like the above.
Cochain dual_wedge(const Discretization& mesh, const Cochain& a, const Cochain& b);

} // namespace polydec
