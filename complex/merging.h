// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/shared.h"
#include "complex/pieces.h"

#include <span>
#include <vector>

namespace polydec {

struct Blocks;

/// Pieces K, the complex P of the cells that they merge into, and the maps between them.
///
/// Cells of P are numbered in the order of their first pieces and oriented like them.
class Merging {
public:
    /// Merges nothing: P is K and shares its memory.
    explicit Merging(Pieces pieces);

    /// The merged complex of the blocks; d^P d^P = 0 and dia d = d^P dia hold by construction.
    /// Linear time.
    Merging(Pieces pieces, Blocks blocks);

    /// The cell of P whose interior contains an open simplex of K.
    struct Carrier {
        int dimension;
        Index cell;
    };

    /// The same cells with other pieces.
    Merging(Pieces pieces, CellComplex merged, std::vector<std::vector<Carrier>> carriers,
            std::vector<IncidenceMatrix> diamonds);

    const Pieces& pieces() const& { return pieces_; }
    const CellComplex& merged() const& { return merged_; }
    Pieces pieces() && { return pieces_; }
    CellComplex merged() && { return merged_; }

    const std::vector<Carrier>& carriers(int k) const& {
        check_number("the carriers of simplices of degree", k, 0, pieces_.dimension());
        return maps().carriers[k];
    }
    std::vector<Carrier> carriers(int k) && { return carriers(k); }

    /// dia_k, size of P times size of K: the orientation 1 or -1 of each piece s in its cell F, 0
    /// for removed simplices. Maps primal k-forms on K to P; a cochain map.
    const IncidenceMatrix& diamond(int k) const& {
        check_number("the map to merged cells in degree", k, 0, pieces_.dimension());
        return maps().diamonds[k];
    }
    IncidenceMatrix diamond(int k) && { return diamond(k); }

    /// The pieces of k-cell F, ascending. For inner loops: the cell is not checked.
    std::span<const Index> pieces_of(int k, Index cell) const& {
        const IncidenceMatrix& pieces = diamond(k);
        const Index* const begins = pieces.outerIndexPtr();
        return {pieces.innerIndexPtr() + begins[cell], pieces.innerIndexPtr() + begins[cell + 1]};
    }
    std::span<const Index> pieces_of(int k, Index cell) const&& = delete;

    /// Whether nothing is merged, so that P is K.
    bool is_identity() const { return is_identity_; }

    /// The vertices of k-cell F of P: ascending vertex numbers of the input. Throws InvalidInput if
    /// there is no such cell.
    std::vector<Index> vertices(int k, Index cell) const;

private:
    struct Maps {
        std::vector<std::vector<Carrier>> carriers;
        std::vector<IncidenceMatrix> diamonds;
    };
    const Maps& maps() const {
        return maps_->get([this] { return identity(); });
    }
    Maps identity() const;

    Pieces pieces_;
    bool is_identity_;
    Shared<const Lazy<Maps>> maps_;
    CellComplex merged_;
};

/// The corners of a merged 2-cell in the order of its boundary, as vertex numbers, starting with
/// the smallest edge. A cell glued to itself passes some corners twice. Any dimension n >= 2; time
/// O(p log p) for p pieces. Throws InvalidInput if there is no such cell.
std::vector<Index> corners(const Merging& merging, Index cell);

/// The same for any 2-cell, ignoring edges with the cell on both sides. Also throws InvalidInput
/// unless the other edges form one simple circle: if there are none, or a corner is passed twice.
std::vector<Index> corners(const CellComplex& complex, Index cell);

} // namespace polydec
