// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/eigen/dense_pairs.h"
#include "base/errors.h"

#include <Spectra/SymEigsSolver.h>

#include <cmath>
#include <stdexcept>

namespace polydec::builtin {

namespace {

// Spectra compares with absolute thresholds, so it is shown an operator of size about one.
class ScaledOperator {
public:
    using Scalar = double;

    ScaledOperator(const SymmetricOperator& A, double scale) : A_(&A), scale_(scale) {}

    Eigen::Index rows() const { return A_->size; }
    Eigen::Index cols() const { return A_->size; }

    void perform_op(const double* x, double* y) const {
        in_ = Eigen::Map<const Vector>(x, A_->size);
        A_->apply(in_, out_);
        Eigen::Map<Vector>(y, A_->size) = out_ / scale_;
    }

private:
    const SymmetricOperator* A_;
    double scale_;
    mutable Vector in_;
    mutable Vector out_;
};

// An estimate of |A| from below, and a start vector that A does not map to zero. Scale 0: A
// vanishes on the start vector and on another one that has nothing to do with it.
struct Start {
    Vector vector;
    double scale = 0.0;
    Index operations = 0;
};

Start find_start(const SymmetricOperator& A, const Vector& wished) {
    Vector other(A.size);
    for (Index i = 0; i < A.size; ++i)
        other[i] = std::sin(1.0 + 1.7 * i) + 0.3 * std::cos(0.01 * i * i);

    Start start;
    for (const Vector* candidate : {&wished, static_cast<const Vector*>(&other)}) {
        start.vector = *candidate / candidate->stableNorm();
        Vector image;
        A.apply(start.vector, image);
        ++start.operations;
        start.scale = image.stableNorm();
        if (start.scale > 0.0)
            break;
    }
    return start;
}

EigenPairs solve_by_lanczos(const SymmetricOperator& A, Index count, const EigenOptions& options,
                            const Start& start) {
    ScaledOperator scaled(A, start.scale);
    Spectra::SymEigsSolver<ScaledOperator> solver(scaled, count, options.krylov_dimension);
    solver.init(start.vector.data());
    const Eigen::Index converged =
        solver.compute(Spectra::SortRule::LargestAlge, options.max_restarts, options.tolerance);

    EigenPairs pairs;
    pairs.values = solver.eigenvalues() * start.scale;
    pairs.vectors = solver.eigenvectors();
    pairs.converged = static_cast<Index>(converged);
    pairs.operations = static_cast<Index>(solver.num_operations()) + start.operations;
    return pairs;
}

class SpectraSolver final : public EigenSolver {
public:
    std::string name() const override { return "spectra"; }

protected:
    EigenPairs compute(const SymmetricOperator& A, Index count,
                       const EigenOptions& options) const override {
        // Lanczos needs a subspace larger than the count and not larger than the operator.
        if (A.size <= dense_size || options.krylov_dimension >= A.size)
            return dense_pairs(A, count, name());

        const Start start = find_start(A, options.start);
        if (start.scale == 0.0)
            return {Vector::Zero(count), DenseMatrix::Identity(A.size, count), count,
                    start.operations};
        try {
            EigenPairs pairs = solve_by_lanczos(A, count, options, start);
            if (!pairs.values.allFinite() || !pairs.vectors.allFinite())
                fail("the iteration broke down (an invariant subspace)\n"
                     "Use another start vector.");
            return pairs;
        } catch (const Error&) {
            throw;
        } catch (const std::logic_error& error) {
            fail(error.what());
        } catch (const std::runtime_error& error) {
            fail(error.what());
        }
    }

private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw SolverFailure(name() + ": " + reason, SolveReport::failed(name()));
    }
};

} // namespace

std::unique_ptr<EigenSolver> make_spectra() {
    return std::make_unique<SpectraSolver>();
}

} // namespace polydec::builtin
