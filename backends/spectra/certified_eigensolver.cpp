// SPDX-License-Identifier: MIT
#include "backends/spectra/certified_eigensolver.h"

#include "backends/registry.h"
#include "backends/spectra/found_pairs.h"
#include "backends/spectra/inertia.h"
#include "backends/spectra/shifted_solver.h"
#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Rounds of asking for missing copies before giving up; each finds at least one.
constexpr int patience = 60;

/// Rounds that find nothing, each from another start, before giving up.
constexpr int most_in_vain = 3;

/// From so many on blocks pay: their steps cost less, and Spectra's orthogonalization outgrows all.
/// Of its time they take 0.8 to 1 here on 80 000 cells, 0.65 to 0.8 for 15, and 1.15 on 12 000.
constexpr Index many = 10;

/// Where what is found is kept, pairs are asked for in as many parts at most, of at least this
/// size.
constexpr Index most_parts = 16, least_part = 32;

/// More eigenvalues than asked for that are looked at in search of a gap.
constexpr Index largest_cluster = 5000;

/// Gaps in which no count can be trusted; others are looked for behind them.
constexpr int most_failures = 3;

enum class Proof { complete, missing, untrusted, no_gap };

} // namespace

struct CertifiedEigensolver::State {
    State(const Pencil& given, EigensolverOptions options_)
        : pencil(given),
          options(std::move(options_)),
          counter(pencil.matrices(), options.linear_solver, options.domain_dimension,
                  pencil.doubt()),
          norm(pencil.norm()),
          small(pencil.small()),
          solver(pencil, options.linear_solver, facts()),
          pairs(size(), small) {
        choose_engine(1);
    }

    Index size() const { return pencil.size(); }
    Index found() const { return pairs.count(); }
    void tell(std::string_view what) const {
        if (options.progress)
            options.progress(what);
    }

    MatrixFacts facts() const {
        MatrixFacts facts;
        facts.symmetry = Symmetry::symmetric;
        facts.domain_dimension = options.domain_dimension;
        facts.many_solves = true;
        // next to eigenvalues so small beside the largest, residuals of solves are not
        if (small < 1e-8 * norm)
            facts.inertia = Inertia::wanted;
        return facts;
    }

    /// The counter, which factorizes too.
    InertiaCounter& counting() {
        tell("counting");
        solver.make_room();
        return counter;
    }

    /// The eigensolver asked for, or the one that suits the largest number asked for so far.
    void choose_engine(Index count) {
        const bool is_free = options.eigen_solver == "auto";
        if (!eigensolver)
            eigensolver = make_eigen_solver(is_free ? "spectra" : options.eigen_solver);
        if (is_free && count >= many && eigensolver->name() != "block-lanczos")
            eigensolver = make_eigen_solver("block-lanczos");
    }

    /// A shift below the whole spectrum: for indefinite A, close to the first `wanted` eigenvalues.
    double lowest_shift(Index wanted) {
        if (options.definiteness != Definiteness::indefinite ||
            counter.below(-small, small) == Index{0})
            return -small;
        return counting().shift_close_to(0, wanted, -2 * norm, -small, small);
    }

    void set_shift(double shift, Definiteness definiteness) {
        tell("factorizing");
        solver.set(shift, definiteness);
        smoothed = false;
    }

    /// Asks for `count` eigenpairs above the shift and apart from those found; how many came.
    Index ask(Index count) {
        tell("iterating");
        count = std::min(count, size() - found());
        choose_engine(count);
        const auto apply = [&](const auto& X, auto& Y) {
            tell("a step of the iteration");
            if (found() == 0) {
                Y = solver.solve(X);
                return;
            }
            auto right = X;
            pairs.project_out(right);
            Y = solver.solve(right);
            pairs.project_out(Y);
        };
        EigenOptions eigen_options;
        eigen_options.max_restarts = in_vain == 0 ? 300 : 60;
        eigen_options.tolerance *=
            std::pow(100.0, std::min(in_vain, 2)); // enclosures tell the rest
        eigen_options.start.resize(size());
        for (double& entry : eigen_options.start)
            entry = random.fraction() - 0.5;
        pairs.project_out(eigen_options.start);
        if (eigen_options.start.norm() == 0)
            return 0;

        const auto came = eigensolver->largest({size(), apply, apply}, count, eigen_options);
        // true ones are above 1 / (norm - shift)
        const double floor = 1e-3 / (norm + std::abs(solver.shift()));
        Index good = 0;
        while (good < came.converged && came.values[good] > floor)
            ++good;
        const DenseMatrix more = came.vectors.leftCols(good);
        pairs.take(more, pencil.enclose(more));
        smoothed = smoothed && good == 0;
        if (options.found && good > 0)
            options.found(pairs.vectors());
        return good;
    }

    /// Whether something could be done for the accuracy of the first `count`.
    bool improve(Index count) {
        const Index rough = pairs.fine_before(count);
        return rough < count && (smooth() || approach(rough));
    }

