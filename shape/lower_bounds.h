// SPDX-License-Identifier: MIT
#pragma once

#include "shape/family_counter.h"

#include <optional>
#include <utility>
#include <vector>

namespace polydec {

/// Numbers s at which eigenvalues of Q(s) nearly vanish, and their vectors.
struct LowerGuesses {
    Vector values;
    DenseMatrix vectors;
};

/// Lower bounds of the smallest eigenvalues of a shape: numbers s with few negative eigenvalues of
/// Q(s). All from a count in a gap behind them where that is nearly as good; each from its own
/// count where not.
class LowerBounds {
public:
    /// Of as many eigenvalues as there are upper bounds, ascending, the first `zeros` of them 0.
    /// Vectors: the unknowns of approximate eigenvectors, as many or more. The counter must outlive
    /// this.
    LowerBounds(FamilyCounter& counter, const ShapeSpectrumOptions& options, Vector upper,
                Index zeros, DenseMatrix vectors);

    /// After a count in the gap behind the eigenvalues, and what it counted if it is trusted.
    const Vector& prove(std::optional<Index> counted);

    Index counts() const { return static_cast<Index>(counts_.size()); } ///< tried

    DenseMatrix vectors() const { return vectors_.leftCols(size()); }
    const LowerGuesses& guesses();

private:
    Index size() const { return static_cast<Index>(upper_.size()); }
    std::optional<Index> count(double s);
    void prove_by_gaps();
    void prove_below(const DenseMatrix& vectors, double share);
    void prove_each(bool are_too_large);
    bool prove_near(double guess, Index j);
    void bisect(Index j);
    void record(double s, Index most);
    double limit(Index j) const;

    FamilyCounter& counter_;
    const ShapeSpectrumOptions& options_;
    Vector upper_;
    Index zeros_;
    DenseMatrix vectors_;
    LowerGuesses guesses_;
    Vector lower_;
    std::vector<bool> good_; // bounds that others would hardly improve
    std::vector<std::pair<double, std::optional<Index>>> counts_; // s, and at most so many below
};

} // namespace polydec
