// SPDX-License-Identifier: MIT
#include "solvers/dual_fluxes.h"

#include "base/errors.h"
#include "dec/facets_without_dual.h"
#include "dec/forms/star.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

std::string with_vertices(const Discretization& discretization, Index facet) {
    const auto vertices = cell_vertices(discretization, discretization.dimension() - 1, facet);
    return fmt::format("facet {} (vertices {})", facet, fmt::join(vertices, ", "));
}

/// Dual 0-forms are functions only where every facet separates at most two cells that agree on its
/// sides.
void check_two_sided(const Discretization& discretization) {
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    if (!discretization.pieces().orientable())
        throw InvalidInput("the mesh is non-orientable, so dual 0-forms change sign around it: "
                           "solve for primal 0-forms");
    const auto& counts = complex.coface_counts(n - 1);
    const auto branching =
        std::find_if(counts.begin(), counts.end(), [](Index c) { return c > 2; });
    if (branching != counts.end())
        throw InvalidInput(fmt::format(
            "{} cells meet at {}, so the flux through it is not a difference of two values: solve "
            "for primal 0-forms",
            *branching,
            with_vertices(discretization, static_cast<Index>(branching - counts.begin()))));
}

/// What the facets oppose to a flux, times their volumes.
struct Resistances {
    Vector values;
    Vector terms; ///< sizes of what cancels in these
};

/// The dual length of each merged facet divided by the conductivity it lies in, piece by piece, as
/// resistances in series add up.
Resistances resistances(const Discretization& discretization, const Vector& conductivity) {
    const int n = discretization.dimension();
    if (conductivity.size() == 0)
        return {discretization.volumes().dual(n - 1), discretization.volumes().terms(n - 1)};
    const auto& volumes = discretization.piece_volumes();
    const SparseMatrix parts = dual_parts(discretization.pieces(), discretization.metric(), volumes,
                                          n - 1, n, discretization.options().centers);
    const SparseMatrix pieces = discretization.merging().diamond(n).cast<double>().cwiseAbs();
    const Vector of_pieces = pieces.transpose() * conductivity.cwiseInverse();
    const SparseMatrix facets = discretization.merging().diamond(n - 1).cast<double>().cwiseAbs();
    const auto over_merged = [&](const Vector& of_input_facets) -> Vector {
        return (facets * volumes.primal(n - 1).cwiseProduct(of_input_facets))
            .cwiseQuotient(discretization.volumes().primal(n - 1));
    };
    // a part is as exact as the whole dual
    Vector sums = Vector::Zero(volumes.terms(n - 1).size());
    for (Index t = 0; t < of_pieces.size(); ++t)
        for (int i = 0; i <= n; ++i)
            sums[discretization.pieces().face(n, t, i)] += of_pieces[t];
    return {over_merged(parts.transpose() * of_pieces),
            over_merged(sums.cwiseProduct(volumes.terms(n - 1)))};
}

void check_fluxes_are_defined(const Discretization& discretization,
                              const Resistances& resistances) {
    const int n = discretization.dimension();
    const auto& counts = discretization.complex().coface_counts(n - 1);
    for (const Index facet : zero_star_cells(discretization.volumes(), n - 1))
        if (counts[facet] == 2)
            throw InvalidInput(fmt::format(
                "the dual of {} has no length, so the flux through it is not defined: let "
                "cospherical cells be merged",
                with_vertices(discretization, facet)));
    for (Index facet = 0; facet < resistances.values.size(); ++facet)
        if (counts[facet] == 2 && is_zero(resistances.values[facet], resistances.terms[facet]))
            throw InvalidInput(fmt::format(
                "the two parts of the dual of {}, each over the conductivity of the cell beside "
                "it, cancel, so the flux through it is not defined: change one of the two "
                "conductivities, or take a mesh that has no obtuse angle there",
                with_vertices(discretization, facet)));
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

DualFluxes dual_fluxes(const Discretization& discretization, const CellMarks& essential,
                       const Vector& conductivity) {
    check_two_sided(discretization);
    const auto& complex = discretization.complex();
    const auto& volumes = discretization.volumes();
    const int n = complex.dimension();
    const Index cells = complex.size(n), facets = complex.size(n - 1);
    const auto without_dual = boundary_facets_without_dual(discretization);
    const auto resistance = resistances(discretization, conductivity);
    check_fluxes_are_defined(discretization, resistance);
    const IncidenceMatrix cofaces = complex.boundary(n);

    DualFluxes result{Vector::Zero(facets), std::vector<bool>(cells, false),
                      std::vector<bool>(cells, false), SparseMatrix(cells, facets),
                      SparseMatrix(cells, facets)};
    std::vector<Eigen::Triplet<double, Index>> load, fix;
    for (Index f = 0; f < facets; ++f) {
        const bool interior = complex.coface_counts(n - 1)[f] == 2;
        const Row coface(cofaces, f);
        // what flows through the natural boundary is given; nothing flows from a cell to itself
        if (!coface || (!interior && !essential[n - 1][f]))
            continue;
        const auto cell = static_cast<Index>(coface.col());
        if (without_dual[f]) {
            fix.emplace_back(cell, f, 1.0);
            result.fixed[cell] = true;
            continue;
        }
        result.weights[f] = volumes.primal(n - 1)[f] / resistance.values[f];
        if (!interior) {
            load.emplace_back(cell, f, result.weights[f]);
            result.tied[cell] = true;
        }
    }
    result.load.setFromTriplets(load.begin(), load.end());
    result.fix.setFromTriplets(fix.begin(), fix.end());
    average_rows(result.fix);
    return result;
}

} // namespace polydec
