// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"

#include <functional>

namespace polydec {

/// Points and weights of a quadrature rule on a k-simplex: the integral of f is approximately the
/// volume times the sum of weights[q] f(point q).
struct SimplexQuadrature {
    DenseMatrix points; ///< one row of k+1 barycentric coordinates per point
    Vector weights;     ///< sum 1; some are negative
};

/// The rule of Grundmann and Moeller on a simplex of any dimension k >= 0, exact for polynomials up
/// to the given degree, rounded up to the next odd degree 2s+1. It has (s+k+1 over k+1) points, all
/// inside the simplex, and one for k = 0. Weights cancel more in higher degrees, which loses
/// digits: three at degree 19. Source: Grundmann, Moeller 1978, Theorem 4. Throws InvalidInput if k
/// or degree is negative, or if weights cancel so much that few digits are right: from degree 42 on
/// for k = 1, 38 for k = 4, 36 for k = 6.
SimplexQuadrature grundmann_moeller(int k, int degree);

/// A k-form on R^N: maps a point to its N over k coefficients at dx_I, for the k-subsets I of
/// 0..N-1 in lexicographic order. For k = 1 these are the components of the vector field whose
/// circulation the form is. All that take or make one throw InvalidInput for an empty function.
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

/// The de Rham map: integrals of a k-form over the oriented k-simplices. Size size(k). Exact for
/// polynomial coefficients up to the quadrature degree (default 5, see grundmann_moeller). Source:
/// Hirani 2003, sec. 3.3.
/// Throws InvalidInput if there is no degree k, if a vertex has no point, and, naming the point, if
/// the form returns a wrong number of coefficients or one that is not finite.
Vector de_rham(const Pieces& complex, const Points& points, int k, const SmoothForm& form,
               int quadrature_degree = 5);

/// The same over the merged cells, a primal k-form: sums over the pieces, by dia_k.
Cochain de_rham(const Discretization& mesh, int k, const SmoothForm& form,
                int quadrature_degree = 5);

/// The de Rham map of dual j-forms, by the stars of the mesh without their materials, on which
/// integrals do not depend (see Cells::geometric_star). Stars over duals (see
/// ChosenStars::is_over_duals): integrals over the circumcentric duals *s of the pieces s of degree
/// k = n-j, averaged by volume over the pieces of a cell; s followed by *s has the orientation of
/// the n-pieces. *s consists of the elementary simplices [c(s_k), .., c(s_n)] over all flags s =
/// s_k < .. < s_n, with the sign prod over i of (-1)^(i+1) [s_(i+1) : s_i], i = k .. n-1. For j =
/// 0, values at the sites of the pieces (see sites_of_pieces). Size size(k). Commutes with
/// dual_derivative off the boundary of orientable meshes. The form is evaluated near circumcenters,
/// which may lie outside the mesh. After flips they lie on the surface, as in cell_centers, and
/// elementary simplices are straight between them: Stokes' theorem still holds.
///
/// Other stars, which know no duals: the star of the integrals of the form's inverse star over the
/// oriented k-simplices, in the planes of the n-simplices around them; if these planes differ, of
/// the mean by volume. Then the form is evaluated inside the simplices only.
/// Source: Hirani 2003, sec. 2.5. Throws like de_rham.
Cochain dual_de_rham(const Discretization& mesh, int j, const SmoothForm& form,
                     int quadrature_degree = 5);

/// Integrals of a smooth j-form over the duals, within the boundary, of the boundary cells of
/// degree n-j-1: the boundary data of dual forms (see dual_boundary_derivative, also for the
/// orientation). One value per (n-j-1)-cell, 0 off the boundary; for j = 0 the values at
/// facet_sites, averaged over the pieces of bent cells. Together with the dual_derivative of a
/// smooth form, Stokes' theorem holds to the accuracy of the quadrature. If the star of cells of
/// degree n-j is a matrix, the values are integrals against the Whitney forms of the boundary
/// cells, as in Galerkin's equations.
/// Throws like de_rham, and for a degree outside 0..n-1.
Vector boundary_de_rham(const Discretization& mesh, int j, const SmoothForm& form,
                        int quadrature_degree = 5);

} // namespace polydec