    /// Rounding and the iteration leave noise of large eigenvalues in the vectors, which a step of
    /// inverse iteration takes away. As a correction from accurate residuals it is right in the
    /// small entries of a vector too. Nothing that would bring the noise back comes after it: no
    /// projection, no reflections.
    bool smooth() {
        if (std::exchange(smoothed, true))
            return false;
        tell("refining");
        const auto fine = pairs.all(true);
        DenseMatrix Y = pairs.vectors()(Eigen::indexing::all, pairs.all(false));
        pairs.keep(fine);
        pairs.project_out(Y);
        DenseMatrix residuals;
        pencil.enclose(Y, &residuals);
        Y -= solver.solve(residuals);
        Y.colwise().normalize();
        pairs.take(Y, pencil.enclose(Y));
        rotate();
        return true;
    }

    /// Rayleigh-Ritz: of vectors that are not fine, the best in the space of all of them.
    void rotate() {
        const auto rough = pairs.all(false);
        if (rough.size() < 2)
            return;
        const DenseMatrix Y = pairs.vectors()(Eigen::indexing::all, rough);
        const DenseMatrix gram = Y.transpose() * Y;
        const Eigen::LLT<DenseMatrix> factor(gram);
        constexpr double dependent = 1e-5;
        if (factor.info() != Eigen::Success ||
            !(factor.matrixLLT().diagonal().minCoeff() > dependent))
            return;
        DenseMatrix images;
        const auto enclosures = pencil.enclose(Y, &images);
        for (Index i = 0; i < images.cols(); ++i)
            images.col(i) += enclosures[i].value * Y.col(i);
        const DenseMatrix projected = Y.transpose() * images;
        const Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> ritz(
            (projected + projected.transpose()) / 2, gram);
        if (ritz.info() != Eigen::Success)
            return;
        const DenseMatrix better = Y * ritz.eigenvectors();
        pairs.keep(pairs.all(true));
        pairs.take(better, pencil.enclose(better));
    }

    /// Eigenvalues far from the shift, seen from there, lie close together, and their vectors come
    /// out mixed. Moves the shift up to the first that is rough, as near as it is known, and gives
    /// up those that are; false if that is no gain.
    bool approach(Index rough) {
        const double value = pairs.values()[rough], radius = pairs.radii()[rough];
        const double distance = std::max({64 * radius, std::abs(value) / 8, 1e-12 * norm, small});
        const double next = value - distance;
        if (distance > (value - solver.shift()) / 4)
            return false;
        if (rough > 0 && next <= pairs.values()[rough - 1] + pairs.radii()[rough - 1])
            return false;
        if (counting().below(next, distance / 2) != rough)
            return false;
        pairs.keep(pairs.all(true));
        set_shift(next, rough == 0 ? Definiteness::positive : Definiteness::indefinite);
        return true;
    }

    /// The first index i >= count such that a gap lies between values i-1 and i, or, as a count
    /// will tell, behind all that are found; -1 if there is none. What is next tells the radii of
    /// zeros.
    Index gap_behind(Index count) const {
        const Index behind = pairs.gap_behind(count);
        const bool may_end =
            found() == size() || (found() > 0 && pairs.values()[found() - 1] > small);
        return behind < 0 && count <= found() && may_end ? found() : behind;
    }

    /// Proves that the first `count` are all there are below the gap behind them, or below some
    /// place behind them if these are all that are found.
    Proof certify(Index count) {
        if (count == size()) {
            certificate = {2 * norm + small, count, count, true}; // no eigenvalue is above the norm
            return Proof::complete;
        }
        const Vector &values = pairs.values(), &radii = pairs.radii();
        const double low = values[count - 1] + radii[count - 1];
        const double near = std::max(std::abs(low) / 64, small); // others follow soon
        const double high = count < found() ? values[count] - radii[count] : low + near;
        const auto counted = counting().between(low, high, count);
        if (!counted)
            return Proof::untrusted;
        certificate = {counted->shift, counted->below, count, counted->below == count};
        return certificate.complete ? Proof::complete : Proof::missing;
    }

    /// Proves that the first `count` and those up to the next gap where a count can be trusted are
    /// all.
    Proof prove(Index count) {
        for (Index i = gap_behind(count); i >= 0; i = gap_behind(i + 1)) {
            if (i < size() && pairs.values()[i - 1] <= untrusted)
                continue;
            if (const Proof proof = certify(i); proof != Proof::untrusted)
                return proof;
            untrusted = pairs.values()[i - 1];
            if (i < found() && ++failures > most_failures)
                throw SolverFailure(fmt::format(
                    "the eigenvalues up to {:.6g} cannot be counted: the factorizations of A - tau "
                    "M near this value are not accurate enough ({} found); request fewer or more "
                    "eigenvalues, or waive the proof",
                    pencil.eigenvalue(untrusted), i));
        }
        return Proof::no_gap;
    }

