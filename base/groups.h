// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace polydec {

/// 0, 1, .. count - 1 in groups, by a key from 0 to keys - 1 that each number has; numbers with a
/// negative key are in no group. Linear time.
class Groups {
public:
    Groups() = default;
    template <class Key>
    Groups(Index count, Index keys, const Key& key) : begins_(std::size_t(keys) + 1, 0) {
        for (Index i = 0; i < count; ++i)
            if (const Index k = key(i); k >= 0)
                ++begins_[k + 1];
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        members_.resize(begins_.back());
        std::vector<Index> next(begins_.begin(), begins_.end() - 1);
        for (Index i = 0; i < count; ++i)
            if (const Index k = key(i); k >= 0)
                members_[next[k]++] = i;
    }

    /// The numbers with this key, ascending.
    std::span<const Index> operator[](Index key) const {
        return {members_.data() + begins_[key], members_.data() + begins_[key + 1]};
    }

private:
    std::vector<Index> begins_, members_;
};

} // namespace polydec
