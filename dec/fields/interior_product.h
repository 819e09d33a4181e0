// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

/// From which n-simplices around a (k-1)-simplex its contraction takes a form.
enum class Sampling {
    centered, ///< from all, weighted by volume
    upwind,   ///< from the one that the negative vector field points into
};

/// Interior product i_X of primal k-forms with a vector field, to (k-1)-forms: the integral over
/// each (k-1)-simplex s of the contraction of X with the Whitney form. size(k-1) x size(k), k =
/// 0..n+1, with an empty matrix at both ends. field has a row of N numbers for each point, X at the
/// vertices, linear between them. Units those of X over length times those of the form.
///
/// On merged cells forms are lifted, carried back to the simplices of the input if edges were
/// flipped, contracted there, and brought the other way again: dia i_X S. As exact as on simplices
/// where the cells are flat.
///
/// (i_X a)(s) is -k times the mean over n-simplices t around s, weighted as the sampling says, of
/// the sum over the other vertices q of t of (X . grad lambda_q) a(q, s), X the mean over s and
/// a(q, s) the value on s with q put first. On curved complexes X counts by its tangential part in
/// each t.
///
/// Exact for constant forms where X is linear on the n-simplices, with either sampling; of first
/// order for smooth ones, centered of second where simplices lie symmetric around s. Where the
/// field flows in through the boundary no simplex lies upwind, and the nearest to it is taken: for
/// what is carried there see lie_derivative. i_X i_X = 0 and the rule i_X(a ^ b) = i_X a ^ b +
/// (-1)^k a ^ i_X b do not hold exactly except for constants. Time linear in the number of
/// incidences. Source: Bossavit 2003; Mullen et al. 2011 for upwinding. Throws InvalidInput for a
/// field of another shape than points, for a vector that is not finite, naming the vertex, and for
/// a degree outside 0..n+1.
SparseMatrix interior_product(const Discretization& mesh, const Points& field, int k,
                              Sampling sampling);

/// Lie derivative of primal k-forms by Cartan's formula i_X d + d i_X: size(k) x size(k), k = 0..n.
/// Commutes with d, on merged cells too, since both maps do; exact for constant forms where X is
/// linear on the n-simplices. Units those of X over length. Throws like interior_product.
///
/// With upwind sampling it is made for transport, da/dt = -L_X a, which needs to be told what flows
/// in through the boundary. This matrix lets nothing in: the form is 0 outside, and where no
/// simplex lies upwind what lies downwind has no part. With values g of the form outside, transport
/// is da/dt = -L_X a + inflow(..) g, for functions monotone under a CFL condition: after a step of
/// size up to 1 over the largest diagonal entry they lie between the least and the largest of their
/// values before and of g. On boundary simplices with inflow, and those that they are faces of, it
/// is exact for neither constant nor linear forms; L_X - inflow(..) commutes with d.
SparseMatrix lie_derivative(const Discretization& mesh, const Points& field, int k,
                            Sampling sampling);

/// The rate at which values of a k-form outside come in, for lie_derivative with upwind sampling:
/// size(k) x size(k), k = 0..n, a value outside for every boundary k-simplex, of which those
/// without inflow do not matter. Diagonal and >= 0; 0 for k = n, since n-forms come in through
/// facets alone: of any degree, what i_X a is to be on the (k-1)-simplices with inflow is added as
/// d_(k-1) of it. Outside, every simplex at the boundary is taken to be the mirror image of that
/// inside. Throws like interior_product.
SparseMatrix inflow(const Discretization& mesh, const Points& field, int k);

} // namespace polydec
