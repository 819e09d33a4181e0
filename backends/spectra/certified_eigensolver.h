// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/linear_solver.h"
#include "backends/spectra/pencil.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Whether answers must be proved complete.
enum class Certification { required, waived };

struct EigensolverOptions {
    std::string linear_solver = "auto";
    /// auto: block-lanczos for many, spectra for few
    std::string eigen_solver = "auto";
    Certification certification = Certification::required;
    int domain_dimension = 0; ///< hint for orderings; 0: unknown
    /// Whether A is known to be positive semidefinite; if not, its inertia is looked at first.
    Definiteness definiteness = Definiteness::indefinite;
    Index zeros = 0; ///< hint: as many eigenvalues are known to be zero
    /// Independent vectors, orthogonal in M, that are known to have the eigenvalue zero.
    DenseMatrix kernel = {};
    std::function<void(std::string_view)> progress = {}; ///< told what is being done, at each step
    /// Told of the eigenvectors found so far, as columns in the solver's own scale, whenever there
    /// are more; they are asked for in parts then.
    std::function<void(const DenseMatrix&)> found = {};
    /// Some that were told of before, of the same pencil. They are taken for what they prove to be
    /// here, like all others: those that prove nothing are left out.
    DenseMatrix start = {};
};

/// Proof that no eigenvalue is missing: by Sylvester's law of inertia `below_shift` eigenvalues lie
/// below `shift`, which lies in a gap of the spectrum behind all values returned, and
/// `returned_below_shift` were computed.
struct Certificate {
    double shift = 0;
    Index below_shift = 0;
    Index returned_below_shift = 0;
    bool complete = false;
};

struct CertifiedEigenpairs {
    Vector values;       ///< ascending, with multiplicity
    DenseMatrix vectors; ///< columns x with x^T M y = 0 or 1
    /// Each eigenvalue that belongs to a value is within its radius of it, matched one to one.
    Vector radii;
    Vector residuals; ///< |A x - lambda M x| / |M x|, 2-norms
    Certificate certificate;
    std::string linear_solver; ///< the engines that did it
    std::string eigen_solver;
    /// Values whose radius is above 1e-6 of them and of the distance to the next ones: rounding
    /// beside the largest eigenvalue hides them.
    std::vector<Index> rough = {};
};

/// Smallest eigenpairs of A x = lambda M x, A symmetric, M positive definite, with the proof that
/// none is missing and with the distances within which the exact ones lie.
///
/// That none is missing: shift-invert Lanczos, then the inertia of A - tau M (of a larger matrix
/// where A is not sparse, see ShiftedMatrices) with tau in a gap
/// behind the values found; while it counts more, those found are projected out and the missing
/// ones asked for. The shift moves where eigenvalues far from it come out inaccurately.
///
/// The distances: the eigenvalue of x is its Rayleigh quotient theta, and |A x - theta M x| in the
/// norm of M^-1 over |x| in that of M a radius within which an eigenvalue lies; for values nearer
/// to each other than their radii the norm of all their residuals (Kahan 1967), so that values and
/// eigenvalues correspond one to one. Residuals are evaluated from the parts of A, in the longest
/// floating-point format there is, and the radii include their rounding and what the uncertainties
/// of weights and masses can do. With the proof that none is missing they hold for the i-th
/// smallest eigenvalue and the i-th value. Not covered: the inertia is counted in floating-point
/// numbers; InertiaCounter says where it is trusted.
///
/// Scale-free. Keeps what it has found for further calls.
class CertifiedEigensolver {
public:
    /// Throws InvalidInput for sizes that do not fit, a mass that is not positive, numbers that are
    /// not finite, and matrices that are not symmetric.
    explicit CertifiedEigensolver(const Pencil& pencil, EigensolverOptions options = {});
    CertifiedEigensolver(const SparseMatrix& A, const Vector& M, EigensolverOptions options = {});
    CertifiedEigensolver(CertifiedEigensolver&&) noexcept;
    ~CertifiedEigensolver();

    /// The `count` (algebraically) smallest eigenpairs, 1 <= count <= size.
    /// Throws InvalidInput for an impossible count, and for vectors to start with of another size
    /// or that are not finite; SolverFailure if they cannot be had or proved,
    /// or a radius does not tell one of them from the next ones.
    CertifiedEigenpairs smallest(Index count);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace polydec
