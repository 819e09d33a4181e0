// SPDX-License-Identifier: MIT
#include "shape/trusted_count.h"

#include "base/errors.h"
#include "base/listed.h"

#include <fmt/format.h>

#include <string>

namespace polydec {

Index trusted_count(const FormFamily& family, double s, Direction direction,
                    const std::string& engine, int domain_dimension) {
    for (const double step : {0.0, 1e-12, 1e-10, 1e-8, 1e-6}) {
        const double at = s * (direction == Direction::up ? 1 + step : 1 - step);
        if (const auto count = negative_eigenvalues(family, at, engine, domain_dimension))
            return *count;
    }
    throw SolverFailure(fmt::format(
        "the eigenvalues below {:.6g} cannot be counted: rounding hides the signs of pivots; flip "
        "edges, or improve or remove cells that are much smaller or flatter than others",
        s));
}

CountBelow enclosed_count(const Shape& shape, const FormFamily& conforming, const FormFamily& lower,
                          double s, double ratio, const std::string& engine) {
    const int n = shape.pieces.dimension();
    CountBelow result;
    result.at_least = trusted_count(conforming, s * ratio, Direction::down, engine, n);
    const double above = s / ratio * (1 + 1e-15);
    if (above * (1 + 1e-6) < lower.limit()) {
        result.at_most = trusted_count(lower, above, Direction::up, engine, n);
    } else {
        result.too_large = lower.beyond(above * (1 + 1e-6));
        result.warnings = {warning_of_large(shape, result.too_large, above, lower.limit())};
    }
    return result;
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
