// SPDX-License-Identifier: MIT
#include "solvers/flow/flow_spaces.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/forms/cochain.h"

#include <fmt/format.h>

namespace polydec {

namespace {

bool has_flux(FlowBoundary kind) {
    return kind == FlowBoundary::free_slip || kind == FlowBoundary::no_slip;
}

bool has_vorticity(FlowBoundary kind) {
    return kind == FlowBoundary::no_slip || kind == FlowBoundary::pressure;
}

void check_conditions(const CellComplex& complex, const std::vector<FlowBoundary>& facets) {
    const int n = complex.dimension();
    check_number("the dimension of a flow", n, 2, 1000);
    if (!facets.empty())
        check_as_many("conditions of facets", std::ssize(facets), complex.size(n - 1));
}

/// The primal forms of this degree that are fixed on facets of these kinds.
FormSpace fixed_on(const Cells& cells, int degree, FlowBoundary everywhere,
                   const std::vector<FlowBoundary>& facets, bool (*is_fixed)(FlowBoundary)) {
    std::vector<bool> marks(static_cast<std::size_t>(cells.size(cells.dimension() - 1)),
                            is_fixed(everywhere));
    for (std::size_t f = 0; f < facets.size(); ++f)
        marks[f] = is_fixed(facets[f]);
    return {cells, Side::primal, degree,
            BoundaryConditions(BoundaryCondition::natural).essential(marks)};
}

} // namespace

FlowSpaces::FlowSpaces(const Cells& cells, FlowBoundary everywhere,
                       const std::vector<FlowBoundary>& facets)
    : flux((check_conditions(cells.complex(), facets),
            fixed_on(cells, cells.dimension() - 1, everywhere, facets, has_flux))),
      vorticity(fixed_on(cells, cells.dimension() - 2, everywhere, facets,
                         [](FlowBoundary kind) { return !has_vorticity(kind); })),
      divergence(derivative(flux.relative().complex, cells.dimension() - 1)),
      tied(static_cast<std::size_t>(cells.size(cells.dimension())), false) {
    for (const BoundaryFacet& on : boundary_facets(cells.complex())) {
        const FlowBoundary kind = facets.empty() ? everywhere : facets[on.facet];
        if (has_vorticity(kind))
            dragged.push_back(on);
        if (has_flux(kind))
            continue;
        open.push_back(on);
        tied[on.cell] = true;
    }
    loose = FreeComponents(divergence.transpose(), std::vector<bool>(tied.size(), false), tied,
                           cells.stars().volumes().primal(cells.dimension()));
}

void FlowSpaces::check_balance(const Vector& of) const {
    constexpr double rounding = 1e-10;
    const Cells cells = flux.cells();
    Vector out = derivative(cells.complex(), cells.dimension() - 1) * of;
    const Compatibility found = loose.balance(out);
    if (found.worst > rounding)
        throw InvalidInput(
            fmt::format("the net outflow through the boundary of a component is {:.6g}, {:.3g} of "
                        "the total flux: expected 0, or an open facet",
                        found.excess, found.worst));
}

} // namespace polydec
