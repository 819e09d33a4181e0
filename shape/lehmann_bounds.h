// SPDX-License-Identifier: MIT
#pragma once

#include "shape/family_counter.h"

#include <optional>

namespace polydec {

/// Bounds on the numbers of negative eigenvalues of Q(s) for all s below t, from a count at t alone
/// and Rayleigh quotients of A^-1 P (Lehmann 1949), with A = Q(t) and a sum P of positive definite
/// forms of simplices, at most Q(s) - Q(t). Proof: docs/what-is-proved.md.
class LehmannBounds {
public:
    /// After a trusted count at t. X: approximate eigenvectors, as many as Q(t) has negative
    /// eigenvalues. Bounds are best for s about `near` < t.
    LehmannBounds(const FamilyCounter& counter, double near, const DenseMatrix& X);

    /// As many eigenvalues of Q(s) are negative, for s < t, as entries of `most` are at least 1, or
    /// fewer. Other vectors would give the same for entries of `least`, or more. Both descend; each
    /// entry is about inversely proportional to t - s.
    struct Ratios {
        Vector most, least;
    };

    /// Nothing if the vectors, or rounding, admit no proof.
    std::optional<Ratios> ratios(double s) const;

private:
    using Columns = Eigen::Block<DenseMatrix, Eigen::Dynamic, Eigen::Dynamic, true>;
    Columns part(DenseMatrix& of, Index simplex) const {
        return of.middleCols(Eigen::Index(rows_) * simplex, rows_);
    }

    const FormFamily& family_;
    double t_;
    Index rows_ = 0;     // unknowns of a simplex and its cell
    DenseMatrix doubts_; // of A, a column for each simplex
    // the rows are those of trial vectors z, in the unknowns of one simplex after the other
    DenseMatrix vectors_;  // z
    DenseMatrix residues_; // A z, a sum over simplices
    DenseMatrix energies_; // - z^T A z; empty: no bounds
};

} // namespace polydec
