// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/values.h"

#include <memory>
#include <vector>

namespace polydec {

class CellComplex;

/// The metric of a complex: all that a Hodge star needs. Is whole from the start: every primal
/// volume is a finite number above 0, every dual volume a finite one. A handle on what never
/// changes: copies share it and cost nothing.
class CellVolumes {
public:
    /// Of no cells; no degree can be asked for.
    CellVolumes() : parts_(std::make_shared<Parts>()) {}

    // no moves, which would leave a handle on nothing
    CellVolumes(const CellVolumes&) = default;
    CellVolumes& operator=(const CellVolumes&) = default;

    /// One vector per degree 0..n, a number per cell. Without terms the duals are taken as they
    /// are: terms are their own sizes, and nothing but their last digits is lost by rounding.
    /// Throws InvalidInput, naming degree and cell, for sizes that differ, a primal volume that is
    /// not a finite number above 0, and others that are not finite.
    CellVolumes(std::vector<Vector> primal, std::vector<Vector> dual,
                std::vector<Vector> terms = {}, std::vector<Vector> rounding = {});
    CellVolumes(std::vector<Values> primal, std::vector<Values> dual, std::vector<Bounds> terms,
                std::vector<Bounds> rounding);

    /// Dimension n; -1 without cells.
    int dimension() const { return static_cast<int>(parts_->primal.size()) - 1; }

    /// Number of k-cells. These accessors throw InvalidInput for another degree than 0..n.
    Index size(int k) const { return parts_->primal[checked(k)].size(); }

    /// k-volumes |s| > 0, 1 for vertices; length^k.
    const Vector& primal(int k) const& { return parts_->primal[checked(k)].vector(); }
    Vector primal(int k) && { return primal(k); }

    /// Signed (n-k)-volumes |*s|, 1 for n-cells; length^(n-k).
    const Vector& dual(int k) const& { return parts_->dual[checked(k)].vector(); }
    Vector dual(int k) && { return dual(k); }

    /// Sizes of what cancels in the dual volumes, in heights of circumcenters too: to these their
    /// errors are in proportion (see rounding_of) if the last digits of points or lengths are not
    /// known. length^(n-k).
    const Bounds& terms(int k) const& { return parts_->terms[checked(k)]; }
    Bounds terms(int k) && { return terms(k); }

    /// How far |*s| / |s| may be off, times |s|: what computing has done if points are exact.
    /// Lengths have been computed, so their last digits count. length^(n-k).
    const Bounds& rounding(int k) const& { return parts_->rounding[checked(k)]; }
    Bounds rounding(int k) && { return rounding(k); }

    /// |*s| / |s|; length^(n-2k).
    Vector ratios(int k) const;

    /// The same with other duals of the k-cells, taken as they are unless terms and rounding go
    /// with them. Throws like the constructor.
    CellVolumes with_dual(int k, Vector dual) const;
    CellVolumes with_dual(int k, Vector dual, Vector terms, Vector rounding) const;

    /// The same with other numbers for the cells, by which messages name them: those of a relative
    /// complex go by their numbers in the whole one. One list per degree. Throws InvalidInput
    /// unless there is a number for each cell.
    CellVolumes numbered(std::vector<std::vector<Index>> numbers) const;

    /// The number by which messages name a k-cell of these: its own, unless others are given.
    Index number(int k, Index cell) const {
        return parts_->numbers.empty() ? cell : parts_->numbers[checked(k)][cell];
    }
    std::vector<Index> numbers(int k, std::vector<Index> cells) const {
        for (Index& cell : cells)
            cell = number(k, cell);
        return cells;
    }

private:
    std::size_t checked(int k) const {
        if (k < 0 || k > dimension())
            refuse_degree(k);
        return static_cast<std::size_t>(k);
    }
    [[noreturn]] void refuse_degree(int k) const;
    void check(int k) const;

    struct Parts {
        std::vector<Values> primal, dual;
        std::vector<Bounds> terms, rounding;
        std::vector<std::vector<Index>> numbers; // empty: their own
    };
    std::shared_ptr<const Parts> parts_;
};

/// Throws InvalidInput, naming the degree, unless the volumes are those of as many cells.
void check_fit(const CellComplex& complex, const CellVolumes& volumes);

} // namespace polydec
