// SPDX-License-Identifier: MIT
#include "complex/faces.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace polydec {

namespace {

/// Entries 0..count-1 in stable order of key(entry), a number in 0..largest, with the buckets'
/// first positions.
struct Buckets {
    std::vector<Index> entries;
    std::vector<Index> first;
};

template <class Key>
Buckets counting_sort(Index count, Index largest, Key key) {
    Buckets result{std::vector<Index>(count), std::vector<Index>(std::size_t(largest) + 2, 0)};
    for (Index e = 0; e < count; ++e)
        ++result.first[key(e) + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    auto next = result.first;
    for (Index e = 0; e < count; ++e)
        result.entries[next[key(e)]++] = e;
    return result;
}

/// Sorts positions by the fixed-width rows they point to; most buckets hold a handful.
void sort_rows(Index* begin, Index* end, const Index* rows, Index width) {
    const auto less = [=](Index a, Index b) {
        const Index* x = rows + std::size_t(a) * width;
        const Index* y = rows + std::size_t(b) * width;
        for (Index j = 0; j < width; ++j)
            if (x[j] != y[j])
                return x[j] < y[j];
        return a < b;
    };
    constexpr std::ptrdiff_t few = 32;
    if (end - begin > few) {
        std::sort(begin, end, less);
        return;
    }
    for (Index* i = begin; i < end; ++i) {
        const Index value = *i;
        Index* j = i;
        for (; j > begin && less(value, j[-1]); --j)
            *j = j[-1];
        *j = value;
    }
}

Index checked_count(std::size_t count) {
    if (count > std::size_t(std::numeric_limits<Index>::max()))
        throw InvalidInput(fmt::format(
            "{} incidences between cells: more than 2^31 - 1 cannot be numbered", count));
    return static_cast<Index>(count);
}

} // namespace

std::vector<Index> lexicographic_order(const Simplices& rows) {
    const auto width = static_cast<Index>(rows.cols());
    const auto count = static_cast<Index>(rows.rows());
    if (count == 0)
        return {};
    auto [order, first] =
        counting_sort(count, rows.col(0).maxCoeff(), [&](Index r) { return rows(r, 0); });
    for (std::size_t b = 0; b + 1 < first.size(); ++b)
        sort_rows(order.data() + first[b], order.data() + first[b + 1], rows.data(), width);
    return order;
}

Faces faces_of(const Simplices& simplices) {
    const auto m = static_cast<Index>(simplices.cols());
    const auto width = m - 2; // vertices of a face behind its first
    const Index entries = checked_count(std::size_t(simplices.rows()) * m);

    // entry e = s * m + j stands for simplex s without its vertex m - 1 - j
    const auto first_vertex = [&](Index e) { return simplices(e / m, e % m == m - 1 ? 1 : 0); };
    const auto buckets = counting_sort(entries, simplices.maxCoeff(), first_vertex);

    // the tails of all entries, contiguous in bucket order
    std::vector<Index> tails(std::size_t(entries) * width);
    for (Index p = 0; p < entries; ++p) {
        const Index s = buckets.entries[p] / m, omitted = m - 1 - buckets.entries[p] % m;
        Index* tail = tails.data() + std::size_t(p) * width;
        for (Index j = omitted == 0 ? 2 : 1; j < m; ++j)
            if (j != omitted)
                *tail++ = simplices(s, j);
    }

    std::vector<Index> position(entries);
    std::iota(position.begin(), position.end(), Index{0});
    for (std::size_t b = 0; b + 1 < buckets.first.size(); ++b)
        sort_rows(position.data() + buckets.first[b], position.data() + buckets.first[b + 1],
                  tails.data(), width);

    // equal neighbors are the same face
    const auto same = [&](Index p, Index q) {
        const Index *x = tails.data() + std::size_t(p) * width,
                    *y = tails.data() + std::size_t(q) * width;
        return first_vertex(buckets.entries[p]) == first_vertex(buckets.entries[q]) &&
               std::equal(x, x + width, y);
    };
    Faces faces;
    faces.of.resize(entries);
    std::vector<Index> representative;
    for (Index i = 0; i < entries; ++i) {
        if (i == 0 || !same(position[i - 1], position[i])) {
            representative.push_back(position[i]);
            faces.counts.push_back(0);
        }
        faces.of[buckets.entries[position[i]]] = static_cast<Index>(representative.size()) - 1;
        ++faces.counts.back();
    }

    faces.simplices.resize(static_cast<Index>(representative.size()), m - 1);
    for (std::size_t f = 0; f < representative.size(); ++f) {
        const Index p = representative[f];
        faces.simplices(f, 0) = first_vertex(buckets.entries[p]);
        std::copy_n(tails.data() + std::size_t(p) * width, width, &faces.simplices(f, 0) + 1);
    }
    return faces;
}

} // namespace polydec
