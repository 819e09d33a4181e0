// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "dec/metric/values.h"

#include <functional>
#include <memory>
#include <vector>

namespace polydec {

class CellComplex;

/// The metric of a complex: all that a Hodge star needs. Always valid: primal volumes are finite
/// and positive, dual volumes finite. An immutable handle: copies share the data and cost nothing.
class CellVolumes {
public:
    /// The numbers of the cells of one degree: see the accessors below.
    struct Degree {
        Values primal, dual;
        Bounds terms, rounding;
    };

    /// No cells: dimension -1.
    CellVolumes() : parts_(std::make_shared<Parts>()) {}

    /// One per degree 0..n, one number per cell. Throw InvalidInput, naming degree and cell, for
    /// sizes that differ, for a primal volume that is not finite and positive, and for other
    /// numbers that are not finite.
    explicit CellVolumes(std::vector<Degree> degrees);

    /// Of duals that are exact up to their last digits: terms are the duals' own sizes.
    CellVolumes(std::vector<Vector> primal, std::vector<Vector> dual);

    /// Dimension n; -1 without cells.
    int dimension() const { return static_cast<int>(parts_->degrees.size()) - 1; }

    /// Number of k-cells. The accessors below throw InvalidInput for a degree outside 0..n.
    Index size(int k) const { return degree(k).primal.size(); }

    /// All numbers of the k-cells, for innermost loops.
    const Degree& degree(int k) const& { return parts_->degrees[checked(k)]; }
    Degree degree(int k) && { return degree(k); }

    /// k-volumes |s| > 0, 1 for vertices; length^k.
    const Vector& primal(int k) const& { return degree(k).primal.vector(); }
    Vector primal(int k) && { return primal(k); }

    /// Signed (n-k)-volumes |*s|, 1 for n-cells; length^(n-k).
    const Vector& dual(int k) const& { return degree(k).dual.vector(); }
    Vector dual(int k) && { return dual(k); }

    /// Magnitude of the terms that cancel in the dual volumes, including heights of circumcenters.
    /// If the last digits of points or lengths are uncertain, errors are proportional to it (see
    /// rounding_of). length^(n-k).
    const Bounds& terms(int k) const& { return degree(k).terms; }
    Bounds terms(int k) && { return terms(k); }

    /// Error bound of |*s| / |s|, times |s|: the rounding errors of the computation for exact
    /// points. Lengths result from a computation, so their last digits count. length^(n-k).
    const Bounds& rounding(int k) const& { return degree(k).rounding; }
    Bounds rounding(int k) && { return rounding(k); }

    /// |*s| / |s|; length^(n-2k).
    Vector ratios(int k) const;

    /// The same with other duals of the k-cells, exact up to their last digits unless terms and
    /// rounding are given. Throws like the constructor.
    CellVolumes with_dual(int k, Vector dual) const;
    CellVolumes with_dual(int k, Vector dual, Vector terms, Vector rounding) const;

    /// Volumes of other cells: of(k, numbers) maps one list of numbers of the k-cells. Throws like
    /// the constructor.
    using Map = std::function<Vector(int k, const Vector& numbers)>;
    CellVolumes mapped(const Map& of) const;

    /// The same with other numbers for the cells in messages: cells of a relative complex are named
    /// by their numbers in the whole complex. One list per degree. Throws InvalidInput unless there
    /// is one number per cell.
    CellVolumes numbered(std::vector<std::vector<Index>> numbers) const;

    /// The number of a k-cell in messages: its own unless `numbered` has set another.
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
        std::vector<Degree> degrees;
        std::vector<std::vector<Index>> numbers; // empty: their own
    };
    Shared<const Parts> parts_;
};

/// Throws InvalidInput, naming the degree, unless sizes of volumes match the numbers of cells.
void check_fit(const CellComplex& complex, const CellVolumes& volumes);

} // namespace polydec
