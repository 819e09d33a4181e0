// SPDX-License-Identifier: MIT
#include "complex/blocks.h"

#include "base/checks.h"
#include "complex/open_balls.h"
#include "complex/sides.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace polydec {

namespace {

/// Blocks of one simplex each. Removed simplices have the sign 0 before they have a carrier.
Blocks single_simplices(const Pieces& complex, const std::vector<bool>& removed_facets) {
    const int n = complex.dimension();
    Blocks blocks;
    blocks.twisted.resize(n + 1);
    blocks.active_cofaces.resize(n + 1);
    for (int k = n - 1; k <= n; ++k) // n-simplices stay active
        blocks.active_cofaces[k] = complex.coface_counts(k);
    for (int k = 0; k <= n; ++k) {
        const Index size = complex.size(k);
        blocks.signs.emplace_back(size, std::int8_t{1});
        auto& carriers = blocks.carriers.emplace_back();
        carriers.reserve(size);
        for (Index s = 0; s < size; ++s)
            carriers.push_back({k, s});
    }
    const CofaceCounts& cofaces = complex.coface_counts(n - 1);
    for (Index f = 0; f < std::ssize(removed_facets); ++f)
        if (removed_facets[f] && cofaces[f] == 2)
            blocks.signs[n - 1][f] = 0;
    return blocks;
}

/// Counts the active cofaces of the k-simplices, which is final once degree k+2 is joined.
/// Simplices without, inside larger blocks, are removed.
void count_active(const Pieces& complex, int k, Blocks& blocks) {
    const Index size = complex.size(k), cofaces = complex.size(k + 1);
    std::vector<Index> counts(size, 0);
    const FaceTable faces = complex.faces(k + 1);
    const auto& signs = blocks.signs[k + 1];
    for (Index t = 0; t < cofaces; ++t)
        if (signs[t] != 0)
            for (int i = 0; i <= k + 1; ++i)
                ++counts[faces(t, i)];
    for (Index s = 0; s < size && k > 0; ++s)
        blocks.signs[k][s] = counts[s] > 0 ? 1 : 0;
    blocks.active_cofaces[k] = counts;
}

/// Names the blocks of dimension k by their first pieces. The carrier of a removed simplex is the
/// smallest among those of its cofaces.
void name_blocks(const Pieces& complex, int k, JoinedSimplices joined, Blocks& blocks) {
    auto &own = blocks.carriers[k], &below = blocks.carriers[k - 1];
    std::int8_t* const signs = blocks.signs[k].data();
    const std::int8_t* const signs_below = blocks.signs[k - 1].data();
    const FaceTable faces = complex.faces(k);
    const auto size = static_cast<Index>(own.size());
    for (Index g = 0; g < size; ++g) {
        if (signs[g] != 0) {
            const auto [first, sign] = joined.sets.find(g);
            own[g].cell = first;
            signs[g] = sign;
        }
        for (int i = k; i >= 0; --i)
            if (const Index s = faces(g, i);
                signs_below[s] == 0 &&
                (below[s].dimension < k || own[g].dimension < below[s].dimension))
                below[s] = own[g];
    }
    for (const Index f : joined.clashes)
        blocks.twisted[k].push_back(own[f].cell);
}

/// Joins the two active k-simplices f and g around a (k-1)-simplex s if they are
/// `straight`(k, s, f, g).
void join_degree(const Pieces& complex, int k, const Straightness& straight, Blocks& blocks) {
    const auto &around = blocks.active_cofaces[k - 1], &above = blocks.active_cofaces[k];
    const auto& signs = blocks.signs[k];
    const FaceTable faces = complex.faces(k);
    const auto size = static_cast<Index>(signs.size());
    JoinedSimplices joined{DisjointSets(size), {}};
    std::vector<Index> met(around.size(), 0); // its number + 1, with the sign of the face
    for (Index g = 0; g < size; ++g) {
        if (signs[g] == 0)
            continue;
        for (int i = k; i >= 0; --i) {
            const Index s = faces(g, i);
            if (around[s] != 2)
                continue;
            const int sign = complex.sign(k, g, i);
            const Index f = std::abs(met[s]) - 1;
            if (f < 0) {
                met[s] = sign * (g + 1);
            } else if (above[f] == above[g] && straight(k, s, f, g)) {
                // a coherent block has opposite signs there
                joined.join(f, g, met[s] > 0 ? -sign : sign);
                blocks.signs[k - 1][s] = 0;
            }
        }
    }
    name_blocks(complex, k, std::move(joined), blocks);
}

/// What counting its simplices says of a block, by its first piece.
struct Tallies {
    std::vector<std::vector<Index>> euler;            // Euler number beyond that of a ball
    std::vector<std::vector<Index>> below_interfaces; // at least two dimensions less
    bool any_undecided = false;
};

bool is_undecided(const Pieces& complex, Index below_interfaces) {
    return below_interfaces > (complex.is_simplicial() ? most_below_interfaces : 0);
}

Tallies tallies(const Pieces& complex, const Blocks& blocks) {
    Tallies result;
    for (int k = 0; k <= complex.dimension(); ++k) {
        result.euler.emplace_back(complex.size(k), 0);
        result.below_interfaces.emplace_back(complex.size(k), 0);
    }
    for (int k = 0; k <= complex.dimension(); ++k) {
        const auto& carriers = blocks.carriers[k];
        const auto size = static_cast<Index>(carriers.size());
        for (Index s = 0; s < size; ++s) {
            const auto& [dimension, piece] = carriers[s];
            if (dimension > k || piece != s)
                result.euler[dimension][piece] += k % 2 == 0 ? 1 : -1;
            if (dimension > k + 1) {
                const Index count = ++result.below_interfaces[dimension][piece];
                result.any_undecided = result.any_undecided || is_undecided(complex, count);
            }
        }
    }
    return result;
}

/// The incidences inside undecided blocks with the Euler number of a ball.
std::vector<OpenIncidence> undecided_interiors(const Pieces& complex, const Blocks& blocks,
                                               const Tallies& tallies) {
    std::vector<OpenIncidence> result;
    for (int k = 1; k <= complex.dimension() && tallies.any_undecided; ++k)
        for (Index s = 0; s < complex.size(k); ++s) {
            const auto& [dimension, piece] = blocks.carriers[k][s];
            if (!is_undecided(complex, tallies.below_interfaces[dimension][piece]) ||
                tallies.euler[dimension][piece] != 0)
                continue;
            for (const auto& [face, sign] : complex.incidences(k - 1)[s])
                if (blocks.carriers[k - 1][face].dimension == dimension)
                    result.push_back({{dimension, piece}, k, s, face, sign});
        }
    return result;
}

} // namespace

