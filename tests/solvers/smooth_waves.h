// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// A smooth k-form on R^n whose coefficients are products of cosines, each of other phases, so that
/// Delta u = n frequency^2 u; with what exterior calculus makes of it.
class WaveForm {
public:
    WaveForm(int n, int k, double frequency) : n_(n), k_(k), frequency_(frequency) {}

    int degree() const { return k_; }
    double eigenvalue() const { return n_ * frequency_ * frequency_; }

    SmoothForm form() const;
    SmoothForm derivative() const;
    SmoothForm codifferential() const;
    SmoothForm star() const;            ///< star u
    SmoothForm star_derivative() const; ///< star du

    /// Its integrals on the cells of a side, and all that can be known of it on the boundary.
    Cochain on(const Discretization& mesh, Side side) const;
    BoundaryForms boundary(const Discretization& mesh, Side side) const;

    /// The star of its trace within the faces of the unit cube but the one at x = 0, over the cells
    /// or duals of derivative_flow; where faces meet the mean.
    Vector boundary_star(const Discretization& mesh, Side side) const;

private:
    Vector coefficients(const Vector& x) const;
    DenseMatrix gradients(const Vector& x) const; ///< a row for each coefficient

    int n_, k_;
    double frequency_;
};

/// The star of forms with constant coefficients on R^n, k to n-k.
Vector euclidean_star(int n, int k, const Vector& coefficients);

} // namespace polydec::test
