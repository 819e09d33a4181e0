// SPDX-License-Identifier: MIT
#pragma once

#include "shape/count_below.h"
#include "shape/shape.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

struct ShapeSpectrumOptions {
    /// Of forms: 0, functions; n, densities, which are twisted functions under exchanged
    /// conditions (see top_forms); on a surface without weights 1, whose positive eigenvalues are
    /// those of 0-forms and 2-forms together (Hodge).
    int degree = 0;
    Index count = 10;
    int level = 2;    ///< 1 or 2, see CountOptions
    double width = 0; ///< (upper - lower) / upper above which results warn; 0: never
    /// Triangles of surfaces at level 2 may be bisected up to so many, where enclosures are wider
    /// than `width`; 0: none are.
    Index max_triangles = 0;
    std::string linear_solver = "auto";
    std::string eigen_solver = "auto";
    std::function<void(std::string_view)> progress = {}; ///< told what is being done, at each step
};

/// The smallest eigenvalues of a shape: the j-th lies between lower[j] and upper[j].
struct ShapeSpectrum {
    Vector lower; ///< ascending; units 1 / length^2 times kappa / rho
    Vector upper;
    /// How many are known to be 0, which is exact.
    Index zeros = 0;
    /// A number above upper, if there is a gap, and the eigenvalues below it.
    double count_at = 0;
    CountBelow count;
    /// Columns: approximate eigenfunctions, of norm 1 by b, at the vertices of the pieces, and for
    /// level 2 at the midpoints of the edges, between which they are quadratic. Twisted ones are
    /// given as one simplex at the point sees them. None for 1-forms; at vertices alone where
    /// triangles were bisected.
    DenseMatrix modes;
    DenseMatrix edge_modes;
    Index factorizations = 0; ///< for counts
    Index simplices = 0;      ///< that the enclosures were found on
    std::vector<std::string> warnings = {};
};

/// Encloses the `count` smallest eigenvalues of a shape. Upper bounds are those of Rayleigh and
/// Ritz with conforming functions, exactly integrated, with the radii of CertifiedEigensolver.
/// Every lower bound is proved by a count of its own (see count_below), however it was found; where
/// none succeeds it is that of the eigenvalue before, with a warning. Lengths may be off by the
/// length_error of the shape. Proofs: docs/what-is-proved.md. Throws InvalidInput for a count
/// below 1 or above the number of functions there are, another level or degree, a negative width,
/// bisection at level 1 or in another dimension, and shapes that check refuses; SolverFailure if
/// the upper bounds cannot be had.
ShapeSpectrum shape_spectrum(const Shape& shape, const ShapeSpectrumOptions& options = {});

/// (upper - lower) / upper, 0 for eigenvalues known to be 0.
Vector widths(const ShapeSpectrum& spectrum);

} // namespace polydec