JoinedSimplices join_tops(const Pieces& complex, const std::vector<bool>& removed_facets) {
    check_as_many("marks of facets", static_cast<std::int64_t>(removed_facets.size()),
                  complex.size(complex.dimension() - 1));
    const Sides sides(complex);
    JoinedSimplices tops{DisjointSets(complex.size(complex.dimension())), {}};
    for (Index f = 0; f < std::ssize(removed_facets); ++f)
        if (removed_facets[f] && sides.exist(f))
            tops.join(sides.first(f), sides.second(f), sides.relative_sign(f));
    return tops;
}

Blocks join_blocks(const Pieces& complex, const std::vector<bool>& removed_facets,
                   const Straightness& straight) {
    return join_blocks(complex, removed_facets, join_tops(complex, removed_facets), straight);
}

Blocks join_blocks(const Pieces& complex, const std::vector<bool>& removed_facets,
                   JoinedSimplices tops, const Straightness& straight) {
    const int n = complex.dimension();
    Blocks blocks = single_simplices(complex, removed_facets);
    name_blocks(complex, n, std::move(tops), blocks);
    for (int k = n - 1; k >= 1; --k) {
        count_active(complex, k - 1, blocks);
        if (k >= 2)
            join_degree(complex, k, straight, blocks);
    }
    return blocks;
}

std::vector<InadmissibleBlock> inadmissible_blocks(const Pieces& complex, const Blocks& blocks) {
    const int n = complex.dimension();
    Tallies of_blocks = tallies(complex, blocks);
    auto& wrong = of_blocks.euler; // not 0 where anything is amiss, then number in result
    for (int k = 0; k <= n; ++k)
        for (const Index piece : blocks.twisted[k])
            wrong[k][piece] = 1;
    const CofaceCounts& edges = blocks.active_cofaces[0];
    const FaceTable ends = complex.faces(1);
    if (std::find(edges.begin(), edges.end(), 0) != edges.end())
        for (Index e = 0; e < complex.size(1); ++e)
            for (int i = 0; i <= 1; ++i)
                if (edges[ends(e, i)] == 0)
                    wrong[blocks.carriers[1][e].dimension][blocks.carriers[1][e].cell] = 1;
    for (const auto& [dimension, piece] :
         without_homology_of_balls(undecided_interiors(complex, blocks, of_blocks)))
        wrong[dimension][piece] = 1;

    std::vector<InadmissibleBlock> result;
    for (int k = 0; k <= n; ++k)
        for (Index s = 0; s < std::ssize(wrong[k]); ++s)
            if (wrong[k][s] != 0) {
                result.push_back({k, s, {}});
                wrong[k][s] = static_cast<Index>(result.size());
            }
    for (int k = 0; k < n && !result.empty(); ++k)
        for (Index s = 0; s < complex.size(k); ++s) {
            const auto& carrier = blocks.carriers[k][s];
            if (carrier.dimension == k + 1 && wrong[k + 1][carrier.cell] > 0)
                result[wrong[k + 1][carrier.cell] - 1].interfaces.push_back(s);
        }
    return result;
}

} // namespace polydec
