// SPDX-License-Identifier: MIT
#include "solvers/certified_eigensolver.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "solvers/inertia.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// Multiplets split by 1e-2 on real meshes and by 1e-14 on symmetric ones; two values further apart
/// than this are no copies of one.
constexpr double relative_gap = 1e-6;

/// Rounds of asking for missing copies before giving up; each finds at least one.
constexpr int patience = 60;

/// Halvings of an interval on the axis; each costs a factorization.
constexpr int most_bisections = 40;

/// From so many on blocks pay: their steps cost less, and Spectra's orthogonalization outgrows all.
constexpr Index many = 20;

/// More eigenvalues than asked for that are looked at in search of a gap.
constexpr Index largest_cluster = 5000;

SparseMatrix scale_by_mass(const SparseMatrix& A, const Vector& M) {
    if (A.rows() != A.cols() || A.rows() != M.size() || M.size() == 0)
        throw InvalidInput(fmt::format("eigenproblem A x = lambda M x: A is {} x {}, M has {} "
                                       "entries; expected equal sizes above 0",
                                       A.rows(), A.cols(), M.size()));
    for (Index i = 0; i < M.size(); ++i)
        if (!(M[i] > 0) || !std::isfinite(M[i]))
            throw InvalidInput(
                fmt::format("eigenproblem A x = lambda M x: entry {} of M is {}, expected a "
                            "positive number",
                            i, M[i]));
    const Vector root = M.cwiseSqrt().cwiseInverse();
    const SparseMatrix left = root.asDiagonal() * A;
    const SparseMatrix B = left * root.asDiagonal();
    return (B + SparseMatrix(B.transpose())) / 2;
}

/// A small negative shift: a positive semidefinite B less it is positive, at any scale.
double small_negative_shift(const SparseMatrix& B) {
    Vector diagonal = B.diagonal().cwiseAbs();
    std::nth_element(diagonal.begin(), diagonal.begin() + diagonal.size() / 2, diagonal.end());
    double typical = diagonal[diagonal.size() / 2];
    if (typical == 0)
        typical = row_sum_norm(B);
    if (typical == 0)
        typical = 1;
    return -1e-3 * typical / std::sqrt(static_cast<double>(B.rows()));
}

} // namespace

struct CertifiedEigensolver::State {
    State(const SparseMatrix& A_, const Vector& M_, EigensolverOptions options_)
        : A(A_),
          M(M_),
          options(std::move(options_)),
          B(std::make_shared<SparseMatrix>(scale_by_mass(A_, M_))),
          counter(B, options.linear_solver, options.domain_dimension),
          solver(make_linear_solver(options.linear_solver)),
          norm(row_sum_norm(*B)),
          small(-small_negative_shift(*B)) {
        choose_engine(1);
    }

    Index size() const { return static_cast<Index>(B->rows()); }
    Index found() const { return static_cast<Index>(values.size()); }
    void tell(std::string_view what) const {
        if (options.progress)
            options.progress(what);
    }

    void choose_engine(Index count);
    double lowest_shift(Index wanted);
    double shift_close_to(Index done, Index wanted, double low, double high);
    void set_shift(double sigma, Definiteness definiteness);
    Index ask(Index count);
    void rayleigh_ritz(const DenseMatrix& more);
    Index gap_behind(Index count) const;
    bool certify(Index count);
    void move_shift(Index wanted);
    CertifiedEigenpairs result(Index count) const;

    SparseMatrix A;
    Vector M;
    EigensolverOptions options;
    std::shared_ptr<const SparseMatrix> B; // M^-1/2 A M^-1/2
    InertiaCounter counter;
    std::unique_ptr<LinearSolver> solver; // of B - shift
    std::unique_ptr<EigenSolver> eigensolver;
    double norm;
    double small;     // a length on the axis far below any eigenvalue that is not zero
    double shift = 0; // below every eigenvalue that is not found
    bool factorized = false;
    std::mt19937_64 random{20};

    Vector values;                                   // ascending
    DenseMatrix vectors = DenseMatrix(B->rows(), 0); // orthonormal eigenvectors of B
    Certificate certificate;
};

/// The eigensolver asked for, or the one that suits the largest number asked for so far.
void CertifiedEigensolver::State::choose_engine(Index count) {
    const bool is_free = options.eigen_solver == "auto";
    if (!eigensolver)
        eigensolver = make_eigen_solver(is_free ? "spectra" : options.eigen_solver);
    if (is_free && count >= many && eigensolver->name() != "block-lanczos")
        eigensolver = make_eigen_solver("block-lanczos");
}

