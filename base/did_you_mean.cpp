// SPDX-License-Identifier: MIT
#include "base/did_you_mean.h"

#include <algorithm>
#include <cstddef>

namespace polydec {

namespace {

/// Row i of the table has the distances of a's first i bytes from the beginnings of b.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last, row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = last;
        last = row;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row.back();
}

} // namespace

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
    const std::size_t most = std::max<std::size_t>(2, name.size() / 3);
    std::size_t least = most + 1;
    std::string nearest;
    for (const std::string& each : known) {
        const std::size_t difference =
            std::max(name.size(), each.size()) - std::min(name.size(), each.size());
        if (difference >= least)
            continue;
        const std::size_t edits = distance(name, each);
        if (edits < least && edits < std::min(name.size(), each.size())) { // they share a byte
            least = edits;
            nearest = each;
        }
    }
    return nearest.empty() ? "" : ": did you mean '" + nearest + "'?";
}

} // namespace polydec
