// SPDX-License-Identifier: MIT
#pragma once

#include "base/checks.h"
#include "base/shared.h"
#include "base/types.h"
#include "complex/coface_counts.h"
#include "complex/incidences.h"

#include <vector>

namespace polydec {

/// A cell and one of its faces.
struct Incidence {
    Index cell, face;
};

/// The (k+1)-cells of a complex with the k-cells that bound them.
struct Coboundary {
    Incidences incidences;                ///< the entries of d_k
    CofaceCounts coface_counts;           ///< of the k-cells; with multiplicity
    std::vector<Incidence> canceled = {}; ///< that are missing in d_k, see CellComplex::canceled
};

/// A finite complex of oriented cells of degrees 0..n (simplices, merged polytopes, cubes or custom
/// cells), given by its signed incidence matrices; it knows no lengths. An immutable handle: copies
/// share the data and cost nothing. Every member with a degree throws InvalidInput for a degree out
/// of range. Members of a temporary return values instead of references.
class CellComplex {
public:
    /// Tag for constructors from data that satisfy d d = 0 by construction.
    struct Unchecked {};

    /// The complex with coboundaries d_0, .., d_(n-1), n >= 1; d_k is size(k+1) x size(k).
    /// canceled[k], k < n, lists the (k+1)-cells and faces that are missing in d_k because both
    /// sides of the face cancel, such as a loop and its vertex; without them the loop would have no
    /// end. Throws InvalidInput, naming the cells, if shapes do not fit or d_(k+1) d_k is not zero.
    explicit CellComplex(std::vector<IncidenceMatrix> coboundaries,
                         std::vector<std::vector<Incidence>> canceled = {});

    /// As above without the checks.
    CellComplex(Unchecked, std::vector<Coboundary> coboundaries);

    int dimension() const { return static_cast<int>(tower_->size()) - 2; }

    /// Number of cells of degree k; 0 outside 0..n.
    Index size(int k) const {
        return k < 0 || k > dimension() ? 0 : static_cast<Index>(at(k).coface_counts.size());
    }

    /// The (k+1)-cells with the k-cells that bound them, for k = -1..n: the entries of d_k in their
    /// stored form. There are no cells of degrees -1 and n+1.
    const Incidences& incidences(int k) const& {
        if (k < -1 || k > dimension())
            refuse_degree(k);
        return at(k).incidences;
    }
    Incidences incidences(int k) && { return incidences(k); }

    /// d_k, size(k+1) x size(k), entries -1, 0, 1 (2 on one-sided surfaces), for k = -1..n: the
    /// first and last are 0-column and 0-row matrices. For simplices it is computed on first use,
    /// and kept.
    const IncidenceMatrix& coboundary(int k) const& { return incidences(k).matrix(); }
    IncidenceMatrix coboundary(int k) && { return coboundary(k); }

    /// Boundary matrix of the k-cells, size(k-1) x size(k): the transpose of d_(k-1). Row s lists
    /// the cofaces of s. Recomputed at each call, in linear time.
    IncidenceMatrix boundary(int k) const { return incidences(k - 1).transposed(); }

    /// Number of (k+1)-cells around each k-cell. It cannot be read off d_k, where a cell on both
    /// sides of s cancels. All zero for k = n.
    const CofaceCounts& coface_counts(int k) const& {
        check_number("the number of cofaces in degree", k, 0, dimension());
        return at(k).coface_counts;
    }
    CofaceCounts coface_counts(int k) && { return coface_counts(k); }

    /// The (k+1)-cells and k-cells on their boundary without an entry in d_k, because both sides of
    /// the face cancel: a loop and its vertex, a cone and the edge along which it is closed. To
    /// find all faces of a cell, use these in addition to the rows of d_k, 0 <= k < n.
    const std::vector<Incidence>& canceled(int k) const& {
        check_number("the incidences that cancel in the coboundary", k, 0, dimension() - 1);
        return at(k).canceled;
    }
    std::vector<Incidence> canceled(int k) && { return canceled(k); }

private:
    const Coboundary& at(int k) const { return (*tower_)[k + 1]; }
    [[noreturn]] void refuse_degree(int k) const;

    Shared<const std::vector<Coboundary>> tower_; // d_k at k + 1, for k = -1..n
};

/// Euler characteristic: the alternating sum of the numbers of cells.
Index euler_characteristic(const CellComplex& complex);

} // namespace polydec
