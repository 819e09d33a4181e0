// SPDX-License-Identifier: MIT
#include "shape/family_counter.h"

#include "base/errors.h"
#include "base/listed.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace polydec {

std::optional<Index> FamilyCounter::at(double s) {
    if (!(s < family_.limit()))
        return std::nullopt;
    CountedMatrix Q = family_.at(s);
    if (family_.size() == 0)
        return Q.eliminated;
    const auto count = inertia_.negative(*Q.matrix, Q.doubt.sizes, Q.doubt.share);
    if (!count)
        return std::nullopt;
    counted_ = std::move(Q);
    counted_at_ = s;
    return *count + counted_.eliminated;
}

Index FamilyCounter::near(double s, Direction direction) {
    for (const double step : {0.0, 1e-12, 1e-10, 1e-8, 1e-6})
        if (const auto count = at(s * (direction == Direction::up ? 1 + step : 1 - step)))
            return *count;
    throw SolverFailure(fmt::format(
        "the eigenvalues below {:.6g} cannot be counted: rounding hides the signs of pivots; flip "
        "edges, or improve or remove cells that are much smaller or flatter than others",
        s));
}

void bound_above(CountBelow& result, const Shape& shape, FamilyCounter& lower, double s,
                 double ratio) {
    const double above = s / ratio * (1 + 1e-15), limit = lower.family().limit();
    if (above * (1 + 1e-6) < limit) {
        result.at_most = lower.near(above, Direction::up);
    } else {
        result.too_large = lower.family().beyond(above * (1 + 1e-6));
        result.warnings = {warning_of_large(shape, result.too_large, above, limit)};
    }
}

void check_level(int level) {
    if (level != 1 && level != 2)
        throw InvalidInput(fmt::format("bounds of level {}: expected 1 (linear and "
                                       "Crouzeix-Raviart) or 2 (quadratic and hybrid)",
                                       level));
}

std::string warning_of_large(const Shape& shape, const std::vector<Index>& simplices, double s,
                             double limit) {
    return fmt::format("no lower bounds of eigenvalues exist above {:.6g}, but {:.6g} is required: "
                       "{} of the {} simplices are too large ({}); divide these",
                       limit, s, simplices.size(), shape.pieces.size(shape.pieces.dimension()),
                       listed(simplices, [](Index simplex) { return std::to_string(simplex); }));
}

} // namespace polydec
