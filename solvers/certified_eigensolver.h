// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/linear_solver.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

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
    std::function<void(std::string_view)> progress = {}; ///< told what is being done; may be empty
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
    Vector residuals;    ///< |A x - lambda M x| / |M x|, 2-norms
    Certificate certificate;
    std::string linear_solver; ///< the engines that did it
    std::string eigen_solver;
};

/// Smallest eigenpairs of A x = lambda M x, A symmetric, M diagonal and positive, with the proof
/// that none is missing: shift-invert Lanczos, then the inertia of A - tau M with tau in a gap
/// behind the values found; while it counts more, those found are projected out and the missing
/// ones asked for. Keeps what it has found for further calls.
class CertifiedEigensolver {
public:
    /// Throws InvalidInput for sizes that do not fit or an entry of M that is not positive.
    CertifiedEigensolver(const SparseMatrix& A, const Vector& M, EigensolverOptions options = {});
    CertifiedEigensolver(CertifiedEigensolver&&) noexcept;
    ~CertifiedEigensolver();

    /// The `count` (algebraically) smallest eigenpairs, 1 <= count <= size; scale-free.
    /// Throws InvalidInput for an impossible count, SolverFailure if they cannot be had or proved.
    CertifiedEigenpairs smallest(Index count);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace polydec
