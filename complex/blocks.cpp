// SPDX-License-Identifier: MIT
#include "complex/blocks.h"

#include "base/checks.h"
#include "complex/disjoint_sets.h"

#include <cstdlib>
#include <utility>

namespace polydec {

namespace {

class Joining {
public:
    explicit Joining(const Pieces& complex) : complex_(complex) {
        const int n = complex.dimension();
        blocks_.twisted.resize(n + 1);
        blocks_.active_cofaces.resize(n + 1);
        for (int k = n - 1; k <= n; ++k) // n-simplices stay active
            blocks_.active_cofaces[k] = complex.coface_counts(k);
        for (int k = 0; k <= n; ++k) {
            blocks_.signs.emplace_back(complex.size(k), std::int8_t{1});
            auto& carriers = blocks_.carriers.emplace_back(complex.size(k));
            for (Index s = 0; s < complex.size(k); ++s)
                carriers[s] = {k, s};
        }
    }

    /// Counts the active cofaces of the k-simplices, which is final once degree k+2 is joined.
    void count_active(int k) {
        std::vector<Index> counts(complex_.size(k), 0);
        const FaceTable faces = complex_.faces(k + 1);
        for (Index t = 0; t < complex_.size(k + 1); ++t)
            if (is_active(k + 1, t))
                for (int i = 0; i <= k + 1; ++i)
                    ++counts[faces(t, i)];
        blocks_.active_cofaces[k] = counts;
    }

    /// Joins the two active k-simplices f and g around a (k-1)-simplex s if they are
    /// `together`(s, f, g), and removes what lies inside larger blocks.
    template <class Together>
    void join_degree(int k, Together together);

    Blocks finish() { return std::move(blocks_); }

private:
    bool is_active(int k, Index s) const { return blocks_.carriers[k][s].dimension == k; }

    void remove(int k, Index s, Blocks::Carrier carrier) {
        blocks_.carriers[k][s] = carrier;
        blocks_.signs[k][s] = 0;
    }

    void name_by_first_pieces(int k, DisjointSets& sets);

    const Pieces& complex_;
    Blocks blocks_;
};

template <class Together>
void Joining::join_degree(int k, Together together) {
    const auto &own = blocks_.carriers[k], &below = blocks_.carriers[k - 1];
    const auto &around = blocks_.active_cofaces[k - 1], &above = blocks_.active_cofaces[k];
    const FaceTable faces = complex_.faces(k);
    DisjointSets sets(complex_.size(k));
    std::vector<Index> met(below.size(), 0), clashes; // its number + 1, with the sign of the face
    for (Index g = 0; g < complex_.size(k); ++g)
        for (int i = k; i >= 0; --i) {
            const Index s = faces(g, i);
            if (around[s] == 0) {
                // the carrier of s is the smallest among those of its cofaces
                if (is_active(k - 1, s) || own[g].dimension < below[s].dimension)
                    remove(k - 1, s, own[g]);
            } else if (around[s] == 2 && own[g].dimension == k) {
                const int sign = complex_.sign(k, g, i);
                const Index f = std::abs(met[s]) - 1;
                if (f < 0) {
                    met[s] = sign * (g + 1);
                } else if (above[f] == above[g] && together(s, f, g)) {
                    // a coherent block has opposite signs there
                    if (!sets.join(f, g, met[s] > 0 ? -sign : sign))
                        clashes.push_back(f);
                    remove(k - 1, s, {k, f});
                }
            }
        }
    name_by_first_pieces(k, sets);
    for (const Index f : clashes)
        blocks_.twisted[k].push_back(own[f].piece);
}

/// Of all blocks of dimension k, and signs relative to it.
void Joining::name_by_first_pieces(int k, DisjointSets& sets) {
    auto &own = blocks_.carriers[k], &below = blocks_.carriers[k - 1];
    std::vector<Index> first(own.size(), -1);
    for (Index s = 0; s < complex_.size(k); ++s) {
        if (!is_active(k, s))
            continue;
        const auto root = sets.find(s);
        Index& piece = first[root.element];
        if (piece < 0)
            piece = s;
        else
            blocks_.signs[k][s] = static_cast<std::int8_t>(root.sign * sets.find(piece).sign);
        own[s].piece = piece;
    }
    for (auto& carrier : below)
        if (carrier.dimension == k)
            carrier.piece = own[carrier.piece].piece;
}

} // namespace

Blocks join_blocks(const Pieces& complex, const std::vector<bool>& removed_facets,
                   const Straightness& straight) {
    const int n = complex.dimension();
    check_as_many("marks of facets", static_cast<std::int64_t>(removed_facets.size()),
                  complex.size(n - 1));
    Joining joining(complex);
    joining.join_degree(n, [&](Index s, Index, Index) { return removed_facets[s]; });
    for (int k = n - 1; k >= 1; --k) {
        joining.count_active(k - 1);
        if (k >= 2)
            joining.join_degree(k, [&](Index s, Index f, Index g) { return straight(k, s, f, g); });
    }
    return joining.finish();
}

std::vector<bool> facets_within_labels(const Pieces& complex, const std::vector<Index>& labels) {
    const int n = complex.dimension();
    check_as_many("labels of simplices", static_cast<std::int64_t>(labels.size()), complex.size(n));
    const Cofaces cofaces(complex, n);
    std::vector<bool> removed(complex.size(n - 1), false);
    for (Index f = 0; f < complex.size(n - 1); ++f)
        if (const auto sides = cofaces.of(f); sides.size() == 2)
            removed[f] = labels[sides[0].cell] == labels[sides[1].cell];
    return removed;
}

std::vector<InadmissibleBlock> inadmissible_blocks(const Pieces& complex, const Blocks& blocks) {
    const int n = complex.dimension();
    std::vector<std::vector<Index>> wrong; // by first piece: Euler number without that piece, then
    for (int k = 0; k <= n; ++k)           // not 0 where anything is amiss, then number in result
        wrong.emplace_back(complex.size(k), 0);
    for (int k = 0; k <= n; ++k)
        for (Index s = 0; s < complex.size(k); ++s)
            if (const auto& [dimension, piece] = blocks.carriers[k][s]; dimension > k || piece != s)
                wrong[dimension][piece] += k % 2 == 0 ? 1 : -1;
    for (int k = 0; k <= n; ++k)
        for (const Index piece : blocks.twisted[k])
            wrong[k][piece] = 1;
    const FaceTable ends = complex.faces(1);
    for (Index e = 0; e < complex.size(1); ++e)
        for (int i = 0; i <= 1; ++i)
            if (blocks.active_cofaces[0][ends(e, i)] == 0)
                wrong[blocks.carriers[1][e].dimension][blocks.carriers[1][e].piece] = 1;

    std::vector<InadmissibleBlock> result;
    for (int k = 0; k <= n; ++k)
        for (Index s = 0; s < complex.size(k); ++s)
            if (wrong[k][s] != 0) {
                result.push_back({k, s, {}});
                wrong[k][s] = static_cast<Index>(result.size());
            }
    for (int k = 0; k < n && !result.empty(); ++k)
        for (Index s = 0; s < complex.size(k); ++s) {
            const auto& carrier = blocks.carriers[k][s];
            if (carrier.dimension == k + 1 && wrong[k + 1][carrier.piece] > 0)
                result[wrong[k + 1][carrier.piece] - 1].interfaces.push_back(s);
        }
    return result;
}

} // namespace polydec
