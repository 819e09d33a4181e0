// SPDX-License-Identifier: MIT
#pragma once

#include "shape/forms.h"
#include "shape/shape_spectrum.h"

#include <string>

namespace polydec {

/// The safe direction to move s if a count cannot be trusted; counts are monotone in s.
enum class Direction { down, up };

/// Counts negative eigenvalues of Q(s), for one s after the other.
class FamilyCounter {
public:
    /// The family must outlive this.
    FamilyCounter(const FormFamily& family, const std::string& engine)
        : family_(family), inertia_(engine, family.domain_dimension()) {}

    const FormFamily& family() const { return family_; }

    /// If the count can be trusted and s is below the limit of the family.
    std::optional<Index> at(double s);

    /// Or, if it is not, at an s moved by at most 1e-6 of s. Throws SolverFailure if no count can
    /// be trusted.
    Index near(double s, Direction direction);

    /// Q of the last trusted count, its s, and Q^-1 X.
    const CountedMatrix& counted() const { return counted_; }
    double counted_at() const { return counted_at_; }
    DenseMatrix solve(const DenseMatrix& X) const { return inertia_.solve(X); }

private:
    const FormFamily& family_;
    TrustedInertia inertia_;
    CountedMatrix counted_;
    double counted_at_ = 0;
};

/// Sets what bounds the number of eigenvalues of a shape below s from above, and the warnings if
/// nothing does; `ratio` as in metric_ratio.
void bound_above(CountBelow& result, const Shape& shape, FamilyCounter& lower, double s,
                 double ratio);

/// Throws InvalidInput unless the level is 1 or 2.
void check_level(int level);

/// A warning that these simplices limit bounds to below `limit`, where s was requested.
std::string warning_of_large(const Shape& shape, const std::vector<Index>& simplices, double s,
                             double limit);

} // namespace polydec
