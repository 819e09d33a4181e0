// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// How a simplex s is shared among its vertices v in a product of forms: equally, or by the part
/// |s n *v| of it that lies in the circumcentric dual of v.
enum class WedgeWeights { uniform, circumcentric };

/// Exterior product of a primal k-form and a primal l-form on simplices, a (k+l)-form: the integral
/// of the product of their Whitney forms. For every (k+l)-simplex s, the sum over its k-faces and
/// l-faces that share one vertex and have all others between them, of sign k! l! / (k+l+1)! times
/// the product of the values. Anticommutative, a ^ b = (-1)^(kl) b ^ a; Leibniz' rule
/// d(a ^ b) = da ^ b + (-1)^k a ^ db holds to rounding; the constant function 1 is the unit;
/// constant forms on flat complexes are multiplied exactly. Not associative for forms that are not
/// closed. Needs no metric. Time of the order of the pairs, (k+l+1)! / (k! l!) per simplex.
/// Source: the antisymmetrized cup product; Wilson 2007.
/// Throws like check, and InvalidInput for dual forms and for k + l > n.
Cochain wedge(const Pieces& complex, const Cochain& a, const Cochain& b);

/// The same with Hirani's weights: sign k! l! / (k+l)! |s n *v| / |s| for a pair of faces with the
/// common vertex v; may be negative where s is obtuse. Anticommutative, with the same unit, exact
/// for constant forms; but Leibniz' rule does not hold. Equal to wedge where all shares of vertices
/// are alike. volumes are those of `complex`.
/// Source: Hirani 2003, Def. 7.1.1.
/// Throws like wedge.
Cochain circumcentric_wedge(const Geometry& geometry, const Cochain& a, const Cochain& b);

/// The products on merged cells: both forms are lifted to the pieces, multiplied there, and added
/// over them. The lift is a cochain map, so wedge has the laws it has on simplices, Leibniz' rule
/// too, and constant forms on flat cells are multiplied exactly; what a cell has depends on its
/// closure alone. Forms that are not closed are multiplied in a way that depends on how the input
/// splits the cell, by about the size of da, db. Throws like their counterparts.
Cochain wedge(const Discretization& mesh, const Cochain& a, const Cochain& b,
              WedgeWeights weights = WedgeWeights::uniform);

/// Product of a primal k-form and a dual (n-k)-form: for each k-cell s the value a(s) b(*s), what
/// the n-form on the diamond of s and *s contributes to the integral of a ^ b. size(k) numbers. For
/// b = star a the sum is the squared norm. For constant forms on flat complexes the sum is the
/// integral, up to a boundary term where the vertices of a boundary facet share it unevenly. Sums
/// by parts exactly: with b a dual (n-k-1)-form, da ^ b + (-1)^k a ^ db adds to zero, as if b
/// vanished on the boundary, which the dual derivative leaves out.
/// Source: Desbrun, Hirani, Leok, Marsden 2005.
/// Throws like check, and InvalidInput unless a is primal, b dual, and the degrees add to n.
Vector primal_dual_wedge(const CellComplex& complex, const Cochain& a, const Cochain& b);

} // namespace polydec
