// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "shape/forms.h"
#include "shape/gluing.h"
#include "shape/poisson_error.h"

#include <functional>
#include <memory>

namespace polydec {

/// Data on the simplices, in their order: means of f, minus the means over components where
/// constants are free, and bounds on the error that the rest of f adds.
struct LocalData {
    Vector means;
    DenseMatrix corners;    ///< f at the corners, minus the same means
    Vector oscillation;     ///< C_P |f - mean| / kappa^(1/2)
    DenseMatrix facet_flow; ///< inflow through the facet opposite each corner
};

/// A function that is linear on simplices, and one with continuous means over facets, which with f
/// determines an equilibrated flux.
struct PoissonPair {
    DenseMatrix corners; ///< values of the first: simplices x (n+1)
    LongMatrix change; ///< means of the second less the first, over the facet opposite each corner
    Vector source;     ///< means of f
    double rounding;   ///< bound on the rounding error of the second, in the energy norm
};

/// The equations of both, on one shape.
class PoissonForms {
public:
    PoissonForms(const Shape& shape, const std::string& engine);

    const Shape& shape() const { return shape_; }
    int dimension() const { return n_; }
    Index simplices() const { return static_cast<Index>(volumes_.size()); }
    const Vector& volumes() const { return volumes_; }
    const Vector& bubbles() const { return bubbles_; }      ///< c / kappa
    double poincare(Index s) const { return poincare_[s]; } ///< C_P^2 / kappa
    /// For each simplex the mean over its component of a function with these integrals over
    /// simplices, where constants are free; else 0.
    Vector free_means(const Vector& integrals) const;

    /// Values at vertices as a table with one row per simplex.
    DenseMatrix at_corners(const Vector& values) const;
    LocalData local(const DenseMatrix& source, const Vector& flow) const;

    /// A solution found in two steps, simplex by simplex. The second finds what rounding has left
    /// of the first.
    struct Solution {
        LongMatrix values;
        DenseMatrix last_step;
        double size_of_last_step; ///< in the energy norm
    };
    /// The correction from a continuous function to the Galerkin solution.
    Solution to_galerkin(const DenseMatrix& corners, const LocalData& data) const;
    /// The pair of a continuous function.
    PoissonPair pair(const DenseMatrix& corners, const LocalData& data) const;

    /// Inner products of the differences of both gradients of two pairs, with Robin terms, per
    /// simplex.
    Vector products(const PoissonPair& a, const PoissonPair& b) const;

    /// (kappa grad u, grad v); a(u, v), with Robin terms; and (f, v) with the inflow.
    double of_gradients(const DenseMatrix& u, const DenseMatrix& v) const;
    double energy(const DenseMatrix& u, const DenseMatrix& v) const;
    double load(const LocalData& data, const DenseMatrix& v) const;
    /// The integral of u v over a simplex.
    double mass(Index s, const DenseMatrix& u, const DenseMatrix& v) const;

    /// One of the two systems, on facets or on vertices.
    struct System {
        SparseMatrix K;
        std::vector<Index> unknowns; ///< simplex by simplex
        DenseMatrix kernel;          ///< constants of free components
        Vector constant; ///< 1 elsewhere: nearly in the kernel, if Robin's terms are small
        std::unique_ptr<LinearSolver> solver;
        double doubt; ///< of entries of K, as in CountedMatrix
        /// The solution orthogonal to the kernel.
        Vector solve(Vector b) const;
    };
    const System& facets() const { return facets_; }
    const System& vertices() const { return vertices_; }

private:
    System system(const FormFamily& family, const std::string& engine) const;
    Vector gathered(const System& system, const LongMatrix& local) const;
    DenseMatrix spread(const System& system, const Vector& values) const;
    /// `residual`: of a solution, simplex by simplex, in long numbers.
    Solution solution(const System& system,
                      const std::function<LongMatrix(const LongMatrix&)>& residual) const;
    double over_facet(const DenseMatrix& u, const DenseMatrix& v, Index s, int omitted) const;

    Shape shape_;
    int n_;
    std::vector<FacetSide> sides_;
    std::vector<Index> components_;
    Vector volumes_, bubbles_, poincare_;
    std::vector<LongMatrix> gradients_; // kappa |T| times products of gradients
    DenseMatrix areas_;                 // of the facet opposite each corner
    System facets_, vertices_;
};

/// A bound on the square of |u - u_h| over the energy error, for the Galerkin u_h and every f in
/// L2; none if no count can be trusted.
std::optional<double> l2_constant_squared(const PoissonForms& forms, const std::string& engine);

} // namespace polydec
