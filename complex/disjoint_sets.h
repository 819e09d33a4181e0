// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <utility>
#include <vector>

namespace polydec {

/// Union-find over 0..size-1 in which each element also has a sign relative to its root: joining a
/// and b with relative sign s states sign(a) = s * sign(b). Near-linear in the number of calls.
class DisjointSets {
public:
    explicit DisjointSets(Index size) : parent_(size, -1), sign_(size, 1) {}

    struct Root {
        Index element;
        std::int8_t sign; ///< of the queried element, relative to the root
    };

    Root find(Index a) {
        Index root = a;
        std::int8_t sign = 1;
        while (parent_[root] >= 0) {
            sign = static_cast<std::int8_t>(sign * sign_[root]);
            root = parent_[root];
        }
        const Root result{root, sign};

        // path compression: everything passed on the way now points to the root
        while (a != root && parent_[a] != root) {
            const auto next = parent_[a];
            const auto rest = static_cast<std::int8_t>(sign * sign_[a]);
            parent_[a] = root;
            sign_[a] = sign;
            sign = rest;
            a = next;
        }
        return result;
    }

    /// Returns false, and changes nothing, iff the two were joined before with the opposite sign.
    bool join(Index a, Index b, int relative_sign = 1) {
        Root s = find(a), t = find(b);
        const auto sign = static_cast<std::int8_t>(s.sign * t.sign * relative_sign);
        if (s.element == t.element)
            return sign == 1;
        if (parent_[s.element] > parent_[t.element])
            std::swap(s, t);
        parent_[s.element] += parent_[t.element];
        parent_[t.element] = s.element;
        sign_[t.element] = sign;
        return true;
    }

    /// The least member of the set of each element.
    std::vector<Index> firsts() {
        std::vector<Index> of_root(parent_.size(), -1), result;
        result.reserve(parent_.size());
        for (std::size_t a = 0; a < parent_.size(); ++a) {
            const auto element = static_cast<Index>(a);
            Index& first = of_root[find(element).element];
            first = first < 0 ? element : first;
            result.push_back(first);
        }
        return result;
    }

private:
    std::vector<Index> parent_; // of a root: minus the number of its elements
    std::vector<std::int8_t> sign_;
};

} // namespace polydec
