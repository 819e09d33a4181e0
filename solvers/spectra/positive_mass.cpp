// SPDX-License-Identifier: MIT
#include "solvers/spectra/positive_mass.h"

#include "base/errors.h"
#include "dec/forms/star.h"

#include <fmt/format.h>

namespace polydec {

void check_positive_mass(const CellVolumes& volumes, Side side, int degree, int k) {
    const auto zero = zero_star_cells(volumes, k), negative = negative_star_cells(volumes, k);
    if (zero.empty() && negative.empty())
        return;
    // what flips and splits of edges can do, they do for surfaces
    const char* const surface_advice =
        volumes.dimension() == 2
            ? ": on a manifold intrinsic flips make it so (Delaunay::flips_and_splits)"
            : "";
    const auto& bad = negative.empty() ? zero : negative;
    throw InvalidInput(fmt::format(
        "the mass of {} {}-forms is not positive: the duals of {} of {} {}-cells have {} volume "
        "(cells {})\nspectra and decompositions need a positive mass: take dual 0-forms, whose "
        "mass are the volumes of the cells, or a mesh that is nearer to Delaunay there{}",
        name(side), degree, bad.size(), volumes.primal(k).size(), k,
        negative.empty() ? "zero" : "negative", numbers_of(volumes, k, bad), surface_advice));
}

} // namespace polydec
