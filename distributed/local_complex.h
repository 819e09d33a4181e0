// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "distributed/copies.h"
#include "distributed/slices.h"

namespace polydec {

/// The part of a simplicial complex on one rank: all n-simplices at a vertex that the rank owns,
/// with their faces. A simplex belongs to the owner of its first vertex. Local vertices are in file
/// order, so the order of simplices, their signs and all sums over cofaces agree with one process:
/// results are identical bit by bit for any number of ranks.
struct LocalComplex {
    /// The simplices of one degree.
    struct Degree {
        GlobalIndex count = 0;           ///< on all ranks
        std::vector<GlobalIndex> number; ///< place in the lexicographic order of all; ascends
        std::vector<int> owner;          ///< rank
        std::vector<bool> complete;      ///< all cofaces are here, since an own vertex is in it
        Copies copies;

        Index size() const { return static_cast<Index>(number.size()); }

        /// The simplex with that number; -1 if it is not on this rank.
        Index find(GlobalIndex of_number) const;
    };

    SimplicialComplex complex;         ///< oriented like the whole complex
    Points points;                     ///< of the vertices here
    std::vector<GlobalIndex> vertices; ///< their numbers in the file
    std::vector<Degree> degrees;
    bool orientable = true;
    GlobalIndex turned = 0; ///< see SimplicialComplex, for the whole complex

    int dimension() const { return static_cast<int>(degrees.size()) - 1; }
    const Degree& degree(int k) const { return degrees[k]; }
    bool owns(const Ranks& ranks, int k, Index s) const {
        return degree(k).owner[s] == ranks.rank();
    }
};

/// Collective: the complex of a mesh given by slices. `owners` belong to the slice's vertices.
/// Throws InvalidInput, with numbers of the file, for vertex numbers out of range, points that are
/// not finite, and like SimplicialComplex.
LocalComplex local_complex(const Ranks& ranks, const MeshSlice& slice,
                           const std::vector<int>& owners);

/// Some n-simplices of a mesh, with the owners of their vertices.
struct Stars {
    std::vector<GlobalIndex> vertices; ///< ascending; only vertices of the cells
    std::vector<int> owners;
    Points points;
    GlobalSimplices cells;                ///< vertex numbers, in the order of the file
    std::vector<GlobalIndex> file_places; ///< number of each cell in the file
};

/// Names of vertices in messages: their numbers in the file, or, where these have more than 31
/// bits, local ones.
std::vector<Index> names_of(const std::vector<GlobalIndex>& vertices);

/// The cells with the places of their vertices.
Simplices by_local_vertex(const Stars& stars);

/// Collective: the stars of the vertices that this rank owns.
Stars own_stars(const Ranks& ranks, const MeshSlice& slice, const std::vector<int>& owners);

/// Collective: the complex of these stars.
LocalComplex local_complex(const Ranks& ranks, const Stars& stars, GlobalIndex vertices);

} // namespace polydec
