// SPDX-License-Identifier: MIT
#pragma once

#include "dec/form_space.h"
#include "solvers/boundary_forms.h"
#include "solvers/constrained_system.h"

#include <memory>
#include <string>

namespace polydec {

class SaddleSolver;

/// A solution and what is found beside it.
struct FormSolution {
    Cochain form;
    Cochain beside;  ///< delta u of a primal form, du of a dual one, boundary data included
    Cochain removed; ///< harmonic: the part of the data that no u can give, a form like f
    SolveReport report;
};

/// Solves Delta u = (d delta + delta d) u = f for the forms of a space, with data for its
/// conditions, with one factorization.
///
/// Harmonic forms obey Delta u = 0 and the conditions with data 0 (on a torus, say, two 1-forms).
/// The harmonic part of f and of what the data add to it is removed and reported; u has the
/// harmonic part asked for, by default none: it is orthogonal to the harmonic forms.
///
/// The form and its codifferential (of dual forms: its derivative) are found together, the mixed
/// method, so no star is inverted: stars may be matrices, and then it is that of Whitney forms
/// (finite element exterior calculus). For k = 0 there is nothing beside the form.
/// Source: Arnold, Falk, Winther 2006, sec. 7 and 8.
/// An object is used by one thread at a time.
class HodgeLaplaceSolver {
public:
    /// Throws InvalidInput, naming the cells, if the star of the forms or of those beside them is
    /// not positive; like Cells::boundary_star where there is Robin's condition; what the engine
    /// throws where it fails.
    explicit HodgeLaplaceSolver(const FormSpace& space, const std::string& linear_solver = "auto");

    HodgeLaplaceSolver(HodgeLaplaceSolver&&) noexcept;
    ~HodgeLaplaceSolver();

    /// f is a form of the same side and degree, by its integrals over cells as every form. It and
    /// u are in units of a mesh's input; codifferentials and flows, as stars, in that of the mesh.
    /// harmonic has a coefficient for each of harmonic_forms(), or none. Throws InvalidInput for
    /// forms of another kind, for another number of values, and for what is not finite.
    FormSolution solve(const Cochain& f, const BoundaryForms& data = {},
                       const Vector& harmonic = {}) const;

    /// Columns, orthonormal in the inner product of the side; 0 where conditions fix values.
    DenseMatrix harmonic_forms() const;

    const FormSpace& space() const& { return space_; }
    FormSpace space() && { return space_; }

private:
    struct System;
    FormSpace space_;
    std::unique_ptr<const System> system_;
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

/// Of primal forms, d delta of which is the exact part of j. Data are those of the conditions with
/// delta u = 0. Throws like HodgeLaplaceSolver::solve, and InvalidInput for dual forms.
CurlCurlSolution solve_curl_curl(const HodgeLaplaceSolver& solver, const Cochain& j,
                                 const BoundaryForms& data = {});

} // namespace polydec
