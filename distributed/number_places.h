// SPDX-License-Identifier: MIT
#pragma once

#include "base/lists.h"
#include "distributed/ranks.h"

namespace polydec {

/// Distinct numbers in ascending order, and the place of each. Linear time and memory for dense
/// numbers, such as numbers of one part of a mesh; without a table for contiguous ones.
class NumberPlaces {
public:
    /// From a list in any order, possibly with repetitions.
    explicit NumberPlaces(std::span<const GlobalIndex> list) {
        if (list.empty())
            return;
        const auto [least, largest] = std::minmax_element(list.begin(), list.end());
        first_ = *least;
        const GlobalIndex range = *largest - first_ + 1;
        constexpr GlobalIndex most_per_number = 4;
        if (range > most_per_number * std::ssize(list)) {
            numbers_.assign(list.begin(), list.end());
            sort_unique(numbers_);
            return;
        }
        const auto is_next = [](GlobalIndex a, GlobalIndex b) { return b == a + 1; };
        if (range == std::ssize(list) &&
            std::adjacent_find(list.begin(), list.end(), std::not_fn(is_next)) == list.end()) {
            numbers_.assign(list.begin(), list.end());
            is_stretch_ = true;
            return;
        }
        table_.assign(range, -1);
        for (const GlobalIndex number : list)
            table_[number - first_] = 0;
        for (std::size_t i = 0; i < table_.size(); ++i)
            if (table_[i] == 0) {
                table_[i] = static_cast<Index>(numbers_.size());
                numbers_.push_back(first_ + static_cast<GlobalIndex>(i));
            }
    }

    const std::vector<GlobalIndex>& numbers() const { return numbers_; }

    /// The place of a listed number.
    Index operator()(GlobalIndex number) const {
        if (is_stretch_)
            return static_cast<Index>(number - first_);
        return table_.empty() ? place_in(numbers_, number) : table_[number - first_];
    }

private:
    std::vector<GlobalIndex> numbers_;
    GlobalIndex first_ = 0;
    bool is_stretch_ = false;
    std::vector<Index> table_; // by number from the first on; empty for sparse numbers
};

} // namespace polydec
