// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace polydec {

/// Sorts a list and keeps one of the items that are equal.
template <class Item>
void sort_unique(std::vector<Item>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// How many items of a sorted list come before one: the place of the first equal to it, if any.
template <class List>
Index place_in(const List& sorted, const typename List::value_type& item) {
    return static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), item) -
                              sorted.begin());
}

/// 0, 1, .. count - 1.
inline std::vector<Index> numbers_below(Eigen::Index count) {
    std::vector<Index> result(count);
    std::iota(result.begin(), result.end(), 0);
    return result;
}

/// Of 0, 1, .. count - 1, whether each is among the numbers.
template <class Numbers>
std::vector<bool> marks_at(const Numbers& numbers, Eigen::Index count) {
    std::vector<bool> result(count, false);
    for (const Index number : numbers)
        result[number] = true;
    return result;
}

/// The numbers of the marks that are set, ascending.
template <class Marks>
std::vector<Index> marked(const Marks& marks) {
    std::vector<Index> result;
    for (std::size_t number = 0; number < marks.size(); ++number)
        if (marks[number])
            result.push_back(static_cast<Index>(number));
    return result;
}

} // namespace polydec