/// A shift below the whole spectrum: for indefinite A, close to the first `wanted` eigenvalues.
double CertifiedEigensolver::State::lowest_shift(Index wanted) {
    if (options.definiteness != Definiteness::indefinite ||
        counter.below(-small, small) == Index{0})
        return -small;
    return shift_close_to(0, wanted, -2 * norm, -small);
}

/// A shift in (low, high) with `done` eigenvalues below it, as low has, so that no more than
/// `wanted` others lie within reach: iterations about it converge where those about low would not.
double CertifiedEigensolver::State::shift_close_to(Index done, Index wanted, double low,
                                                   double high) {
    tell("counting");
    for (int step = 0; step < most_bisections; ++step) {
        // a multiplet of more copies than wanted has no shift that is near enough; nearer than this
        // the factorization would lose digits
        if (high < 0 && high - low < 1e-3 * std::abs(low))
            break;
        const double middle = (low + high) / 2;
        const auto below = counter.below(middle, small);
        if (!below)
            break;
        if (*below > done)
            high = middle;
        else
            low = middle;
        if (*below > done && *below <= done + wanted)
            break;
    }
    return low;
}

void CertifiedEigensolver::State::set_shift(double sigma, Definiteness definiteness) {
    tell("factorizing");
    MatrixFacts facts;
    facts.symmetry = Symmetry::symmetric;
    facts.definiteness = definiteness;
    facts.domain_dimension = options.domain_dimension;
    facts.many_solves = true;
    solver->factorize(std::make_shared<const SparseMatrix>(shifted(*B, sigma)), facts);
    shift = sigma;
    factorized = true;
}

/// Asks for `count` eigenpairs above the shift and apart from those found; how many came.
Index CertifiedEigensolver::State::ask(Index count) {
    tell("iterating");
    count = std::min(count, size() - found());
    choose_engine(count);
    const auto project = [&](auto& X) {
        if (found() > 0)
            X -= vectors * (vectors.transpose() * X);
    };
    const auto apply = [&](const auto& X, auto& Y) {
        if (found() == 0) {
            Y = solver->solve(X);
            return;
        }
        auto right = X;
        project(right);
        Y = solver->solve(right);
        project(Y);
    };
    EigenOptions eigen_options;
    eigen_options.max_restarts = 300;
    eigen_options.start.resize(size());
    for (double& entry : eigen_options.start)
        entry = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
    project(eigen_options.start);
    if (eigen_options.start.norm() == 0)
        return 0;

    const auto pairs = eigensolver->largest({size(), apply, apply}, count, eigen_options);
    const double floor = 1e-3 / (norm + std::abs(shift)); // true ones are above 1 / (norm - shift)
    Index good = 0;
    while (good < pairs.converged && pairs.values[good] > floor)
        ++good;
    if (good > 0 && found() == 0) {
        values = pairs.values.head(good).cwiseInverse().array() + shift;
        vectors = pairs.vectors.leftCols(good);
    } else if (good > 0) {
        rayleigh_ritz(pairs.vectors.leftCols(good));
    }
    return good;
}

/// Eigenpairs in the span of those found and more, of the inverse: small eigenvalues would drown in
/// the rounding of products with B itself.
void CertifiedEigensolver::State::rayleigh_ritz(const DenseMatrix& more) {
    DenseMatrix span(size(), found() + more.cols());
    span << vectors, more;
    const DenseMatrix thin = DenseMatrix::Identity(span.rows(), span.cols());
    const DenseMatrix basis = span.householderQr().householderQ() * thin;
    const DenseMatrix image = solver->solve(basis);
    const DenseMatrix projected = basis.transpose() * image;
    const Eigen::SelfAdjointEigenSolver<DenseMatrix> ritz((projected + projected.transpose()) / 2);

    // mu = 1 / (lambda - shift), so lambda ascends where mu descends, the negative ones first
    std::vector<Index> order(span.cols());
    std::iota(order.begin(), order.end(), Index{0});
    const Vector lambda = ritz.eigenvalues().cwiseInverse().array() + shift;
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return lambda[a] < lambda[b]; });
    values = lambda(order);
    vectors = basis * ritz.eigenvectors()(Eigen::all, order);
}

