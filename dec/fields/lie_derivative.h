// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// The n-simplices around a (k-1)-simplex whose values a contraction uses.
enum class Sampling {
    centered, ///< all of them, weighted by volume
    upwind,   ///< the one that the negative vector field points into, or the nearest to it
};

/// Interior product i_X of primal k-forms with a vector field, to (k-1)-forms: the integral over
/// each (k-1)-simplex s of the contraction of X with the Whitney form. size(k-1) x size(k), k =
/// 0..n+1; the matrix is empty at both ends. `field` has one row of N numbers per point: X at the
/// vertices, linear between them. Units: X over length, times the form.
///
/// On merged cells a form is lifted, carried back to the simplices of the input if edges were
/// flipped, contracted there, and mapped back: dia i_X S. On flat cells this is as exact as on
/// simplices.
///
/// (i_X a)(s) is -k times a mean over the n-simplices t around s, weighted by the sampling.
/// Averaged is the sum over the other vertices q of t of (X . grad lambda_q) a(q, s), with X the
/// mean over s, and a(q, s) the value on s with q put first. On curved complexes only the part of X
/// tangential to t counts.
///
/// With either sampling, exact for constant forms if X is linear on the n-simplices. For smooth
/// forms of first order; centered sampling is of second order where the simplices around s are
/// symmetric. Where the field flows in through the boundary no simplex lies upwind; the nearest one
/// is used (for transport see lie_derivative): the one whose cone, seen from s, has the least
/// distance from -X. If several have it, up to 1e-12 of the length of X, their mean by volume is,
/// so results do not depend on numbers, axes or the unit of length. i_X i_X = 0 and i_X(a ^ b) =
/// i_X a ^ b + (-1)^k a ^ i_X b hold exactly for constants only. Time linear in the number of
/// incidences. Source: Bossavit 2003; for upwinding Mullen et al. 2011. Throws InvalidInput for a
/// field of another shape than the points, for a vector that is not finite, naming the vertex, for
/// a degree outside 0..n+1, and if seams of a glued mesh turn.
SparseMatrix interior_product(const Discretization& mesh, const Points& field, int k,
                              Sampling sampling);

/// Lie derivative of primal k-forms by Cartan's formula i_X d + d i_X: size(k) x size(k), k = 0..n.
/// Commutes with d if sampling is centered, also on merged cells, because the lift and dia do.
/// Exact for constant forms if X is linear on the n-simplices. Units: X over length. Throws like
/// interior_product, and for upwind sampling of functions with vertices that
/// Delaunay::flips_and_splits has added, where transport would not be monotone.
///
/// Upwind sampling is meant for transport, da/dt = -L_X a, which needs values of the form that flow
/// in. This matrix assumes that the form is 0 outside: where no simplex lies upwind, the simplex
/// downwind contributes nothing. With values g of the form outside, transport is da/dt = -L_X a +
/// inflow(..) g. For functions it is monotone under a CFL condition: after a step of size at most 1
/// over the largest diagonal entry, values lie between the minimum and the maximum of the old
/// values and g. On boundary simplices with inflow, and on cofaces of these, it is exact for
/// neither constant nor linear forms. L_X - inflow(..) commutes with d.
SparseMatrix lie_derivative(const Discretization& mesh, const Points& field, int k,
                            Sampling sampling);

/// The inflow rate of a k-form given outside, for lie_derivative with upwind sampling: size(k) x
/// size(k), k = 0..n, applied to one outside value per boundary k-simplex; values without inflow do
/// not matter. Diagonal and >= 0, except for k = 1 after flips, which forms are carried across. It
/// is 0 for k = n, since n-forms enter through facets only. In any degree, prescribed values of i_X
/// a on the (k-1)-simplices with inflow are added as d_(k-1) of them. Outside, each boundary
/// simplex is assumed to be mirrored. Throws like interior_product.
SparseMatrix inflow(const Discretization& mesh, const Points& field, int k);

/// Interior product and Lie derivative of primal k-forms without matrices: built once per mesh, for
/// solvers whose field changes at every step. Equal to rounding to interior_product, lie_derivative
/// and, with upwind sampling, inflow, in linear time and a fraction of theirs; fields and forms are
/// as there. With centered sampling, which takes no values from outside, the inflow is 0.
/// A handle: copies cost nothing.
class LieDerivative {
public:
    /// Throws InvalidInput unless k is in 0..n, if only lengths are known or seams turn, and for
    /// upwind sampling of functions with vertices that splits have added.
    LieDerivative(const Discretization& mesh, int k, Sampling sampling);

    /// i_X a, a (k-1)-form; empty for k = 0. All members throw InvalidInput for forms of another
    /// kind, and like interior_product for a field that does not fit.
    Cochain interior_product(const Points& field, const Cochain& form) const;

    /// L_X a, a k-form.
    Cochain operator()(const Points& field, const Cochain& form) const;

    /// The term that outside values of a k-form add to -L_X a where the field flows in: a k-form.
    /// Upwind transport of a form with outside values g is da/dt = -L_X a + inflow of g.
    Cochain inflow(const Points& field, const Cochain& outside) const;

private:
    struct Parts;

    Shared<const Parts> parts_;
};

} // namespace polydec
