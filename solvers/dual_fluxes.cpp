// SPDX-License-Identifier: MIT
#include "solvers/dual_fluxes.h"

#include "base/errors.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

void check_fluxes_are_defined(const Cells& cells) {
    const int n = cells.dimension();
    const auto& counts = cells.complex().coface_counts(n - 1);
    for (const Index facet : cells.stars()[n - 1].zeros())
        if (counts[facet] == 2)
            throw InvalidInput(fmt::format("the dual of {} has no length, or its parts, each over "
                                           "the conductivity beside it, cancel, so the flux "
                                           "through it is not defined: let cospherical cells be "
                                           "merged, or change one of the conductivities",
                                           cells.name(n - 1, facet)),
                               cells.place(n - 1, facet));
}

/// The rows scaled to sum 1: several such facets of one cell meet at its circumcenter.
void average_rows(SparseMatrix& matrix) {
    for (Index row = 0; row < matrix.rows(); ++row) {
        const double sum = matrix.row(row).sum();
        for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
            entry.valueRef() /= sum;
    }
}

} // namespace

void check_two_sided(const Cells& cells) {
    const CellComplex& complex = cells.complex();
    const int n = complex.dimension();
    const auto& counts = complex.coface_counts(n - 1);
    const auto branching =
        std::find_if(counts.begin(), counts.end(), [](Index c) { return c > 2; });
    if (branching != counts.end())
        throw InvalidInput(fmt::format("{} cells meet at {}, so the flux through it is not a "
                                       "difference of two values: solve "
                                       "for primal 0-forms",
                                       *branching, cells.name(n - 1, branching - counts.begin())),
                           cells.place(n - 1, branching - counts.begin()));
    const Vector sums = complex.boundary(n).cast<double>() * Vector::Ones(complex.size(n)).eval();
    for (Index f = 0; f < sums.size(); ++f)
        if (counts[f] == 2 && sums[f] != 0)
            throw InvalidInput(fmt::format("the mesh is non-orientable, so dual 0-forms change "
                                           "sign around it, at {}: solve "
                                           "for primal 0-forms",
                                           cells.name(n - 1, f)),
                               cells.place(n - 1, f));
}

namespace {

void check_resistance(const Cells& cells, double resistance, double length, Index f) {
    const int facets = cells.dimension() - 1;
    if (!(resistance > 0))
        throw InvalidInput(fmt::format("the dual of {}, of length {}, and 1 over the coefficient "
                                       "of Robin's condition there add up to {}: expected a "
                                       "positive sum; take a smaller coefficient or primal forms",
                                       cells.name(facets, f), length, resistance),
                           cells.place(facets, f));
}

} // namespace

DualFluxes dual_fluxes(const Cells& on, const CellMarks& essential, const Vector& robin) {
    check_two_sided(on);
    check_fluxes_are_defined(on);
    const CellComplex& complex = on.complex();
    const CellVolumes& volumes = on.stars().volumes();
    const int n = complex.dimension();
    const Vector& lengths = volumes.dual(n - 1);
    const std::vector<bool> missing = on.boundary_facets_without_dual();
    const Index cells = complex.size(n), facets = complex.size(n - 1);
    const IncidenceMatrix cofaces = complex.boundary(n);
    const Vector& areas = volumes.primal(n - 1);

    DualFluxes result{Vector::Zero(facets),
                      std::vector<bool>(cells, false),
                      std::vector<bool>(cells, false),
                      SparseMatrix(cells, facets),
                      SparseMatrix(cells, facets),
                      SparseMatrix(cells, facets)};
    std::vector<Eigen::Triplet<double, Index>> load, fix, robin_load;
    for (Index f = 0; f < facets; ++f) {
        const bool interior = complex.coface_counts(n - 1)[f] == 2;
        const Row coface(cofaces, f);
        // what flows through the natural boundary is given; nothing flows from a cell to itself
        if (!coface || (!interior && !essential[n - 1][f] && robin[f] == 0))
            continue;
        const auto cell = static_cast<Index>(coface.col());
        if (robin[f] > 0) {
            const double resistance = lengths[f] + 1 / robin[f];
            check_resistance(on, resistance, lengths[f], f);
            result.weights[f] = areas[f] / resistance;
            robin_load.emplace_back(cell, f, result.weights[f] / robin[f]);
            result.tied[cell] = true;
            continue;
        }
        if (missing[f]) {
            fix.emplace_back(cell, f, 1.0);
            result.fixed[cell] = true;
            continue;
        }
        result.weights[f] = areas[f] / lengths[f];
        if (!interior) {
            load.emplace_back(cell, f, result.weights[f]);
            result.tied[cell] = true;
        }
    }
    result.load.setFromTriplets(load.begin(), load.end());
    result.fix.setFromTriplets(fix.begin(), fix.end());
    result.robin_load.setFromTriplets(robin_load.begin(), robin_load.end());
    average_rows(result.fix);
    return result;
}

} // namespace polydec
