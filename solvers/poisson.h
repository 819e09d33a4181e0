// SPDX-License-Identifier: MIT
#pragma once

#include "dec/cell_data.h"
#include "dec/forms/boundary_conditions.h"
#include "dec/forms/side.h"
#include "solvers/constrained_system.h"

namespace polydec {

struct PoissonOptions {
    Side side = Side::primal;
    /// Essential: u is given (Dirichlet); natural: kappa du/dnu is (Neumann); Robin: kappa du/dnu
    /// plus the coefficient times u is. The same on both sides; without more, u is given
    /// everywhere.
    BoundaryConditions boundary = {};
    std::string linear_solver = "auto";
    CellData conductivity = {}; ///< kappa > 0 of each cell of the input; none: 1 everywhere
};

class MixedPoisson;

/// Solves -div kappa grad u = f for primal 0-forms (values at vertices) or dual 0-forms (values at
/// the cells' circumcenters), with kappa = 1 Delta u = f, with one factorization.
///
/// Primal, essential: values at the vertices of these facets are fixed. Dual, essential: a boundary
/// facet's dual reaches from the cell's circumcenter to the facet's, where the boundary value is;
/// where it has no length the cell's value is the boundary value. Natural: what flows through the
/// facet enters the right-hand side. Robin: what flows through is the datum less the coefficient
/// times u; of dual forms the half dual and 1 over the coefficient resist in series. Components
/// without an essential facet have the solution of
/// mean 0, and the mean of the data is removed there. No star is inverted that need not be.
///
/// Primal, an edge connects its ends by the parts of its dual in the n-simplices around it, each
/// times its conductivity, over the edge's length; on triangles these are linear finite elements,
/// whatever was merged.
///
/// Dual, where star_(n-1) is a matrix, u and its fluxes are found together (see MixedPoisson): no
/// facet needs a dual, and a linear u comes out exactly on every flat mesh by Galerkin's and hybrid
/// stars. Values then stand at centroids where the star couples facets (see dual_sites).
/// Conductivities make Galerkin's stars of the material then (see material_star).
/// An object is used by one thread at a time.
class PoissonSolver {
public:
    /// Throws InvalidInput, naming the facets, if dual 0-forms are asked for on a complex that is
    /// non-orientable or branching, or where an interior dual has no length, or if the conditions
    /// do not fit the facets; for conductivities beside a star of one's own that is a matrix.
    PoissonSolver(const Discretization& mesh, const PoissonOptions& options = {});

    /// On any cells with any stars, whose places are not known: tables of sites have no columns.
    /// A boundary facet has a dual unless its star is zero, and what flows through it is shared
    /// equally among its vertices. Throws likewise, and for conductivities, since how the duals are
    /// divided among the cells is not known either.
    explicit PoissonSolver(const Cells& cells, const PoissonOptions& options = {});

    PoissonSolver(PoissonSolver&&) noexcept;
    ~PoissonSolver();

    /// Where f has its values, one row of coordinates each, as those of the input: vertices, or of
    /// n-cells circumcenters or centroids. All data and values are in the input's units.
    const Points& sites() const& { return sites_; }
    /// Where boundary values are asked for: vertices (those off the boundary do not matter), or
    /// those of facets (those with two cofaces do not matter).
    const Points& boundary_sites() const& { return side_ == Side::primal ? sites_ : flux_sites_; }
    /// Where normal derivatives are asked for: circumcenters of facets, or their centroids where
    /// the star is a matrix (only those with a natural condition matter).
    const Points& flux_sites() const& { return flux_sites_; }
    Points sites() && { return std::move(sites_); }
    Points boundary_sites() && { return boundary_sites(); }
    Points flux_sites() && { return std::move(flux_sites_); }

    /// f at sites(), u on the essential part of the boundary at boundary_sites(), its derivative
    /// along the outward normal, times kappa, on the natural part at flux_sites(), by default 0, on
    /// Robin's part with the coefficient times u added to it;
    /// all finite. u at sites(). Throws InvalidInput, naming the cell, where the right-hand side of
    /// the system that these make is no number.
    Solution<Vector> solve(const Vector& f, const Vector& boundary_values) const;
    Solution<Vector> solve(const Vector& f, const Vector& boundary_values,
                           const Vector& normal_derivatives) const;

    /// The same for several problems, a column each.
    Solution<DenseMatrix> solve_all(const DenseMatrix& f, const DenseMatrix& boundary_values) const;
    Solution<DenseMatrix> solve_all(const DenseMatrix& f, const DenseMatrix& boundary_values,
                                    const DenseMatrix& normal_derivatives) const;

    /// Of dual 0-forms: what flows through each facet per difference of the values beside it. Empty
    /// where star_(n-1) is a matrix.
    const Vector& facet_weights() const { return facet_weights_; }

    /// What of the mesh may spoil every solution; part of each one's warnings.
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    friend class DarcySolver;
    struct Problem;
    explicit PoissonSolver(Problem problem);
    void check(const DenseMatrix& f, const DenseMatrix& boundary_values,
               const DenseMatrix& normal_derivatives) const;
    DenseMatrix in_unit(DenseMatrix values, int order, const char* what) const;
    Solution<DenseMatrix> solve_in_unit(const DenseMatrix& f, const DenseMatrix& boundary_values,
                                        const DenseMatrix& normal_derivatives) const;

    Side side_;
    int degree_; // of the cells that values belong to
    Points sites_, flux_sites_;
    SparseMatrix mass_; // values of f to the right-hand side
    Vector facet_weights_;
    SparseMatrix boundary_load_; // boundary values to right-hand side
    SparseMatrix boundary_fix_;  // boundary values to fixed unknowns
    SparseMatrix fixed_load_;    // fixed unknowns to right-hand side, for those that are not
    SparseMatrix flux_load_;     // normal derivatives to right-hand side
    Vector robin_;               // coefficients at facets, 0 where there is none
    std::vector<std::string> warnings_;
    double unit_;                               // that the mesh is measured in
    std::unique_ptr<ConstrainedSolver> solver_; // or,
    std::unique_ptr<MixedPoisson> mixed_;       // where fluxes are unknowns too
};

} // namespace polydec