    /// Where the shift is far from what is still to be found, iterations stall: it moves up behind
    /// the longest part of what has been found that is proved complete. A part of a complete one is
    /// complete, so bisection finds it.
    void move_shift(Index wanted) {
        pairs.keep(pairs.all(true));
        std::vector<Index> parts;
        for (Index count = gap_behind(1); count > 0 && count < found();
             count = gap_behind(count + 1))
            parts.push_back(count);
        if (found() > 0)
            parts.push_back(found());
        Certificate best;
        for (std::size_t first = 0, last = parts.size(); first < last;) {
            const std::size_t middle = (first + last) / 2;
            if (certify(parts[middle]) == Proof::complete) {
                best = certificate;
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        if (!best.complete)
            return;
        const double next =
            counting().shift_close_to(best.below_shift, wanted, best.shift, 2 * norm, small);
        if (next > solver.shift())
            set_shift(next, Definiteness::indefinite);
    }

    CertifiedEigenpairs result(Index count) const {
        CertifiedEigenpairs result;
        result.values = pencil.eigenvalues(pairs.values().head(count));
        result.vectors = pencil.eigenvectors(pairs.vectors().leftCols(count));
        result.radii = pencil.eigenvalues(pairs.radii().head(count));
        result.residuals = pencil.eigenvalues(pairs.residuals().head(count));
        result.certificate = certificate;
        result.certificate.shift = pencil.eigenvalue(certificate.shift);
        result.linear_solver = solver.engine();
        result.eigen_solver = eigensolver->name();
        result.rough = rough_values(pairs, norm, pencil.eigenvalue(1), count);
        return result;
    }

    ScaledPencil pencil;
    EigensolverOptions options;
    InertiaCounter counter;
    std::unique_ptr<EigenSolver> eigensolver;
    double norm;
    double small;          // a length on the axis far below any eigenvalue that is not zero
    ShiftedSolver solver;  // at a shift below every eigenvalue that is not found
    bool smoothed = false; // with this shift
    int in_vain = 0;       // rounds in a row that found nothing
    Random random{20};

    FoundPairs pairs;
    Certificate certificate;
    double untrusted = -std::numeric_limits<double>::infinity(); // no count was, in gaps up to here
    int failures = 0;                                            // of counts to be trusted
};

CertifiedEigensolver::CertifiedEigensolver(const Pencil& pencil, EigensolverOptions options)
    : state_(std::make_shared<State>(pencil, std::move(options))) {}

CertifiedEigensolver::CertifiedEigensolver(const SparseMatrix& A, const Vector& M,
                                           EigensolverOptions options)
    : CertifiedEigensolver(Pencil{.C = A, .M = M}, std::move(options)) {}

CertifiedEigenpairs CertifiedEigensolver::smallest(Index count) {
    State& s = *state_;
    if (count < 1 || count > s.size())
        throw InvalidInput(
            fmt::format("{} eigenvalues requested: {}", count, expected_numbers(1, s.size())));
    const Index zeros = std::min(s.options.zeros, s.size());
    Index wanted = std::max(count + std::max<Index>(3, count / 10), zeros + 3); // behind a gap
    if (s.pairs.gap_behind(count) >= 0)
        wanted = count;
    if (!s.solver.is_set())
        s.set_shift(s.lowest_shift(wanted), Definiteness::positive);
    take_kernel(s.pairs, s.pencil, std::exchange(s.options.kernel, {}));
    take_proved(s.pairs, s.pencil, std::exchange(s.options.start, {}));
    s.in_vain = 0;
    for (int round = 0; round < patience && s.in_vain < most_in_vain; ++round) {
        if (s.found() < std::min(wanted, s.size())) {
            Index asked = std::min(wanted, s.size()) - s.found();
            if (s.options.found) // little is lost between then
                asked = std::min(asked, std::max(least_part, wanted / most_parts));
            const Index came = s.ask(asked);
            s.in_vain = came == 0 ? s.in_vain + 1 : 0;
            if (came < asked && s.found() < count) {
                s.move_shift(wanted);
                continue;
            }
            if (s.options.found && s.found() < std::min(wanted, s.size()) && came == asked)
                continue; // with the next part
        }
        if (s.found() >= count && s.improve(count))
            continue;
        if (s.found() >= count && s.options.certification == Certification::waived)
            return s.result(count);
        switch (s.found() < count ? Proof::no_gap : s.prove(count)) {
        case Proof::complete:
            return s.result(count);
        case Proof::missing:
            wanted = s.found() + s.certificate.below_shift - s.certificate.returned_below_shift;
            break;
        default:
            // a cluster without end, or not yet seen
            wanted = s.found() + std::max<Index>(3, s.found() / 3);
            if (wanted > count + largest_cluster)
                throw SolverFailure(
                    fmt::format("the spectrum has no gap within {} eigenvalues after number {}, so "
                                "the count cannot be proved; waive the proof or request fewer",
                                largest_cluster, count));
        }
    }
    throw SolverFailure(fmt::format("{} eigenvalues requested, {} found, without a proof that none "
                                    "is missing: rounding hides the others, or too many are close "
                                    "together; improve cells of extreme shape, or request fewer",
                                    count, s.found()));
}

} // namespace polydec
