// SPDX-License-Identifier: MIT
#pragma once

#include "dec/cell_data.h"
#include "dec/forms/side.h"

#include <vector>

namespace polydec {

/// Galerkin's star of k-forms of a material: the inner products of Whitney forms, on merged cells
/// by the lift, each n-cell's times its weight. size(k) x size(k), units those of the star. Weights
/// are in the order of the input's cells (see CellData), here as everywhere. With
/// the conductivity as the weight of 1-forms Laplace's equation of primal 0-forms becomes div kappa
/// grad; with its inverse as that of (n-1)-forms, that of dual 0-forms and Darcy's:
/// mesh.with_stars(mesh.stars().with(k, material_star(mesh, k, weights))).
/// Throws InvalidInput, naming the cell, for a weight that is not positive, and like CellData.
SparseMatrix material_star(const Discretization& mesh, int k, const CellData& weights);

/// The same of (n-1)-forms by a conductivity that depends on the direction: a symmetric positive
/// definite n x n tensor for each cell of the input, in its order, whose inverse is the weight.
/// Source: Raviart, Thomas 1977.
/// Throws InvalidInput, naming the cell, for other tensors, for different ones in one n-cell, and
/// unless the mesh is flat (n x n), in place (not flipped) and of known points.
SparseMatrix material_star(const Discretization& mesh, const std::vector<DenseMatrix>& tensors);

/// The mean of a weight around each k-cell, by the signed parts of |s||*s| in the n-cells: what the
/// diagonal star of a material is to that of none, one value for each k-cell. Where the star is a
/// matrix the parts are those between centroids; around cells without dual all n-cells count alike.
/// Weights are at least 0, such as conductivity over permittivity; where duals have negative parts
/// a mean may lie outside of what it is the mean of. Throws InvalidInput, naming the cell, for
/// others, and like CellData.
Vector cell_means(const Discretization& mesh, int k, const CellData& weights);

/// The stars of a mesh with that of k-forms weighted by n-cell: the sum of the signed shares of the
/// n-cells, each times its weight, where it is diagonal, and is so then; else Galerkin's of the
/// material. So on a Delaunay mesh of triangles primal 0-forms have the equations of linear finite
/// elements. Of Maxwell's equations with E a primal 1-form that of degree 1 is weighted by the
/// permittivity, that of degree 2 by the inverse of the permeability. Diagonal stars of one's own,
/// of which shares are not known, are multiplied by the means. Throws like material_star.
HodgeStars weighted_stars(const Discretization& mesh, int k, const CellData& weights);

/// The mesh with these stars, which are of the same kind.
Discretization with_material(const Discretization& mesh, int k, const CellData& weights);

/// With these stars Delta of functions is -div kappa grad, for kappa > 0: the star of 1-forms
/// weighted by kappa for primal functions, that of (n-1)-forms by 1 / kappa for dual ones. Throws
/// likewise, and beside stars of one's own that are matrices, of which the cells' parts are not
/// known.
Discretization with_conductivity(const Discretization& mesh, Side side, const CellData& kappa);

/// With these stars forms of a side and degree are electric fields E in a material, whose energies
/// are of permittivity |E|^2 and |B|^2 / permeability: dual forms are stars of primal ones by what
/// is between them, and have the inverses. Both positive. Throws likewise.
Discretization with_electric_material(const Discretization& mesh, Side side, int degree,
                                      const CellData& permittivity, const CellData& permeability);

} // namespace polydec
