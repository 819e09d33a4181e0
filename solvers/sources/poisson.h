// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "dec/boundary/form_space.h"
#include "solvers/sources/boundary_forms.h"
#include "solvers/sources/constrained_system.h"

#include <string>
#include <vector>

namespace polydec {

class PoissonSystem;

/// A solution of Delta u = f, with its flux and diagnostics, in the units of the input.
struct PoissonSolution {
    Cochain form; ///< u, prescribed values included
    /// delta w, a primal (k-1)-form, where u is the primal k-form w or its star. Empty for k = 0;
    /// empty with a warning if it overflows in the units of the input. For dual 0-forms it is the
    /// flow -kappa grad u through the oriented facets, and its d is the integral of f over every
    /// cell.
    Cochain flux;
    Cochain removed; ///< the harmonic part of the data, which no u can match; a form like f
    SolveReport report;
    Compatibility compatibility = {}; ///< for functions: the size of that part
    /// Why u may differ from the requested one, and better engines that are not installed.
    std::vector<std::string> warnings = {};
};

/// Solves Poisson's equation Delta u = (d delta + delta d) u = f for the forms of a space, with
/// boundary data and one factorization. For functions it is -div grad u = f; with a conductivity
/// (see with_conductivity) it is -div kappa grad u = f, which is Darcy's problem for dual
/// functions. With star_(k+1) of a material it is the equation of magnetostatics.
///
/// Harmonic forms satisfy Delta u = 0 and the conditions with zero data. Harmonic functions are
/// constant on each component without an essential or Robin facet; a torus has two harmonic
/// 1-forms. The harmonic part of f and of the boundary data has no solution; it is removed and
/// returned. The solution is orthogonal to the harmonic forms unless the caller gives coefficients
/// for them.
///
/// If no (k-1)-form exists (k = 0), or it can be eliminated (k = n with a diagonal star below), u
/// alone is the unknown, and its star may have any sign. Otherwise the mixed method finds u and its
/// flux together and inverts no star. With stars that are matrices it is the mixed method of finite
/// element exterior calculus; for k = n, the method of Raviart and Thomas.
///
/// With circumcentric stars, primal functions on triangles have the stiffness of linear elements,
/// also after merging; the load is f times the dual area. The boundary value of a dual function
/// stands at the circumcenter of its facet. If the dual edge to that point has length 0, the cell
/// takes that value, and the balance of the cell gives the flux. If star_(n-1) is a matrix, values
/// stand at centroids (see dual_sites), and a linear u is reproduced exactly on every flat mesh.
///
/// Source: Arnold, Falk, Winther 2006, sec. 7 and 8; Raviart, Thomas 1977.
/// Copies share the factorization; use them from one thread at a time.
class PoissonSolver {
public:
    /// Throws InvalidInput, naming the cells, for dual functions if the cells branch, are
    /// non-orientable, or an interior facet has no dual; if u is not solved for alone and the star
    /// of the forms or of their codifferentials is not positive; with a Robin condition, like
    /// Cells::boundary_star. Passes on the engine's errors.
    explicit PoissonSolver(const FormSpace& space, const std::string& linear_solver = "auto");

    /// f is a form of the space, given by integrals over cells like every form; functions by their
    /// values. `data` belong to the conditions, by default 0 (see BoundaryForms and outward_flow);
    /// other data are ignored. `harmonic` has one coefficient per column of harmonic_forms(), or
    /// none. All in the units of the input. Throws InvalidInput for forms of another kind, wrong
    /// sizes, and values that are not finite or overflow when multiplied by volumes.
    PoissonSolution solve(const Cochain& f, const BoundaryForms& data = {},
                          const Vector& harmonic = {}) const;

    /// Columns, orthonormal in the inner product of the side; 0 where conditions fix values.
    DenseMatrix harmonic_forms() const;

    const FormSpace& space() const& { return space_; }
    FormSpace space() && { return space_; }

private:
    FormSpace space_;
    Shared<const PoissonSystem> system_;
    std::vector<std::string> warnings_; // included in every solution
};

/// The solution u of d^T star du = star j under the Coulomb gauge, delta u = 0, from any solver of
/// Delta u = j. The exact and harmonic parts of j, which are not curls, are removed. With
/// star_(k+1) of a material (1 over the permeability, see material_star) this is magnetostatics for
/// the vector potential u and a current j: primal 1-forms in space, primal 1-forms or dual 0-forms
/// in the plane.
struct CurlCurlSolution {
    Cochain potential;
    Cochain removed; ///< the exact and harmonic parts of j; 0 for a current without sources
    SolveReport report;
};

/// For primal forms. The first solve finds d delta u, the exact part of j. `data` are boundary data
/// of u with delta u = 0. Throws like PoissonSolver::solve, and InvalidInput for dual forms.
CurlCurlSolution solve_curl_curl(const PoissonSolver& solver, const Cochain& j,
                                 const BoundaryForms& data = {});

} // namespace polydec
