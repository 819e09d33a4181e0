// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/linear_solver.h"
#include "backends/spectra/pencil.h"
#include "base/progress.h"
#include "base/shared.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Whether completeness must be proved.
enum class Certification { required, waived };

struct EigensolverOptions {
    std::string linear_solver = "auto";
    /// auto: block-lanczos for many, spectra for few
    std::string eigen_solver = "auto";
    Certification certification = Certification::required;
    int domain_dimension = 0; ///< hint for orderings; 0: unknown
    /// Whether A is known to be positive semidefinite; if not, its inertia is checked first.
    Definiteness definiteness = Definiteness::indefinite;
    Index zeros = 0; ///< hint: number of eigenvalues known to be zero
    /// Independent M-orthogonal vectors, known to have the eigenvalue zero.
    DenseMatrix kernel = {};
    Progress progress = {}; ///< called with a description at each step
    /// Called whenever there are more eigenvectors, with all found so far as columns in the
    /// solver's own scale; the solver then computes them in parts.
    std::function<void(const DenseMatrix&)> found = {};
    /// Vectors from `found` in an earlier run with the same pencil. Each is verified here like all
    /// others; vectors that prove nothing are dropped.
    DenseMatrix start = {};
};

/// Proof that no eigenvalue is missing. By Sylvester's law of inertia `below_shift` eigenvalues lie
/// below `shift`, in a gap of the spectrum above all returned values, and `returned_below_shift`
/// were computed.
struct Certificate {
    double shift = 0;
    Index below_shift = 0;
    Index returned_below_shift = 0;
    bool complete = false;
};

struct CertifiedEigenpairs {
    Vector values;       ///< ascending, with multiplicity
    DenseMatrix vectors; ///< columns x with x^T M y = 0 or 1
    /// Radii of the values: each matched eigenvalue, one to one, is within its radius of the value.
    Vector radii;
    Vector residuals; ///< |A x - lambda M x| / |M x|, 2-norms
    Certificate certificate;
    std::string linear_solver; ///< the engines used
    std::string eigen_solver;
    /// Values hidden by rounding relative to the largest eigenvalue: their radius exceeds 1e-6 of
    /// the value and of the distance to the next ones.
    std::vector<Index> rough = {};
};

/// Smallest eigenpairs of A x = lambda M x, A symmetric, M positive definite, with a proof of
/// completeness and with error radii.
///
/// Completeness: shift-invert Lanczos, then the inertia of A - tau M (of a larger matrix if A is
/// not sparse, see ShiftedMatrices) with tau in a gap above the values found. While it counts more,
/// the found vectors are projected out and the missing ones computed. The shift moves if
/// eigenvalues far from it are inaccurate.
///
/// Radii: the value of x is its Rayleigh quotient theta. An eigenvalue lies within |A x - theta M
/// x| in the M^-1-norm over |x| in the M-norm. Values nearer to each other than their radii get the
/// norm of all their residuals (Kahan 1967), so that values and eigenvalues correspond one to one.
/// Residuals are evaluated from the parts of A in the longest native floating-point format; the
/// radii include their rounding and the uncertainties of weights and masses. With the proof of
/// completeness, they hold for the i-th smallest eigenvalue and the i-th value. Not covered:
/// rounding in the inertia count; InertiaCounter states when it is trusted.
///
/// Scale-free. Reuses earlier results in further calls; copies share them.
class CertifiedEigensolver {
public:
    /// Throws InvalidInput for sizes that do not fit, a mass that is not positive, numbers that are
    /// not finite, and matrices that are not symmetric.
    explicit CertifiedEigensolver(const Pencil& pencil, EigensolverOptions options = {});
    CertifiedEigensolver(const SparseMatrix& A, const Vector& M, EigensolverOptions options = {});

    /// The `count` (algebraically) smallest eigenpairs, 1 <= count <= size. Throws InvalidInput for
    /// an impossible count, and for start vectors of wrong size or that are not finite;
    /// SolverFailure if pairs cannot be found or certified, or if a radius does not separate a
    /// value from the next ones.
    CertifiedEigenpairs smallest(Index count);

private:
    struct State;
    Shared<State> state_;
};

} // namespace polydec
