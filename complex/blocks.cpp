// SPDX-License-Identifier: MIT
#include "complex/blocks.h"

#include "base/checks.h"
#include "complex/disjoint_sets.h"

#include <algorithm>
#include <optional>

namespace polydec {

namespace {

class Joining {
public:
    Joining(const Pieces& complex, const Straightness& straight)
        : complex_(complex), straight_(straight) {
        for (int k = 0; k <= complex.dimension(); ++k) {
            auto& carriers = blocks_.carriers.emplace_back();
            carriers.reserve(complex.size(k));
            for (Index s = 0; s < complex.size(k); ++s)
                carriers.push_back({k, s});
            sets_.emplace_back(complex.size(k));
            clashes_.emplace_back();
        }
    }

    void join_tops(const std::vector<bool>& removed_facets) {
        const int n = complex_.dimension();
        const Cofaces cofaces(complex_, n);
        for (Index f = 0; f < complex_.size(n - 1); ++f)
            if (removed_facets[f])
                join(n, f, cofaces.of(f));
    }

    /// Joins k-simplices across (k-1)-simplices and removes the latter where they lie inside.
    void join_degree(int k) {
        const Cofaces cofaces(complex_, k);
        const auto& around = blocks_.active_cofaces[k];
        for (Index s = 0; s < complex_.size(k - 1); ++s) {
            Index active[2] = {-1, -1};
            Index count = 0;
            for (const Coface& f : cofaces.of(s))
                if (is_active(k, f.cell) && ++count <= 2)
                    active[count - 1] = f.cell;

            if (count == 0)
                remove_inside(k, s, cofaces.of(s));
            else if (count == 2 && around[active[0]] == around[active[1]] &&
                     straight_(k, s, active[0], active[1]))
                join(k, s, cofaces.of(s));
        }
    }

    /// Counts the active cofaces of the k-simplices, which is final once degree k+1 is joined.
    void count_active(int k) {
        auto& counts = blocks_.active_cofaces;
        counts.resize(complex_.dimension() + 1);
        counts[k].assign(complex_.size(k), 0);
        const FaceTable faces = complex_.faces(k + 1);
        for (Index t = 0; t < complex_.size(k + 1); ++t)
            if (is_active(k + 1, t))
                for (int i = 0; i <= k + 1; ++i)
                    ++counts[k][faces(t, i)];
    }

    Blocks finish();

private:
    bool is_active(int k, Index s) const { return blocks_.carriers[k][s].dimension == k; }

    /// Unites the two active k-simplices around s; a coherent block has opposite signs there.
    void join(int k, Index s, std::span<const Coface> around) {
        std::optional<std::pair<Index, int>> first;
        for (const auto& [f, omitted] : around) {
            if (!is_active(k, f))
                continue;
            const int sign = complex_.sign(k, f, omitted);
            if (!first)
                first = {f, sign};
            else if (!sets_[k].join(first->first, f, -first->second * sign))
                clashes_[k].push_back(f);
        }
        blocks_.carriers[k - 1][s] = {k, first->first};
    }

    /// The carrier of s is the smallest among those of its cofaces.
    void remove_inside(int k, Index s, std::span<const Coface> around) {
        for (const Coface& f : around) {
            const auto& carrier = blocks_.carriers[k][f.cell];
            auto& own = blocks_.carriers[k - 1][s];
            if (own.dimension < k || carrier.dimension < own.dimension)
                own = carrier;
        }
    }

    const Pieces& complex_;
    const Straightness& straight_;
    Blocks blocks_;
    std::vector<DisjointSets> sets_;
    std::vector<std::vector<Index>> clashes_;
};

Blocks Joining::finish() {
    const int n = complex_.dimension();

    // the first piece of each class, and signs relative to it
    std::vector<std::vector<Index>> first(n + 1);
    blocks_.signs.resize(n + 1);
    blocks_.twisted.resize(n + 1);
    for (int k = 0; k <= n; ++k) {
        first[k].assign(complex_.size(k), -1);
        blocks_.signs[k].assign(complex_.size(k), 0);
        blocks_.twisted[k].assign(complex_.size(k), false);
        for (Index s = 0; s < complex_.size(k); ++s) {
            if (!is_active(k, s))
                continue;
            const auto root = sets_[k].find(s);
            Index& piece = first[k][root.element];
            if (piece < 0)
                piece = s;
            const auto sign_of_first = sets_[k].find(piece).sign;
            blocks_.signs[k][s] = static_cast<std::int8_t>(root.sign * sign_of_first);
        }
    }
    for (int k = 0; k <= n; ++k)
        for (auto& carrier : blocks_.carriers[k]) {
            auto& sets = sets_[carrier.dimension];
            carrier.piece = first[carrier.dimension][sets.find(carrier.piece).element];
        }
    for (int k = 0; k <= n; ++k)
        for (const Index s : clashes_[k])
            blocks_.twisted[k][blocks_.carriers[k][s].piece] = true;
    return std::move(blocks_);
}

} // namespace

Blocks join_blocks(const Pieces& complex, const std::vector<bool>& removed_facets,
                   const Straightness& straight) {
    const int n = complex.dimension();
    check_as_many("marks of facets", static_cast<std::int64_t>(removed_facets.size()),
                  complex.size(n - 1));
    Joining joining(complex, straight);
    joining.join_tops(removed_facets);
    joining.count_active(n - 1);
    for (int k = n - 1; k >= 1; --k) {
        if (k >= 2)
            joining.join_degree(k);
        joining.count_active(k - 1);
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
    std::vector<std::vector<Index>> euler(n + 1);
    for (int k = 0; k <= n; ++k)
        euler[k].assign(complex.size(k), 0);
    for (int k = 0; k <= n; ++k)
        for (const auto& carrier : blocks.carriers[k])
            euler[carrier.dimension][carrier.piece] += k % 2 == 0 ? 1 : -1;

    std::vector<std::vector<bool>> bad(n + 1);
    for (int k = 0; k <= n; ++k) {
        bad[k].resize(complex.size(k));
        for (Index s = 0; s < complex.size(k); ++s)
            bad[k][s] = blocks.carriers[k][s].dimension == k && blocks.carriers[k][s].piece == s &&
                        (blocks.twisted[k][s] || euler[k][s] != (k % 2 == 0 ? 1 : -1));
    }
    for (Index e = 0; e < complex.size(1); ++e)
        for (int i = 0; i <= 1; ++i)
            if (blocks.active_cofaces[0][complex.face(1, e, i)] == 0)
                bad[blocks.carriers[1][e].dimension][blocks.carriers[1][e].piece] = true;

    std::vector<InadmissibleBlock> result;
    if (std::none_of(bad.begin(), bad.end(), [](const std::vector<bool>& blocks_of_degree) {
            return std::find(blocks_of_degree.begin(), blocks_of_degree.end(), true) !=
                   blocks_of_degree.end();
        }))
        return result;
    std::vector<std::vector<Index>> number(n + 1);
    for (int k = 0; k <= n; ++k) {
        number[k].assign(complex.size(k), -1);
        for (Index s = 0; s < complex.size(k); ++s)
            if (bad[k][s]) {
                number[k][s] = static_cast<Index>(result.size());
                result.push_back({k, s, {}});
            }
    }
    for (int k = 0; k < n; ++k)
        for (Index s = 0; s < complex.size(k); ++s) {
            const auto& carrier = blocks.carriers[k][s];
            if (carrier.dimension == k + 1 && number[k + 1][carrier.piece] >= 0)
                result[number[k + 1][carrier.piece]].interfaces.push_back(s);
        }
    return result;
}

} // namespace polydec