/// Where the shift is far from what is still to be found, iterations stall: it moves up behind the
/// longest part of what has been found that is proved complete. A part of a complete one is
/// complete, so bisection finds it.
void CertifiedEigensolver::State::move_shift(Index wanted) {
    std::vector<Index> parts;
    for (Index count = gap_behind(1); count > 0 && count < found(); count = gap_behind(count + 1))
        parts.push_back(count);
    Certificate best;
    for (std::size_t first = 0, last = parts.size(); first < last;) {
        const std::size_t middle = (first + last) / 2;
        if (certify(parts[middle])) {
            best = certificate;
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    if (!best.complete)
        return;
    const double next = shift_close_to(best.below_shift, wanted, best.shift, 2 * norm);
    if (next > shift)
        set_shift(next, Definiteness::indefinite);
}

/// The first index i >= count such that a gap lies between values i-1 and i; -1 if none is seen.
/// Behind all eigenvalues there is always one.
Index CertifiedEigensolver::State::gap_behind(Index count) const {
    for (Index i = count; i < found(); ++i) {
        const double size_here = std::max({std::abs(values[i]), std::abs(values[i - 1]), small});
        if (values[i] - values[i - 1] > relative_gap * size_here)
            return i;
    }
    return found() == size() ? size() : -1;
}

/// Proves that the first `count` (a gap behind them) are all there are below it; false if the
/// inertia counts more. Several places in the gap are tried before the count is called untrusted.
bool CertifiedEigensolver::State::certify(Index count) {
    if (count == size()) {
        // no eigenvalue is larger than the norm, so there is nothing to count
        certificate = {2 * norm + small, count, count, true};
        return true;
    }
    tell("counting");
    const double low = values[count - 1];
    const double high = count < found() ? values[count] : low + std::max(std::abs(low), small);
    for (const double place : {0.5, 0.38, 0.63, 0.27, 0.71}) {
        const double tau = low + place * (high - low);
        const auto below = counter.below(tau, std::min(place, 1 - place) * (high - low));
        if (!below || *below < count)
            continue;
        certificate = {tau, *below, count, *below == count};
        return certificate.complete;
    }
    throw SolverFailure(fmt::format(
        "the eigenvalues below {:.6g} cannot be counted: the factorizations of A - tau M near it "
        "are not accurate enough ({} found); ask for fewer or more eigenvalues, or waive the proof",
        high, count));
}

CertifiedEigenpairs CertifiedEigensolver::State::result(Index count) const {
    CertifiedEigenpairs pairs;
    pairs.values = values.head(count);
    pairs.vectors = M.cwiseSqrt().cwiseInverse().asDiagonal() * vectors.leftCols(count);
    pairs.residuals.resize(count);
    for (Index i = 0; i < count; ++i) {
        const Vector x = pairs.vectors.col(i), Mx = M.cwiseProduct(x);
        pairs.residuals[i] = (A * x - pairs.values[i] * Mx).norm() / Mx.norm();
    }
    pairs.certificate = certificate;
    pairs.linear_solver = solver->report().engine;
    pairs.eigen_solver = eigensolver->name();
    return pairs;
}

CertifiedEigensolver::CertifiedEigensolver(const SparseMatrix& A, const Vector& M,
                                           EigensolverOptions options)
    : state_(std::make_unique<State>(A, M, std::move(options))) {}

CertifiedEigensolver::CertifiedEigensolver(CertifiedEigensolver&&) noexcept = default;
CertifiedEigensolver::~CertifiedEigensolver() = default;

CertifiedEigenpairs CertifiedEigensolver::smallest(Index count) {
    State& s = *state_;
    if (count < 1 || count > s.size())
        throw InvalidInput(
            fmt::format("{} eigenvalues asked for: there are 1 to {} to be had", count, s.size()));
    Index wanted = count + std::max<Index>(3, count / 10);
    if (!s.factorized)
        s.set_shift(s.lowest_shift(wanted), Definiteness::positive);
    for (int round = 0; round < patience; ++round) {
        if (s.found() < std::min(wanted, s.size())) {
            const Index asked = std::min(wanted, s.size()) - s.found();
            const Index came = s.ask(asked);
            if (s.options.certification == Certification::waived && s.found() >= count)
                return s.result(count);
            if (came < asked && s.found() < count) {
                s.move_shift(wanted);
                continue;
            }
        }
        const Index behind = s.found() < count ? -1 : s.gap_behind(count);
        if (behind < 0) {
            // a cluster without end, or not yet seen
            wanted = s.found() + std::max<Index>(3, s.found() / 3);
            if (wanted > count + largest_cluster)
                throw SolverFailure(fmt::format(
                    "no gap in the spectrum within {} eigenvalues behind number {}: the count "
                    "cannot be proved; waive the proof or ask for fewer",
                    largest_cluster, count));
            continue;
        }
        if (s.certify(behind))
            return s.result(count);
        wanted = s.found() + s.certificate.below_shift - behind;
    }
    throw SolverFailure(fmt::format(
        "{} eigenvalues asked for, {} found and the proof not reached in {} rounds (last: {} by "
        "inertia, {} found below {:.6g}); ask for fewer",
        count, s.found(), patience, s.certificate.below_shift, s.certificate.returned_below_shift,
        s.certificate.shift));
}

} // namespace polydec
