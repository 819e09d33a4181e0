// SPDX-License-Identifier: MIT
#include "dec/boundary/two_sided.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

constexpr Index none = -1;

/// The first facet with more than two cofaces.
Index branching_facet(const CellComplex& complex) {
    const auto& counts = complex.coface_counts(complex.dimension() - 1);
    const auto found = std::find_if(counts.begin(), counts.end(), [](Index c) { return c > 2; });
    return found == counts.end() ? none : static_cast<Index>(found - counts.begin());
}

/// The first facet with two cofaces on the same side of it.
Index clashing_facet(const CellComplex& complex) {
    const int n = complex.dimension();
    const auto& counts = complex.coface_counts(n - 1);
    const Vector sums = complex.boundary(n).cast<double>() * Vector::Ones(complex.size(n)).eval();
    for (Index f = 0; f < sums.size(); ++f)
        if (counts[f] == 2 && sums[f] != 0)
            return f;
    return none;
}

} // namespace

bool is_two_sided(const CellComplex& complex) {
    return branching_facet(complex) == none && clashing_facet(complex) == none;
}

void check_not_branching(const Cells& cells) {
    const int facets = cells.dimension() - 1;
    if (const Index f = branching_facet(cells.complex()); f != none)
        throw InvalidInput(
            fmt::format("{} cells meet at {}, so the flux through it is not a difference of two "
                        "values of a dual 0-form: use primal 0-forms",
                        cells.complex().coface_counts(facets)[f], cells.name(facets, f)),
            cells.place(facets, f));
}

void check_two_sided(const Cells& cells) {
    check_not_branching(cells);
    const int facets = cells.dimension() - 1;
    if (const Index f = clashing_facet(cells.complex()); f != none)
        throw InvalidInput(fmt::format("the mesh is non-orientable, so dual 0-forms change sign "
                                       "around it, at {}: use primal 0-forms",
                                       cells.name(facets, f)),
                           cells.place(facets, f));
}

} // namespace polydec
