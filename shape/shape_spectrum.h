// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "shape/shape.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

struct CountOptions {
    int degree = 0; ///< of forms: 0, n, or 1 on a surface; see ShapeSpectrumOptions
    /// 1: linear and Crouzeix-Raviart functions, bounds of order 2; 2: quadratic functions and the
    /// hybrid method of degree 1, of order 4.
    int level = 2;
    std::string linear_solver = "auto"; ///< computes inertia
};

/// Bounds on the number of eigenvalues of a shape below a given number.
struct CountBelow {
    Index at_least = 0;
    std::optional<Index> at_most = {};      ///< none if simplices are too large
    std::vector<Index> too_large = {};      ///< these
    std::vector<std::string> warnings = {}; ///< about these
};

/// The number of eigenvalues of forms on the shape below s, bounded by two counts of inertia: from
/// below by conforming functions, from above by nonconforming functions with enlarged mass. See
/// docs/what-is-proved.md. The proof does not cover rounding in the inertia: InertiaCounter decides
/// where a count can be trusted; elsewhere s moves by at most 1e-6 of s to the safe side. Does not
/// depend on units, numbering and embedding. Throws InvalidInput for another level or degree, an s
/// that is not finite, and like check; SolverFailure if no count can be trusted.
CountBelow count_below(const Shape& shape, double s, const CountOptions& options = {});

struct ShapeSpectrumOptions {
    /// Degree of the forms: 0, functions; n, densities, i.e. twisted functions with exchanged
    /// conditions (see top_forms); 1 on a surface without weights, where 0-forms and 2-forms
    /// together have the same positive eigenvalues (Hodge).
    int degree = 0;
    Index count = 10;
    int level = 2;    ///< 1 or 2, see CountOptions
    double width = 0; ///< a larger (upper - lower) / upper gives a warning; 0: never
    /// Simplices are bisected up to this number while enclosures are wider than `width`; 0: no
    /// bisection.
    Index max_triangles = 0;
    std::string linear_solver = "auto";
    std::string eigen_solver = "auto"; ///< for the linear functions that iterations start with
    Progress progress = {};            ///< called with a description at each step
};

/// The smallest eigenvalues of a shape: the j-th lies between lower[j] and upper[j].
struct ShapeSpectrum {
    Vector lower; ///< ascending; units 1 / length^2 times kappa / rho
    Vector upper;
    /// The number of eigenvalues known to be exactly 0.
    Index zeros = 0;
    /// A number above `upper`, if there is a gap, and the count of eigenvalues below it.
    double count_at = 0;
    CountBelow count;
    /// Columns: approximate eigenfunctions of norm 1 in b, at the vertices of the pieces and, for
    /// level 2, at the midpoints of the edges, quadratic in between. A twisted function takes its
    /// sign from one simplex at the point. Empty for 1-forms; at vertices only if simplices were
    /// bisected.
    DenseMatrix modes;
    DenseMatrix edge_modes;
    Index factorizations = 0; ///< for counts
    Index simplices = 0;      ///< number used for the enclosures
    std::vector<std::string> warnings = {};
};

/// Encloses the `count` smallest eigenvalues of a shape. Upper bounds are Rayleigh-Ritz values of
/// conforming functions, integrated exactly, and allow for rounding. Inertia counts prove the lower
/// bounds (see count_below): one in a gap behind them proves all, or each has its own. If no count
/// succeeds, it takes the bound of the previous eigenvalue, with a warning. The bounds allow for
/// the length_error of the shape. Proofs: docs/what-is-proved.md. Throws InvalidInput for a count
/// below 1 or above the number of functions, another level or degree, a negative width, and like
/// check; SolverFailure if the upper bounds cannot be computed.
ShapeSpectrum shape_spectrum(const Shape& shape, const ShapeSpectrumOptions& options = {});

/// (upper - lower) / upper, 0 for eigenvalues known to be 0.
Vector widths(const ShapeSpectrum& spectrum);

} // namespace polydec
