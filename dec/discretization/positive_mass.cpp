// SPDX-License-Identifier: MIT
#include "dec/discretization/positive_mass.h"

#include "base/errors.h"
#include "dec/discretization/advice.h"

#include <fmt/format.h>

namespace polydec {

void check_positive_mass(const HodgeStar& star, Side side, int degree) {
    const auto zero = star.zeros(), negative = star.negatives();
    if (zero.empty() && negative.empty())
        return;
    const auto& bad = negative.empty() ? zero : negative;
    throw InvalidInput(fmt::format("the mass of {} {}-forms is not positive: the duals of {} of {} "
                                   "{}-cells have {} volume (cells {})\n"
                                   "Spectra and decompositions need a positive mass: use dual "
                                   "0-forms, whose mass is the volumes of the cells, or {}",
                                   name(side), degree, bad.size(), star.size(), star.degree(),
                                   negative.empty() ? "zero" : "negative", star.numbers(bad),
                                   positive_stars(star.dimension())),
                       star.place(bad));
}

Definiteness laplacian_definiteness(const HodgeStars& stars, int k) {
    const auto positive = [&](int j) {
        return j < 0 || j > stars.dimension() || !stars[j].is_diagonal() ||
               (stars[j].diagonal().array() >= 0).all();
    };
    return positive(k - 1) && positive(k + 1) ? Definiteness::semidefinite
                                              : Definiteness::indefinite;
}

} // namespace polydec
