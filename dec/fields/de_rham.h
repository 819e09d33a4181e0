// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/fields/smooth_form.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// The de Rham map: integrals of a k-form over the k-simplices as they are oriented. Size size(k);
/// exact for coefficients that are polynomials up to the quadrature degree (5 by default, see
/// grundmann_moeller). Source: Hirani 2003, sec. 3.3.
/// Throws InvalidInput if there is no degree k, a vertex has no point, and, naming the point, if
/// the form returns a wrong number of coefficients or one that is not finite.
Vector de_rham(const Pieces& complex, const Points& points, int k, const SmoothForm& form,
               int quadrature_degree = 5);

/// The same over the merged cells, a primal k-form: the sums over their pieces, dia_k.
Cochain de_rham(const Discretization& mesh, int k, const SmoothForm& form,
                int quadrature_degree = 5);

/// The de Rham map of dual j-forms: integrals over the circumcentric duals *s of the simplices s of
/// degree k = n-j, so that s and *s together have the orientation of the n-simplices. *s consists
/// of the elementary simplices [c(s_k), .., c(s_n)] over all flags s = s_k < .. < s_n, with the
/// sign prod over i of (-1)^(i+1) [s_(i+1) : s_i], i = k .. n-1. Size size(k). Commutes with
/// dual_derivative off the boundary of orientable meshes. The form is asked for values near
/// circumcenters, which may lie outside of the mesh.
/// Source: Hirani 2003, sec. 2.5. Throws like de_rham.
Vector dual_de_rham(const Pieces& complex, const Points& points, int j, const SmoothForm& form,
                    int quadrature_degree = 5, const Centers& centers = {});

/// The primal (n-j)-form that has this j-form as its star: the integrals of the inverse star over
/// the k-simplices, k = n-j, as they are oriented, in the planes of the n-simplices around; where
/// these have different ones the mean by volume. Size size(k). The form is asked for values in the
/// simplices alone. Throws like de_rham.
Vector inverse_star_de_rham(const Pieces& complex, const Points& points, int j,
                            const SmoothForm& form, int quadrature_degree = 5);

/// The dual j-form on merged cells, by the stars of the mesh: over the circumcentric duals, the
/// mean by volume over the pieces, where the stars are these (see ChosenStars::is_over_duals); else
/// the star of inverse_star_de_rham, since a star that is a matrix knows no duals. After flips the
/// centers are those of cell_centers, on the surface, and elementary simplices are straight between
/// them: Stokes' theorem holds as before.
Cochain dual_de_rham(const Discretization& mesh, int j, const SmoothForm& form,
                     int quadrature_degree = 5);

/// Integrals of a smooth j-form over the duals within the boundary of the cells on it, of degree
/// n-j-1: what boundary data of dual forms are made of (see dual_boundary_derivative, also for
/// their orientation). One value for each (n-j-1)-cell, 0 off the boundary; for j = 0 the values at
/// facet_sites, where they are on bent cells the mean over pieces. With the dual_derivative of a
/// smooth form it is exact: Stokes' theorem holds to the accuracy of the quadrature. Where the star
/// of cells of degree n-j is a matrix they are integrals against the Whitney forms of the cells on
/// the boundary, as Galerkin's equations have them.
/// Throws like de_rham, and for another degree than 0..n-1.
Vector boundary_de_rham(const Discretization& mesh, int j, const SmoothForm& form,
                        int quadrature_degree = 5);

} // namespace polydec
