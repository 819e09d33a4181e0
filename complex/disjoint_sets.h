// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace polydec {

/// Union-find over 0..size-1 in which each element also has a sign relative to its root, the least
/// member of its set: joining a and b with relative sign s states sign(a) = s * sign(b).
/// Near-linear in the number of calls.
class DisjointSets {
public:
    explicit DisjointSets(Index size) : links_(static_cast<std::size_t>(size)) {
        for (std::size_t a = 0; a < links_.size(); ++a)
            links_[a] = static_cast<Link>(2 * a);
    }

    std::size_t size() const { return links_.size(); }

    struct Root {
        Index element;    ///< the least member
        std::int8_t sign; ///< of the queried element, relative to the root
    };

    Root find(Index a) {
        auto at = static_cast<Link>(a);
        Link turned = 0;
        for (Link up = links_[at]; up / 2 != at; up = links_[at]) {
            links_[at] = links_[up / 2] ^ (up & 1); // halves the path for those that come later
            turned ^= links_[at] & 1;
            at = links_[at] / 2;
        }
        return {static_cast<Index>(at), static_cast<std::int8_t>(turned == 0 ? 1 : -1)};
    }

    /// Returns false, and changes nothing, iff the two were joined before with the opposite sign.
    bool join(Index a, Index b, int relative_sign = 1) {
        const Root s = find(a), t = find(b);
        const int sign = s.sign * t.sign * relative_sign;
        if (s.element == t.element)
            return sign == 1;
        const auto [least, other] = std::minmax(s.element, t.element);
        links_[other] = 2 * static_cast<Link>(least) + (sign == 1 ? 0 : 1);
        return true;
    }

    /// The least member of the set of each element.
    std::vector<Index> firsts() {
        std::vector<Index> result;
        result.reserve(links_.size());
        for (Index a = 0; a < std::ssize(links_); ++a)
            result.push_back(find(a).element);
        return result;
    }

private:
    using Link = std::uint32_t; // twice a member nearer to the root, and 1 if the sign is opposite

    std::vector<Link> links_;
};

} // namespace polydec
