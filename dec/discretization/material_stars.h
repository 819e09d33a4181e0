// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/cell_data.h"
#include "dec/forms/cochain.h"

#include <vector>

namespace polydec {

/// Galerkin's star of k-forms in a material: inner products of Whitney forms, on merged cells by
/// the lift, with each n-cell's contribution times its weight. size(k) x size(k), units of the
/// star. Weights are in the order of the input's cells (see CellData), also below. With
/// conductivity as the weight of 1-forms, Laplace's equation of primal 0-forms becomes div kappa
/// grad. With its inverse as the weight of (n-1)-forms, Laplace's equation of dual 0-forms and
/// Darcy's do: mesh.with_stars(mesh.stars().with(k, material_star(mesh, k, weights))).
/// Throws InvalidInput, naming the cell, for a weight that is not positive, and like CellData.
SparseMatrix material_star(const Discretization& mesh, int k, const CellData& weights);

/// The same for (n-1)-forms with an anisotropic conductivity: a symmetric positive definite n x n
/// tensor per cell of the input, in the input's order, whose inverse is the weight.
/// Source: Raviart, Thomas 1977.
/// Throws InvalidInput, naming the cell, for other tensors and for different tensors in one n-cell,
/// and unless the mesh is flat (n x n), not flipped and has known points.
SparseMatrix material_star(const Discretization& mesh, const std::vector<DenseMatrix>& tensors);

/// Mean of a weight around each k-cell, by the signed parts of |s||*s| in the n-cells: the ratio of
/// the diagonal star with and without the material, one value per k-cell. If the star is a matrix,
/// parts are taken between centroids; around cells without dual, all n-cells count equally. Weights
/// are at least 0, e.g. conductivity over permittivity. Duals with negative parts may give a mean
/// outside the range of the weights. Throws InvalidInput, naming the cell, for negative weights,
/// and like CellData.
Vector cell_means(const Discretization& mesh, int k, const CellData& weights);

/// The stars of a mesh with the star of k-forms weighted by n-cell. A diagonal star becomes the sum
/// of the signed shares of the n-cells, each times its weight; a matrix becomes Galerkin's star of
/// the material. The weights replace the former ones of this degree, also below; other degrees keep
/// theirs. So on a Delaunay mesh of triangles, primal 0-forms have the equations of linear
/// elements. In Maxwell's equations with E a primal 1-form, the permittivity weights star_1, the
/// inverse permeability star_2. User-supplied diagonal stars, whose shares and former weights are
/// unknown, are multiplied by cell_means. Throws like material_star, and for user-supplied stars
/// that are matrices.
HodgeStars weighted_stars(const Discretization& mesh, int k, const CellData& weights);

/// The mesh with these stars; the kind of stars is unchanged, but a star that is a matrix makes all
/// cells Galerkin's (see ChosenStars). Forms of smooth fields, products and proxy vectors do not
/// depend on weights (see Cells::geometric_star). with_stars(kind) removes all weights.
Discretization with_material(const Discretization& mesh, int k, const CellData& weights);

/// The mesh with stars for which Delta of functions is -div kappa grad, kappa > 0. For primal
/// functions kappa weights the star of 1-forms; for dual functions 1 / kappa weights the star of
/// (n-1)-forms. Throws like weighted_stars.
Discretization with_conductivity(const Discretization& mesh, Side side, const CellData& kappa);

/// The mesh with stars for which forms of a side and degree are electric fields E, with energies
/// permittivity |E|^2 and |B|^2 / permeability, both positive. Dual forms are stars of primal forms
/// through the material, so their stars have the inverse weights. Without permeability, or with
/// empty data, a star stays as it is. Throws like weighted_stars.
Discretization with_electric_material(const Discretization& mesh, Side side, int degree,
                                      const CellData& permittivity,
                                      const CellData& permeability = {});

} // namespace polydec
