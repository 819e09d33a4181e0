// SPDX-License-Identifier: MIT
#include "complex/cell_complex.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace polydec {

namespace {

void check_shapes(const std::vector<IncidenceMatrix>& d) {
    if (d.empty())
        throw InvalidInput("a cell complex needs at least d_0: expected dimension 1 or more");
    for (std::size_t k = 0; k + 1 < d.size(); ++k) {
        if (d[k].rows() != d[k + 1].cols())
            throw InvalidInput(fmt::format(
                "d_{} has {} rows but d_{} has {} columns: both must be the number of {}-cells", k,
                d[k].rows(), k + 1, d[k + 1].cols(), k + 1));
    }
}

/// Throws, naming the cells, unless upper * lower = 0.
void check_product(const IncidenceMatrix& upper, const IncidenceMatrix& lower, std::size_t k) {
    std::vector<int> sum(static_cast<std::size_t>(lower.cols()), 0);
    for (Index t = 0; t < upper.rows(); ++t) {
        for (IncidenceMatrix::InnerIterator f(upper, t); f; ++f)
            for (IncidenceMatrix::InnerIterator s(lower, f.col()); s; ++s)
                sum[s.col()] += f.value() * s.value();
        for (IncidenceMatrix::InnerIterator f(upper, t); f; ++f)
            for (IncidenceMatrix::InnerIterator s(lower, f.col()); s; ++s)
                if (sum[s.col()] != 0)
                    throw InvalidInput(
                        fmt::format(
                            "d_{} d_{} is {} instead of 0 from {}-cell {} to {}-cell {}: the faces "
                            "of the second cell do not close up; check their signs",
                            k + 1, k, sum[s.col()], k, s.col(), k + 2, t),
                        {.degree = static_cast<int>(k) + 2, .cells = {static_cast<Index>(t)}});
    }
}

void check_canceled(const std::vector<IncidenceMatrix>& d,
                    const std::vector<std::vector<Incidence>>& canceled) {
    if (canceled.size() > d.size())
        throw InvalidInput(
            fmt::format("canceling incidences are given for {} coboundaries: expected at most {}",
                        canceled.size(), d.size()));
    for (std::size_t k = 0; k < canceled.size(); ++k)
        for (const auto& [cell, face] : canceled[k])
            if (cell < 0 || cell >= d[k].rows() || face < 0 || face >= d[k].cols() ||
                d[k].coeff(cell, face) != 0)
                throw InvalidInput(
                    fmt::format("{}-cell {} and {}-cell {} cannot cancel in d_{}: expected two "
                                "cells of the complex whose entry there is 0",
                                k + 1, cell, k, face, k),
                    {.degree = static_cast<int>(k) + 1, .cells = {cell}});
}

/// An incidence that cancels stands for both sides of its face.
CofaceCounts count_cofaces(const IncidenceMatrix& D, const std::vector<Incidence>& canceled) {
    std::vector<Index> counts(static_cast<std::size_t>(D.cols()), 0);
    for (Index t = 0; t < D.rows(); ++t)
        for (IncidenceMatrix::InnerIterator s(D, t); s; ++s)
            counts[s.col()] += std::abs(s.value());
    for (const auto& incidence : canceled)
        counts[incidence.face] += 2;
    return counts;
}

/// Between cells and those of a degree of which there are none.
Incidences no_incidences(Index cells, Index faces) {
    return {std::make_shared<const Simplices>(cells, 0), faces};
}

} // namespace

CellComplex::CellComplex(std::vector<IncidenceMatrix> coboundaries,
                         std::vector<std::vector<Incidence>> canceled) {
    check_shapes(coboundaries);
    check_canceled(coboundaries, canceled);
    for (auto& D : coboundaries)
        D.prune([](Index, Index, std::int8_t value) { return value != 0; });
    for (std::size_t k = 0; k + 1 < coboundaries.size(); ++k)
        check_product(coboundaries[k + 1], coboundaries[k], k);
    canceled.resize(coboundaries.size());
    std::vector<Coboundary> tower;
    for (std::size_t k = 0; k < coboundaries.size(); ++k) {
        const CofaceCounts counts = count_cofaces(coboundaries[k], canceled[k]);
        tower.push_back({Incidences(std::move(coboundaries[k])), counts, std::move(canceled[k])});
    }
    *this = CellComplex(Unchecked{}, std::move(tower));
}

CellComplex::CellComplex(Unchecked, std::vector<Coboundary> coboundaries) {
    const Index vertices = coboundaries.front().incidences.cols();
    const Index tops = coboundaries.back().incidences.rows();
    coboundaries.insert(coboundaries.begin(), Coboundary{no_incidences(vertices, 0), {}});
    coboundaries.push_back({no_incidences(0, tops), CofaceCounts(std::size_t(tops))});
    tower_ = std::make_shared<const std::vector<Coboundary>>(std::move(coboundaries));
}

void CellComplex::refuse_degree(int k) const {
    throw InvalidInput(
        fmt::format("coboundary {} does not exist in a complex of dimension {}: expected -1 to {}",
                    k, dimension(), dimension()));
}

Index euler_characteristic(const CellComplex& complex) {
    Index sum = 0;
    for (int k = 0; k <= complex.dimension(); ++k)
        sum += (k % 2 == 0 ? 1 : -1) * complex.size(k);
    return sum;
}

} // namespace polydec
