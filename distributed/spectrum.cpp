// SPDX-License-Identifier: MIT
#include "distributed/spectrum.h"

#include "backends/spectra/found_pairs.h"
#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/random.h"
#include "dec/stars/star.h"
#include "distributed/ksp.h"
#include "distributed/petsc_calls.h"
#include "distributed/shared_lanczos.h"
#include "distributed/shared_pencil.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// Rounds of asking for missing copies before giving up, and such that find nothing.
constexpr int most_rounds = 60, most_in_vain = 3;

/// More eigenvalues than asked for that are looked at in search of a gap.
constexpr GlobalIndex largest_cluster = 5000;

/// CertifiedEigensolver over all ranks: what is found, and the proof that nothing is missing.
class SharedSearch {
public:
    SharedSearch(const Ranks& ranks, const DistributedMesh& mesh, const SpectrumOptions& options,
                 int k)
        : ranks_(ranks),
          options_(options),
          pencil_(ranks, mesh.cells, k),
          pairs_(pencil_.own_size(), pencil_.small(),
                 [this](const DenseMatrix& X, const DenseMatrix& Y) {
                     return pencil_.products(X, Y);
                 }),
          random_(20 + static_cast<unsigned>(ranks.rank())) {}

    void find(Index count);

    const SharedPencil& pencil() const { return pencil_; }
    const FoundPairs& pairs() const { return pairs_; }
    const Certificate& certificate() const { return certificate_; }

private:
    OwnedMat shifted(double shift) const;
    Index ask(Index count);
    DenseMatrix sharpened(DenseMatrix Y);
    bool prove(Index count);

    const Ranks& ranks_;
    const SpectrumOptions& options_;
    SharedPencil pencil_;
    FoundPairs pairs_;
    Random random_;
    OwnedMat matrix_; // at the shift
    std::unique_ptr<Ksp> solver_;
    Certificate certificate_;
};

/// B - shift.
OwnedMat SharedSearch::shifted(double shift) const {
    OwnedMat result = copied(pencil_.matrix());
    require(MatShift(result.get(), -shift), "shifting");
    return result;
}

/// A step of inverse iteration, which takes away what rounding leaves of large eigenvalues, and
/// the best vectors in the space of all (Rayleigh-Ritz).
DenseMatrix SharedSearch::sharpened(DenseMatrix Y) {
    Index steps = 0;
    for (Index j = 0; j < Y.cols(); ++j)
        Y.col(j) = solver_->solve(Vector(Y.col(j)), steps);
    pairs_.project_out(Y);
    Vector lengths = pencil_.products(Y, Y).diagonal().cwiseSqrt();
    Y *= lengths.cwiseInverse().asDiagonal();
    const DenseMatrix gram = pencil_.products(Y, Y);
    DenseMatrix BY(Y.rows(), Y.cols());
    for (Index j = 0; j < Y.cols(); ++j)
        BY.col(j) = product(ranks_, pencil_.matrix(), Vector(Y.col(j)));
    const DenseMatrix projected = pencil_.products(Y, BY);
    const Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> ritz(
        (projected + projected.transpose()) / 2, gram);
    return ritz.info() == Eigen::Success ? DenseMatrix(Y * ritz.eigenvectors()) : Y;
}

/// Asks for eigenpairs apart from those found; how many came.
Index SharedSearch::ask(Index count) {
    Vector start(pencil_.own_size());
    for (double& entry : start)
        entry = random_.fraction() - 0.5;
    pairs_.project_out(start);
    const auto apply = [&](const Vector& y, Vector& result) {
        Vector right = y;
        pairs_.project_out(right);
        Index steps = 0;
        result = solver_->solve(right, steps);
        pairs_.project_out(result);
    };
    constexpr double tolerance = 1e-12;
    DenseMatrix Y =
        largest_eigenvectors(ranks_, {pencil_.own_size(), apply}, count, start, tolerance);
    pairs_.project_out(Y);
    // what is left of those found already has no length
    constexpr double real = 0.5;
    const Vector lengths = pencil_.products(Y, Y).diagonal().cwiseSqrt();
    std::vector<Index> good;
    for (Index j = 0; j < Y.cols(); ++j)
        if (lengths[j] > real)
            good.push_back(j);
    if (good.empty())
        return 0;
    Y = sharpened(DenseMatrix(Y(Eigen::indexing::all, good)));
    pairs_.take(Y, pencil_.enclose(Y));
    return static_cast<Index>(Y.cols());
}

