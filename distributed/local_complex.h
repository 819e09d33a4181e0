// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "distributed/copies.h"
#include "distributed/slices.h"

namespace polydec {

/// What one rank has of a simplicial complex: all n-simplices that touch a vertex that it owns,
/// with their faces. A simplex belongs to the owner of its first vertex. Local vertices ascend with
/// those of the file, so the order of simplices, their signs and all sums over cofaces are those of
/// the whole, as one process would have them: results are the same bit by bit for any number of
/// ranks.
struct LocalComplex {
    /// The simplices of one degree.
    struct Degree {
        GlobalIndex count = 0;           ///< on all ranks
        GlobalIndex first_row = 0;       ///< own ones before this rank
        std::vector<GlobalIndex> number; ///< place among all in lexicographic order; ascends
        std::vector<int> owner;          ///< rank
        std::vector<bool> complete;      ///< all cofaces are here, since a vertex is owned here
        Copies copies;

        Index size() const { return static_cast<Index>(number.size()); }

        /// Number of own ones.
        Index own() const;

        /// The simplex of that number; -1 if this rank does not have it.
        Index find(GlobalIndex of_number) const;
    };

    SimplicialComplex complex;         ///< oriented like the whole
    Points points;                     ///< of the vertices here
    std::vector<GlobalIndex> vertices; ///< what the file calls them
    std::vector<Degree> degrees;
    bool orientable = true;
    GlobalIndex turned = 0; ///< see SimplicialComplex, for the whole

    int dimension() const { return static_cast<int>(degrees.size()) - 1; }
    const Degree& degree(int k) const { return degrees[static_cast<std::size_t>(k)]; }
    bool owns(const Ranks& ranks, int k, Index s) const {
        return degree(k).owner[s] == ranks.rank();
    }
};

/// Collective: the complex of a mesh of which each rank has a slice. `owners` are those of the
/// slice's vertices. Throws InvalidInput, by the numbers of the file, for vertex numbers out of
/// range, points that are not finite, and as SimplicialComplex does.
LocalComplex local_complex(const Ranks& ranks, const MeshSlice& slice,
                           const std::vector<int>& owners);

/// Some n-simplices of a mesh, and who owns their vertices.
struct Stars {
    std::vector<GlobalIndex> vertices; ///< ascending, without others than those of the cells
    std::vector<int> owners;
    Points points;
    GlobalSimplices cells;                ///< vertex numbers, in the order of the file
    std::vector<GlobalIndex> file_places; ///< number of each cell in the file
};

/// Collective: the stars of the vertices that this rank owns.
Stars own_stars(const Ranks& ranks, const MeshSlice& slice, const std::vector<int>& owners);

/// Collective: the complex of these.
LocalComplex local_complex(const Ranks& ranks, const Stars& stars, GlobalIndex vertices);

} // namespace polydec
