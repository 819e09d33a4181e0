// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <vector>

namespace polydec {

/// Galerkin's star of k-forms of a material: the inner products of Whitney forms, on merged cells
/// by the lift, each n-cell's times its weight. size(k) x size(k), units those of the star. With
/// the conductivity as the weight of 1-forms Laplace's equation of primal 0-forms becomes div kappa
/// grad; with its inverse as that of (n-1)-forms, that of dual 0-forms and Darcy's:
/// mesh.with_stars(mesh.stars().with(k, material_star(mesh, k, weights))).
/// Throws InvalidInput, naming the cell, for a weight that is not positive, and for another number
/// of them.
SparseMatrix material_star(const Discretization& mesh, int k, const Vector& weights);

/// The same of (n-1)-forms by a conductivity that depends on the direction: a symmetric positive
/// definite n x n tensor for each n-cell, whose inverse is the weight.
/// Source: Raviart, Thomas 1977.
/// Throws InvalidInput, naming the cell, for other tensors, and unless the mesh is flat (n x n), in
/// place (not flipped) and of known points.
SparseMatrix material_star(const Discretization& mesh, const std::vector<DenseMatrix>& tensors);

/// The mean of a weight around each k-cell, by the size of the parts of |s||*s| in the n-cells:
/// what the diagonal star of a material is to that of none, one value for each k-cell. Weights are
/// at least 0, such as conductivity over permittivity. Throws InvalidInput, naming the cell, for
/// others and another number of them.
Vector cell_means(const Discretization& mesh, int k, const Vector& weights);

/// The stars of a mesh with that of k-forms weighted by n-cell: times the means where it is
/// diagonal, and is so then; else Galerkin's of the material. Of Maxwell's equations with E a
/// primal 1-form that of degree 1 is weighted by the permittivity, that of degree 2 by the inverse
/// of the permeability. Throws like material_star.
HodgeStars weighted_stars(const Discretization& mesh, int k, const Vector& weights);

/// Throws InvalidInput, naming the n-cell and what is given for it, such as "conductivity", unless
/// all are positive and finite.
void check_cell_weights(const char* what, const Vector& weights, int n);

} // namespace polydec