/// Counts in the gap behind the first `count`, all of which are below it: whether these are all.
bool SharedSearch::prove(Index count) {
    if (count == pencil_.size()) {
        certificate_ = {2 * pencil_.norm() + pencil_.small(), count, count, true};
        return true;
    }
    const double low = pairs_.values()[count - 1] + pairs_.radii()[count - 1];
    const double high = pairs_.values()[count] - pairs_.radii()[count];
    const double tau = low + (high - low) / 2;
    // factors of B - tau are those of a matrix that is off by rounding, which must not reach over
    constexpr double lost_by_factors = 1e-13;
    if ((high - low) / 2 < lost_by_factors * pencil_.norm())
        throw SolverFailure(
            fmt::format("the eigenvalues up to {:.6g} cannot be counted: the gap after them is "
                        "below the rounding error of the largest one, about {:.3g}; request fewer "
                        "or more, or waive the proof",
                        low, pencil_.norm()));
    const OwnedMat matrix = shifted(tau);
    const Ksp factor(ranks_, matrix.get(), {"petsc.mumps"}, Definiteness::indefinite);
    const auto below = static_cast<Index>(factor.negative_pivots());
    certificate_ = {tau, below, count, below == count};
    return certificate_.complete;
}

void SharedSearch::find(Index count) {
    const auto size = static_cast<Index>(pencil_.size());
    matrix_ = shifted(-pencil_.small());
    solver_ = std::make_unique<Ksp>(ranks_, matrix_.get(), SharedEngine{"petsc.mumps"},
                                    Definiteness::positive);
    Index wanted = count + std::max<Index>(3, count / 10);
    int in_vain = 0;
    for (int round = 0; round < most_rounds && in_vain < most_in_vain; ++round) {
        if (const Index missing = std::min(wanted, size) - pairs_.count(); missing > 0)
            in_vain = ask(missing) == 0 ? in_vain + 1 : 0;
        if (pairs_.count() < count)
            continue;
        if (options_.certification == Certification::waived)
            return;
        Index behind = pairs_.gap_behind(count);
        if (behind < 0 && pairs_.count() == size)
            behind = size;
        if (behind >= 0) {
            if (prove(behind))
                return;
            wanted = pairs_.count() + std::max<Index>(1, certificate_.below_shift - behind);
        } else {
            wanted = pairs_.count() + std::max<Index>(3, pairs_.count() / 3);
        }
        if (wanted > count + largest_cluster)
            throw SolverFailure(
                fmt::format("the spectrum has no gap within {} eigenvalues after number {}, so the "
                            "count cannot be proved; waive the proof or request fewer",
                            largest_cluster, count));
    }
    throw SolverFailure(fmt::format("{} eigenvalues requested, {} found, without a proof that none "
                                    "is missing; improve cells of extreme shape, or request fewer",
                                    count, pairs_.count()));
}

} // namespace

Spectrum spectrum(const Ranks& ranks, const DistributedMesh& mesh, Side side, int degree,
                  const SpectrumOptions& options) {
    const int n = mesh.dimension();
    const int k = side == Side::primal ? degree : n - degree;
    if (k < 0 || k > n)
        throw InvalidInput(fmt::format("there are no {} {}-forms: expected a degree from 0 to {}",
                                       name(side), degree, n));
    check_stars(ranks, mesh);
    if (side == Side::dual && degree == 0)
        ranks.together("facets", [&] { check_not_branching(mesh); });
    const GlobalIndex size = mesh.cells.degree(k).count;
    if (options.count < 1 || options.count > size)
        throw InvalidInput(
            fmt::format("{} eigenvalues requested: {}", options.count, expected_numbers(1, size)));
    SharedSearch search(ranks, mesh, options, k);
    search.find(options.count);
    const FoundPairs& pairs = search.pairs();
    const Index count = options.count;
    Spectrum result{side,
                    degree,
                    pairs.values().head(count),
                    pairs.radii().head(count),
                    search.pencil().eigenvectors(pairs.vectors().leftCols(count)),
                    pairs.residuals().head(count),
                    search.certificate(),
                    "petsc.mumps",
                    "slepc",
                    rough_values(pairs, search.pencil().norm(), 1, count)};
    if (side == Side::dual)
        result.modes = HodgeStar(mesh.cells.volumes, k).diagonal().asDiagonal() * result.modes;
    return result;
}

} // namespace polydec
