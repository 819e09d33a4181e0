// SPDX-License-Identifier: MIT
#include "solvers/spectra/positive_mass.h"

#include "base/errors.h"
#include "dec/advice.h"
#include "dec/forms/star.h"

#include <fmt/format.h>

namespace polydec {

void check_positive_mass(const CellVolumes& volumes, Side side, int degree, int k) {
    const auto zero = zero_star_cells(volumes, k), negative = negative_star_cells(volumes, k);
    if (zero.empty() && negative.empty())
        return;
    const auto& bad = negative.empty() ? zero : negative;
    throw InvalidInput(
        fmt::format("the mass of {} {}-forms is not positive: the duals of {} of {} {}-cells have "
                    "{} volume (cells {})\nspectra and decompositions need a positive mass: take "
                    "dual 0-forms, whose mass are the volumes of the cells, or {}",
                    name(side), degree, bad.size(), volumes.primal(k).size(), k,
                    negative.empty() ? "zero" : "negative", numbers_of(volumes, k, bad),
                    nearer_to_delaunay(volumes)),
        {.degree = k, .cells = volumes.numbers(k, bad)});
}

Definiteness laplacian_definiteness(const CellVolumes& volumes, int k) {
    const auto positive = [&](int j) {
        return j < 0 || j > volumes.dimension() || (volumes.dual(j).array() >= 0).all();
    };
    return positive(k - 1) && positive(k + 1) ? Definiteness::semidefinite
                                              : Definiteness::indefinite;
}

} // namespace polydec
