// SPDX-License-Identifier: MIT
#pragma once

#include "dec/form_space.h"
#include "solvers/sources/boundary_forms.h"
#include "solvers/sources/constrained_system.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

class PoissonSystem;

/// A solution of Delta u = f, and what was found beside it, in the units of the input.
struct PoissonSolution {
    Cochain form; ///< u, prescribed values included
    /// delta w, a primal (k-1)-form, where u is the primal k-form w or its star; empty for k = 0,
    /// and with a warning where it is no number in the units of the input. Of dual 0-forms it is
    /// what flows through the facets, as they are oriented: -kappa grad u, and d of it is the
    /// integral of f in every cell.
    Cochain flux;
    Cochain removed; ///< the harmonic part of the data, which no u can give, a form like f
    SolveReport report;
    Compatibility compatibility = {};       ///< of functions: how large that part is
    std::vector<std::string> warnings = {}; ///< why u may be another one than was asked for
};

/// Solves Poisson's equation Delta u = (d delta + delta d) u = f for the forms of a space, with
/// data for its conditions, with one factorization. Of functions it is -div grad u = f, on cells
/// with a conductivity (see with_conductivity) -div kappa grad u = f; of dual functions that is
/// Darcy's problem. With star_(k+1) of a material it is that of magnetostatics.
///
/// Harmonic forms satisfy Delta u = 0 and the conditions with zero data. Harmonic functions are
/// constant on each component without an essential or Robin facet; a torus has two harmonic
/// 1-forms. The harmonic part of f and of the boundary data has no solution; it is removed and
/// returned. The solution is orthogonal to the harmonic forms unless coefficients for them are
/// given.
///
/// Where there is nothing below (k = 0), or it can be eliminated (k = n, and the star below is
/// diagonal), u alone is solved for, and its star may have any sign. Otherwise u and its flux are
/// found together, the mixed method: no star is inverted, and with stars that are matrices it is
/// that of finite element exterior calculus, for k = n of Raviart and Thomas.
///
/// Primal functions by circumcentric stars are linear finite elements on triangles, whatever was
/// merged. A dual function's boundary value stands at the circumcenter of its facet; where the dual
/// that leads there has no length the cell has that value, and its flux is what the balance of the
/// cell asks for. Where star_(n-1) is a matrix values stand at centroids (see dual_sites), and a
/// linear u comes out exactly on every flat mesh.
///
/// Source: Arnold, Falk, Winther 2006, sec. 7 and 8; Raviart, Thomas 1977.
/// An object is used by one thread at a time.
class PoissonSolver {
public:
    /// Throws InvalidInput, naming the cells: for dual functions where the cells branch or are
    /// non-orientable, or an interior facet has no dual; where the star of the forms or of those
    /// beside them is not positive, and u is not found alone; like Cells::boundary_star where there
    /// is Robin's condition. What the engine throws where it fails.
    explicit PoissonSolver(const FormSpace& space, const std::string& linear_solver = "auto");

    PoissonSolver(PoissonSolver&&) noexcept;
    ~PoissonSolver();

    /// f is a form of the space, by its integrals over cells as every form: of functions by its
    /// values. Data are those of the conditions, by default 0 (see BoundaryForms and outward_flow);
    /// others do not matter. harmonic has a coefficient for each of harmonic_forms(), or none. All
    /// in the units of the input. Throws InvalidInput for forms of another kind, other numbers of
    /// values, and for what is not finite, or becomes so when it is multiplied by volumes.
    PoissonSolution solve(const Cochain& f, const BoundaryForms& data = {},
                          const Vector& harmonic = {}) const;

    /// Columns, orthonormal in the inner product of the side; 0 where conditions fix values.
    DenseMatrix harmonic_forms() const;

    const FormSpace& space() const& { return space_; }
    FormSpace space() && { return space_; }

private:
    FormSpace space_;
    std::unique_ptr<const PoissonSystem> system_;
    std::vector<std::string> warnings_; // part of every solution's
};

/// The source j of d^T star du = star j under Coulomb's gauge, delta u = 0, by any solver of
/// Delta u = j: what of j is no curl (exact) is removed, and so is what is harmonic. With
/// star_(k+1) of a material (1 over the permeability, see material_star) this is magnetostatics, of
/// the vector potential u and a current j: primal 1-forms in space, primal 1-forms or dual 0-forms
/// in the plane.
struct CurlCurlSolution {
    Cochain potential;
    Cochain removed; ///< from j: its exact and its harmonic part, 0 for a current without sources
    SolveReport report;
};

/// For primal forms; the first solve finds the exact part of j, which is d delta u. `data` are
/// boundary data of u with delta u = 0. Throws like PoissonSolver::solve, and InvalidInput for dual
/// forms.
CurlCurlSolution solve_curl_curl(const PoissonSolver& solver, const Cochain& j,
                                 const BoundaryForms& data = {});

} // namespace polydec
