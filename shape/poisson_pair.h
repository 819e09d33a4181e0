// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "shape/forms.h"
#include "shape/gluing.h"
#include "shape/poisson_error.h"

#include <memory>

namespace polydec {

/// What is given on the simplices, by their numbers: means of f, less those over components where
/// constants are free, and what the rest of f adds to errors at most.
struct LocalData {
    Vector means;
    DenseMatrix corners;    ///< f at the corners, less the same
    Vector oscillation;     ///< C_P |f - mean| / kappa^(1/2)
    DenseMatrix facet_flow; ///< what flows in by the facet lacking each corner
};

/// Functions that are linear on simplices, and one with continuous means over facets, whose
/// gradient and f make a flux in equilibrium.
struct PoissonPair {
    DenseMatrix corners; ///< values of the first: simplices x (n+1)
    DenseMatrix means;   ///< of the second, over the facet lacking each corner
    Vector source;       ///< means of f
    double rounding;     ///< what the second may be off by, in the norm of energy
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
    const std::vector<Index>& components() const { return components_; }

    /// One row of a table for each simplex: of values at vertices.
    DenseMatrix at_corners(const Vector& values) const;
    LocalData local(const DenseMatrix& source, const Vector& flow) const;

    /// What must be added to a continuous function to have Galerkin's.
    DenseMatrix to_galerkin(const DenseMatrix& corners, const LocalData& data) const;
    /// The pair of a continuous function.
    PoissonPair pair(const DenseMatrix& corners, const LocalData& data) const;

    /// The inner products of the differences of the two gradients of two pairs, with Robin's parts,
    /// by simplices.
    Vector products(const PoissonPair& a, const PoissonPair& b) const;

    /// a(u, v) and (f, v) with what flows in.
    double energy(const DenseMatrix& u, const DenseMatrix& v) const;
    double load(const LocalData& data, const DenseMatrix& v) const;
    /// The integral of u v over a simplex.
    double mass(Index s, const DenseMatrix& u, const DenseMatrix& v) const;

    /// One of the two systems: facets, or vertices.
    struct System {
        SparseMatrix K;
        std::vector<Index> unknowns; ///< simplex by simplex
        DenseMatrix kernel;          ///< constants of free components
        std::unique_ptr<LinearSolver> solver;
        double doubt; ///< of entries of K, as CountedMatrix has it
        /// Of what is orthogonal to the kernel.
        Vector solve(Vector b) const;
    };
    const System& facets() const { return facets_; }
    const System& vertices() const { return vertices_; }

private:
    System system(const FormFamily& family, std::vector<Index> unknowns,
                  const std::string& engine) const;
    Vector gathered(const System& system, const DenseMatrix& local) const;
    DenseMatrix spread(const System& system, const Vector& values) const;
    double over_facet(const DenseMatrix& u, const DenseMatrix& v, Index s, int omitted) const;

    Shape shape_;
    int n_;
    std::vector<FacetSide> sides_;
    std::vector<bool> is_boundary_; // by facets
    std::vector<Index> components_;
    Vector volumes_, bubbles_, poincare_, kappa_;
    std::vector<DenseMatrix> gradients_; // kappa |T| times products of gradients
    DenseMatrix areas_;                  // of the facet lacking each corner
    System facets_, vertices_;
};

/// A bound of |u - u_h| over the error in energy of Galerkin's u_h, squared, for every f in L2; or
/// none, where no count can be trusted.
std::optional<double> l2_constant_squared(const PoissonForms& forms, const std::string& engine);

} // namespace polydec
