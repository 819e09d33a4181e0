// SPDX-License-Identifier: MIT
#include "backends/blas.h"
#include "backends/builtin_engines.h"
#include "backends/eigen/dense_pairs.h"
#include "backends/eigen/orthonormal_basis.h"
#include "base/random.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace polydec::builtin {

namespace {

// Columns given to the operator at once: solves get cheaper up to here, convergence slower.
constexpr Index usual_width = 8;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Lanczos by blocks (Golub and Underwood 1977) with full orthogonalization, and thick restarts (Wu
// and Simon 2000). Between the steps it holds
//     A V = V T + N C,
// the done columns V, the next block N and its coupling C, which is zero but for the last columns;
// V and N lie one behind the other in the basis, and T and C one above the other.
class Iteration {
public:
    Iteration(const SymmetricOperator& A, Index count, const EigenOptions& options, Index width)
        : A_(A),
          options_(options),
          count_(count),
          width_(width),
          limit_(options.krylov_dimension),
          basis_(A.size, limit_ + width),
          projected_(DenseMatrix::Zero(limit_ + width, limit_ + width)) {}

    EigenPairs run() {
        start();
        Index next_look = std::min(count_ + width_, limit_);
        for (Index restarts = 0;;) {
            expand();
            const bool is_full = done_ + width_ > limit_;
            if (!is_full && done_ < next_look)
                continue;
            const Ritz found = ritz();
            const bool is_all = static_cast<Index>(found.converged.size()) == count_;
            if (is_all || (is_full && restarts == options_.max_restarts))
                return pairs(found);
            if (is_full) {
                restart(found);
                ++restarts;
            }
            // the small eigenproblem would cost as much as a step
            next_look = done_ + 2 * width_;
        }
    }

private:
    struct Ritz {
        Vector values;                // descending
        DenseMatrix vectors;          // columns, in terms of V
        std::vector<Index> converged; // of the first `count`
    };

    // The start vector, and others that have nothing to do with it.
    void start() {
        next_.resize(A_.size, width_);
        Noise(11).fill(next_.reshaped());
        next_.col(0) = options_.start / options_.start.stableNorm();
        basis_.append(next_, 0.0);
    }

    void expand() {
        next_ = basis_.columns(done_, width_);
        A_.apply_to_columns(next_, image_);
        operations_ += width_;
        if (scale_ == 0.0)
            scale_ = image_.cwiseAbs().maxCoeff();
        if (scale_ > 0.0)
            image_ /= scale_;
        largest_ = std::max(largest_, image_.colwise().norm().maxCoeff());

        // By symmetry what couples the block to columns before it is known.
        const Index before = done_ - coupled_;
        const auto coupling = projected_.block(done_, coupled_, width_, before);
        add_product(-1, basis_.columns(coupled_, before), coupling.transpose(), 1, image_);
        const DenseMatrix own = transposed_product(next_, image_);
        projected_.block(done_, done_, width_, width_) = 0.5 * (own + own.transpose());
        add_product(-1, next_, projected_.block(done_, done_, width_, width_), 1, image_);

        coupled_ = done_;
        done_ += width_;
        projected_.block(done_, coupled_, width_, width_) =
            basis_.append(image_, epsilon * largest_);
    }

    Ritz ritz() const {
        const auto [values, vectors] =
            symmetric_pairs(projected_.topLeftCorner(done_, done_), "block-lanczos");
        Ritz found{values.reverse(), vectors.rowwise().reverse(), {}};

        // |A v - theta v| of a Ritz vector v = V s is |C s|; no residual falls below rounding.
        const Index wide = done_ - coupled_;
        const DenseMatrix residuals = projected_.block(done_, coupled_, width_, wide) *
                                      found.vectors.block(coupled_, 0, wide, count_);
        const double floor = epsilon * found.values.cwiseAbs().maxCoeff();
        for (Index i = 0; i < count_; ++i)
            if (residuals.col(i).norm() <=
                std::max(options_.tolerance * std::abs(found.values[i]), floor))
                found.converged.push_back(i);
        return found;
    }

    // Keeps the Ritz vectors that are wanted, and as many of the next ones as make the iteration
    // forget little: a third of the room that is left.
    void restart(const Ritz& found) {
        const Index kept = std::min(count_ + (limit_ - count_) / 3, limit_ - width_);
        const DenseMatrix combination = found.vectors.leftCols(kept);
        const DenseMatrix coupling = projected_.block(done_, coupled_, width_, done_ - coupled_) *
                                     combination.bottomRows(done_ - coupled_);
        basis_.combine(combination);
        projected_.setZero();
        projected_.diagonal().head(kept) = found.values.head(kept);
        projected_.block(kept, 0, width_, kept) = coupling;
        done_ = kept;
        coupled_ = 0;
    }

    EigenPairs pairs(const Ritz& found) const {
        const DenseMatrix chosen = found.vectors(Eigen::indexing::all, found.converged);
        EigenPairs result;
        result.values = found.values(found.converged) * scale_;
        result.vectors.resize(A_.size, chosen.cols());
        add_product(1, basis_.columns(0, done_), chosen, 0, result.vectors);
        result.converged = static_cast<Index>(found.converged.size());
        result.operations = operations_;
        return result;
    }

    const SymmetricOperator& A_;
    const EigenOptions& options_;
    Index count_;
    Index width_;
    Index limit_; // of the columns of V
    OrthonormalBasis basis_;
    DenseMatrix projected_; // T and below it C, the lower triangle
    Index done_ = 0;
    Index coupled_ = 0;  // C is zero to the left of this column
    double scale_ = 0.0; // of A; what is in projected_ has been divided by it
    double largest_ = 1.0;
    Index operations_ = 0;
    DenseMatrix next_;
    DenseMatrix image_;
};

class BlockLanczos final : public EigenSolver {
public:
    std::string name() const override { return "block-lanczos"; }

protected:
    std::int64_t usual_dimension(Index count) const override {
        return std::max(5 * std::int64_t{count} / 2, std::int64_t{count} + 8 * usual_width);
    }

    EigenPairs compute(const SymmetricOperator& A, Index count,
                       const EigenOptions& options) const override {
        const Index room = options.krylov_dimension - count;
        // a few steps must fit in between two restarts
        const Index width = std::clamp<Index>(room / 4, 1, usual_width);
        if (A.size <= dense_size || options.krylov_dimension + width > A.size)
            return dense_pairs(A, count, name());
        return Iteration(A, count, options, width).run();
    }
};

} // namespace

std::unique_ptr<EigenSolver> make_block_lanczos() {
    return std::make_unique<BlockLanczos>();
}

} // namespace polydec::builtin
