// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Exterior product of a dual k-form and a dual l-form on simplices, a dual (k+l)-form: the
/// integral over each dual cell *s, s an (n-k-l)-simplex, of the product of two fields that are
/// constant on n-simplices. The field of a form on an n-simplex is the Hodge star, in its plane, of
/// the mean of the Whitney form of star^-1 of the form. The product is integrated over the part of
/// *s in that simplex.
///
/// Anticommutative, a ^ b = (-1)^(kl) b ^ a. Exact for constant forms on flat complexes, also on
/// dual cells that the boundary cuts off; so the constant 1 is the unit for constant forms.
/// Leibniz' rule holds for constants only. The combinatorial product of dual cells, which counts
/// corners (Desbrun, Hirani, Leok, Marsden 2005), is not exact for constants. Time linear in the
/// number of incidences.
///
/// Throws like check; like HodgeStar::inverse, naming the cells, where star_(n-k) or star_(n-l) has
/// a zero; and InvalidInput for primal forms and for k + l > n.
Cochain dual_wedge(const Geometry& geometry, const Cochain& a, const Cochain& b);

/// The product on the duals of merged cells: star^-1 of both forms is lifted to the pieces,
/// multiplied there, and averaged by volume over the pieces of each cell. Anticommutative; exact
/// for constant forms on flat cells. Throws like the overload above.
Cochain dual_wedge(const Discretization& mesh, const Cochain& a, const Cochain& b);

} // namespace polydec
