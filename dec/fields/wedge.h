// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Share of a vertex v in a simplex s in a product of forms: equal for all vertices, or the part |s
/// n *v| of s that lies in the circumcentric dual of v: Hirani's weights, sign k! l! / (k+l)! |s n
/// *v| / |s| for a pair of faces with common vertex v. A weight may be negative where s is obtuse.
/// Products with these are anticommutative, with the same unit, and exact for constant forms; but
/// Leibniz' rule does not hold. Equal to uniform ones where all vertices have equal shares.
/// Source: Hirani 2003, Def. 7.1.1.
enum class WedgeWeights { uniform, circumcentric };

/// Exterior product of a primal k-form and a primal l-form on simplices, a (k+l)-form: the integral
/// of the product of their Whitney forms. On a (k+l)-simplex, it sums over the pairs of a k-face
/// and an l-face that share one vertex and together contain all others: sign k! l! / (k+l+1)! times
/// the product of the values. Anticommutative, a ^ b = (-1)^(kl) b ^ a. Leibniz' rule d(a ^ b) = da
/// ^ b + (-1)^k a ^ db holds to rounding. The constant function 1 is the unit. Exact for constant
/// forms on flat complexes. Not associative for forms that are not closed. Needs no metric. Time of
/// the order of the pairs, (k+l+1)! / (k! l!) per simplex.
/// Source: the antisymmetrized cup product; Wilson 2007.
/// Throws like check, and InvalidInput for dual forms and for k + l > n.
Cochain wedge(const Pieces& complex, const Cochain& a, const Cochain& b);

/// The product on merged cells: both forms are lifted to the pieces, multiplied there, and summed
/// over the pieces. The lift is a cochain map, so uniform weights keep their laws, including
/// Leibniz' rule, and are exact for constant forms on flat cells. The value on a cell depends on
/// its closure only. For forms that are not closed, the product depends on how the input splits the
/// cell, by about the size of da, db. Throws like the product on simplices.
Cochain wedge(const Discretization& mesh, const Cochain& a, const Cochain& b,
              WedgeWeights weights = WedgeWeights::uniform);

/// Product of a primal k-form and a dual (n-k)-form: for each k-cell s the value a(s) b(*s), the
/// contribution of the diamond of s and *s to the integral of a ^ b. size(k) numbers. For b = star
/// a the sum is the squared norm. For constant forms on flat complexes the sum is the integral, up
/// to a boundary term if the vertices of a boundary facet share it unevenly. Summation by parts is
/// exact: with b a dual (n-k-1)-form, da ^ b + (-1)^k a ^ db sums to zero, as if b vanished on the
/// boundary, which the dual derivative leaves out.
/// Source: Desbrun, Hirani, Leok, Marsden 2005.
/// Throws like check, and InvalidInput unless a is primal, b dual, and the degrees add up to n.
Vector primal_dual_wedge(const CellComplex& complex, const Cochain& a, const Cochain& b);

/// Exterior product of a dual k-form and a dual l-form, a dual (k+l)-form. Stars are those without
/// materials (see Cells::geometric_star): star^-1 of both forms is lifted to the pieces, multiplied
/// there, and averaged by volume over the pieces of each cell. The product on pieces is the
/// integral over each dual cell *s, s an (n-k-l)-simplex, of the product of two fields that are
/// constant on n-simplices. The field of a form on an n-simplex is the Hodge star, in its plane, of
/// the mean of the Whitney form of star^-1 of the form. The product is integrated over the part of
/// *s in that simplex. Where dual forms are stars of primal ones (see ChosenStars::is_over_duals),
/// the product is the star of star^-1 of it, averaged by volume over the n-simplices.
///
/// Anticommutative, a ^ b = (-1)^(kl) b ^ a. Exact for constant forms on flat complexes, also on
/// dual cells that the boundary cuts off; so the constant 1 is the unit for constant forms.
/// Duals between centers other than circumcenters are not orthogonal to their cells, and star^-1
/// of constant forms of degree 0 < k < n is then not exact, nor are their products. Leibniz' rule
/// holds for constants only. The combinatorial product of dual cells, which counts corners
/// (Desbrun, Hirani, Leok, Marsden 2005), is not exact for constants. Time linear in the number of
/// incidences.
///
/// Throws like check; like HodgeStar::inverse, naming the cells, where star_(n-k) or star_(n-l) has
/// a zero; and InvalidInput for primal forms and for k + l > n.
Cochain dual_wedge(const Discretization& mesh, const Cochain& a, const Cochain& b);

} // namespace polydec
