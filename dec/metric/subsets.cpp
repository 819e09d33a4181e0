// SPDX-License-Identifier: MIT
#include "dec/metric/subsets.h"

#include "base/checks.h"

#include <algorithm>
#include <limits>

namespace polydec {

std::vector<std::vector<int>> subsets(int count, int size) {
    constexpr int any = std::numeric_limits<int>::max();
    check_number("subsets of a set of size", count, 0, any);
    check_number("subsets of size", size, 0, any);
    std::vector<std::vector<int>> result;
    std::vector<int> current;
    const auto extend = [&](const auto& self, int next) -> void {
        if (static_cast<int>(current.size()) == size) {
            result.push_back(current);
            return;
        }
        for (int i = next; i < count; ++i) {
            current.push_back(i);
            self(self, i + 1);
            current.pop_back();
        }
    };
    extend(extend, 0);
    return result;
}

std::vector<int> complement(int count, const std::vector<int>& list) {
    std::vector<int> result;
    for (int i = 0; i < count; ++i)
        if (!std::binary_search(list.begin(), list.end(), i))
            result.push_back(i);
    return result;
}

} // namespace polydec
