// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/operator.h"

namespace polydec {

/// Waves of primal k-forms by leapfrog steps: with E a k-form at whole times and B a (k+1)-form at
/// half times, B -= dt d E and E += dt star_k^-1 d^T star_(k+1) B, so that E has the second time
/// derivative -delta d E. For k = 1 in space this is Maxwell's equations with the electric field on
/// edges and the magnetic flux through faces; on a merged Kuhn grid it is exactly the scheme of Yee
/// 1966. For k = 0 it is the scalar wave equation in any dimension. On a complex relative to its
/// boundary E vanishes there (a perfect conductor, a clamped membrane: Dirichlet for k = 0), else
/// nothing flows out (Neumann). A star_k that is a matrix is factorized once, and each step solves
/// with it.
class Leapfrog {
public:
    /// Throws InvalidInput if there is no degree k < n, if star_k is not positive or star_(k+1) has
    /// a negative entry, or if the time step is not positive and below stable_step.
    Leapfrog(const CellComplex& complex, const HodgeStars& stars, int k, double time_step);
    Leapfrog(const Discretization& mesh, int k, double time_step)
        : Leapfrog(mesh.complex(), mesh.stars(), k, time_step) {}

    /// One step on E (size(k) values) and B (size(k+1) values). Throws InvalidInput, as energy
    /// does, for other numbers of values.
    void step(Vector& E, Vector& B) const;

    /// Half of <E, E> + <B, B'>, B' being the B after the next half of the step: conserved to
    /// rounding by every step. Positive for stable steps.
    double energy(const Vector& E, const Vector& B) const;

    double time_step() const { return time_step_; }

private:
    void check_sizes(const Vector& E, const Vector& B) const;

    double time_step_;
    Operator d_, mass_, upper_mass_;
    Operator acceleration_; // of E by B
};

/// 2 / sqrt of the largest eigenvalue of delta d on k-forms: steps must be shorter. Units length.
/// Throws InvalidInput like Leapfrog, SolverFailure if the root of a star_k that is a matrix takes
/// more memory than there is; infinity if d is zero.
double stable_step(const CellComplex& complex, const HodgeStars& stars, int k);
inline double stable_step(const Discretization& mesh, int k) {
    return stable_step(mesh.complex(), mesh.stars(), k);
}

} // namespace polydec
