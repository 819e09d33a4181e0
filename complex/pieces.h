// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "complex/cell_complex.h"

#include <span>
#include <utility>

namespace polydec {

/// The faces of k-simplices, for innermost loops: nothing is checked.
class FaceTable {
public:
    FaceTable(const Index* faces, int k, bool last_first)
        : faces_(faces + (last_first ? k : 0)), width_(k + 1), step_(last_first ? -1 : 1) {}

    /// The face of simplex s that lacks its corner number `omitted`.
    Index operator()(Index s, int omitted) const {
        return faces_[std::ptrdiff_t(s) * width_ + std::ptrdiff_t(step_) * omitted];
    }

private:
    const Index* faces_;
    int width_, step_;
};

/// Ordered simplices glued along their faces in any way, to be measured and merged. The corners of
/// every simplex are ordered, and faces keep the order: an ordered Delta-complex. So a face that
/// lacks corner i has the sign (-1)^i. Several simplices may have the same corners, an edge may be
/// a loop, and a simplex may have a face twice; in a simplicial complex none of this happens.
/// Source: Hatcher, Algebraic Topology, section 2.1.
///
/// k-simplices, k < n, are oriented by the order of their corners; n-simplices have their own
/// orientation relative to it. Where loops are possible, traverse the faces, not the rows of d_k,
/// in which a repeated face may cancel. A handle, like every CellComplex.
class Pieces : public CellComplex {
public:
    /// Glues simplices. faces[k - 1], k = 1..n, has one row per k-simplex, with the face that lacks
    /// corner i in column i; vertices[v] names 0-simplex v in messages and files. Orientations of
    /// the n-simplices, 1 or -1, are coherent if they are so across every facet with two cofaces.
    /// Linear time, except for ordering each simplex's faces.
    /// Throws InvalidInput, naming the simplex, for tables that do not fit or faces of faces that
    /// disagree.
    Pieces(std::vector<Simplices> faces, std::vector<std::int8_t> orientations,
           std::vector<Index> vertices);

    /// From simplices in lexicographic order, with the face that lacks the last corner first in the
    /// rows of d_k. vertex_numbers as above, or empty: 0, 1, 2, ..
    Pieces(Unchecked, CellComplex cells, std::vector<std::shared_ptr<const Simplices>> simplices,
           std::shared_ptr<const Incidences::Signs> orientations, bool orientable,
           std::vector<Index> vertex_numbers);

    /// The same simplices of a simplicial complex with other orientations of the n-simplices.
    Pieces with_orientations(std::vector<std::int8_t> orientations, bool orientable) const;

    /// The corners, which are 0-simplices, in order: size(k) x (k+1).
    const Simplices& simplices(int k) const& {
        check_number("the table of simplices of degree", k, 0, dimension());
        return *parts_->simplices[k];
    }
    Simplices simplices(int k) && { return simplices(k); }

    /// The number of 0-simplex v in messages and files. Not checked.
    Index vertex_number(Index v) const {
        return parts_->vertex_numbers.empty() ? v : parts_->vertex_numbers[v];
    }

    /// The same for several, and for the corners of k-simplex s.
    std::vector<Index> vertex_numbers(std::vector<Index> vertices) const;
    std::vector<Index> vertex_numbers(int k, Index s) const;

    /// The faces of the k-simplices, k >= 1; valid as long as a handle on this complex.
    FaceTable faces(int k) const {
        check_number("a face of a simplex of degree", k, 1, dimension());
        const bool own = !parts_->faces.empty();
        return {own ? parts_->faces[k].data() : incidences(k - 1).table(), k, !own};
    }

    /// The face of k-simplex s, k >= 1, that lacks its corner number `omitted`, 0..k. For inner
    /// loops: s and omitted are not checked.
    Index face(int k, Index s, int omitted) const { return faces(k)(s, omitted); }

    /// Orientation of n-simplex s relative to the order of its corners: 1 or -1.
    int orientation(Index s) const {
        check_number("the orientation of simplex", s, 0, size(dimension()) - 1);
        return (*parts_->orientations)[s];
    }

    /// The sign of the face of k-simplex s that lacks corner number `omitted`. Not checked.
    int sign(int k, Index s, int omitted) const {
        const int of_position = omitted % 2 == 0 ? 1 : -1;
        const bool is_top = k == static_cast<int>(parts_->simplices.size()) - 1;
        return is_top ? of_position * (*parts_->orientations)[s] : of_position;
    }

    /// Whether these are the simplices of a simplicial complex, so that the points at their corners
    /// determine them.
    bool is_simplicial() const { return parts_->faces.empty(); }

    /// Whether the n-simplices are oriented coherently across facets with two cofaces.
    bool orientable() const { return parts_->orientable; }

private:
    struct Parts {
        std::vector<std::shared_ptr<const Simplices>> simplices; // of degree k
        std::vector<Simplices> faces; // of degree k; if empty, the faces are in the incidences
        std::shared_ptr<const Incidences::Signs> orientations;
        bool orientable = true;
        std::vector<Index> vertex_numbers = {}; // empty: 0, 1, 2, ..
    };
    Pieces(CellComplex cells, std::shared_ptr<const Parts> parts)
        : CellComplex(cells), parts_(std::move(parts)) {}
    static Pieces glued(std::vector<Simplices> faces, std::vector<std::int8_t> orientations,
                        std::vector<Index> vertices);

    Shared<const Parts> parts_;
};

/// A simplex around one of its faces.
struct Coface {
    Index cell;
    int omitted; ///< the corner of the cell that the face lacks
};

/// The k-simplices around each (k-1)-simplex, ascending, with multiplicity.
class Cofaces {
public:
    Cofaces(const Pieces& pieces, int k);

    std::span<const Coface> of(Index face) const {
        return {cofaces_.data() + begins_[face], cofaces_.data() + begins_[face + 1]};
    }

private:
    std::vector<Index> begins_;
    std::vector<Coface> cofaces_;
};

} // namespace polydec
