// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/cell_data.h"
#include "dec/discretization.h"
#include "dec/forms/boundary_conditions.h"

namespace polydec {

/// Which functions on a shape have the spectrum: ordinary ones, or densities of twisted n-forms,
/// which change their sign where orientations do: on a Klein bottle they have no constant.
enum class ShapeFunctions { ordinary, twisted };

/// Flat n-simplices glued along facets, by the lengths of their edges: a plane domain, a polyhedral
/// surface, a solid. Any number of them may meet at a facet, one may meet itself, and angles around
/// a vertex may have any sum. H^1 consists of the functions that are so in each simplex, with equal
/// traces on glued facets, and 0 on essential ones. The Laplacian belongs to
/// a(u,v) = sum kappa (grad u, grad v) + sum alpha (u,v) over Robin's facets, and
/// b(u,v) = sum rho (u,v): its eigenvalues have bounded functions at cone points (Friedrichs). The
/// eigenvalues are properties of this shape, not of a mesh of it.
struct Shape {
    Pieces pieces;
    Vector lengths; ///< of the edges: size(1)
    /// One everywhere, or one for each facet; Robin's coefficients alpha are kappa over length.
    BoundaryConditions conditions = {BoundaryCondition::natural};
    Vector conductivity = {}; ///< kappa of each n-simplex, positive; empty: 1
    Vector density = {};      ///< rho of each n-simplex, positive; empty: 1
    ShapeFunctions functions = ShapeFunctions::ordinary;
    /// Every length may be off by this share of it, as rounding of points or flips make it.
    double length_error = 0;
    /// And squares of lengths within simplices by this share besides, as bisection and flips of
    /// such make them, whose errors add up.
    double metric_error = 0;
};

/// The shape of a mesh: its simplices, or those that flips have made of them, which are the same
/// surface, never merged cells; lengths are those of the input. Throws InvalidInput like CellData
/// and check.
Shape shape_of(const Discretization& mesh,
               const BoundaryConditions& conditions = {BoundaryCondition::natural},
               const CellData& conductivity = {}, const CellData& density = {});

/// The shape whose functions have the spectrum of n-forms, densities: twisted ones, free where
/// n-forms are essential and 0 where these are natural.
Shape top_forms(const Shape& shape);

/// Throws InvalidInput, saying what it is and naming edge, simplex or facet, unless lengths are
/// positive numbers, one for each edge, weights as many positive ones as there are simplices,
/// Robin's coefficients positive, and at most two simplices at each facet if functions are twisted.
/// Fixed vertices are refused: in dimension 2 and above no function feels a point.
void check(const Shape& shape);

/// The number of eigenvalues 0: components, by facets, without essential or Robin facet, and of
/// twisted functions those that are orientable.
Index zero_eigenvalues(const Shape& shape);

} // namespace polydec
