// SPDX-License-Identifier: MIT
#include "solvers/dual_fluxes.h"

#include "base/errors.h"
#include "dec/facets_without_dual.h"
#include "dec/forms/star.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

void check_fluxes_are_defined(const CellComplex& complex, const HodgeStars& stars,
                              const FacetDuals& duals) {
    const int n = complex.dimension();
    const auto& counts = complex.coface_counts(n - 1);
    for (const Index facet : stars[n - 1].zeros())
        if (counts[facet] == 2)
            throw InvalidInput(fmt::format("the dual of {} has no length, or its parts, each over "
                                           "the conductivity beside it, cancel, so the flux "
                                           "through it is not defined: let cospherical cells be "
                                           "merged, or change one of the conductivities",
                                           duals.named(facet)),
                               duals.place(facet));
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

void check_two_sided(const CellComplex& complex, const FacetDuals& duals) {
    const int n = complex.dimension();
    const auto& counts = complex.coface_counts(n - 1);
    const auto branching =
        std::find_if(counts.begin(), counts.end(), [](Index c) { return c > 2; });
    if (branching != counts.end())
        throw InvalidInput(fmt::format("{} cells meet at {}, so the flux through it is not a "
                                       "difference of two values: solve "
                                       "for primal 0-forms",
                                       *branching,
                                       duals.named(static_cast<Index>(branching - counts.begin()))),
                           duals.place(static_cast<Index>(branching - counts.begin())));
    const Vector sums = complex.boundary(n).cast<double>() * Vector::Ones(complex.size(n)).eval();
    for (Index f = 0; f < sums.size(); ++f)
        if (counts[f] == 2 && sums[f] != 0)
            throw InvalidInput(fmt::format("the mesh is non-orientable, so dual 0-forms change "
                                           "sign around it, at {}: solve "
                                           "for primal 0-forms",
                                           duals.named(f)),
                               duals.place(f));
}

FacetDuals facet_duals(const CellComplex& complex, const HodgeStars& stars) {
    const int facets = complex.dimension() - 1;
    const CellVolumes& volumes = stars.volumes();
    FacetDuals duals;
    duals.named = [star = stars[facets]](Index f) { return "facet " + star.numbers({f}); };
    duals.place = [star = stars[facets]](Index f) { return star.place({f}); };
    if (stars[facets].is_diagonal()) {
        duals.resistances = volumes.dual(facets);
        duals.missing = boundary_facets_without_dual(complex, volumes);
    }
    return duals;
}

FacetDuals facet_duals(const Discretization& mesh) {
    const int n = mesh.dimension();
    FacetDuals duals = facet_duals(mesh.complex(), mesh.stars());
    duals.named = [mesh, n](Index facet) {
        return fmt::format("facet {} (vertices {})", facet,
                           fmt::join(cell_vertices(mesh, n - 1, facet), ", "));
    };
    duals.place = [mesh, n](Index facet) {
        return Error::Place{
            .degree = n - 1, .cells = {facet}, .vertices = cell_vertices(mesh, n - 1, facet)};
    };
    return duals;
}

namespace {

void check_resistance(double resistance, const FacetDuals& duals, Index f) {
    if (!(resistance > 0))
        throw InvalidInput(fmt::format("the dual of {}, of length {}, and 1 over the coefficient "
                                       "of Robin's condition there add up to {}: expected a "
                                       "positive sum; take a smaller coefficient or primal forms",
                                       duals.named(f), duals.resistances[f], resistance),
                           duals.place(f));
}

} // namespace

DualFluxes dual_fluxes(const CellComplex& complex, const HodgeStars& stars, const FacetDuals& duals,
                       const CellMarks& essential, const Vector& robin) {
    check_two_sided(complex, duals);
    check_fluxes_are_defined(complex, stars, duals);
    const int n = complex.dimension();
    const Index cells = complex.size(n), facets = complex.size(n - 1);
    const IncidenceMatrix cofaces = complex.boundary(n);
    const Vector& areas = stars.volumes().primal(n - 1);

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
            const double resistance = duals.resistances[f] + 1 / robin[f];
            check_resistance(resistance, duals, f);
            result.weights[f] = areas[f] / resistance;
            robin_load.emplace_back(cell, f, result.weights[f] / robin[f]);
            result.tied[cell] = true;
            continue;
        }
        if (duals.missing[f]) {
            fix.emplace_back(cell, f, 1.0);
            result.fixed[cell] = true;
            continue;
        }
        result.weights[f] = areas[f] / duals.resistances[f];
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
