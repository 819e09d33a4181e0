// SPDX-License-Identifier: MIT
#include "complex/faces.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>

namespace polydec {

namespace {

Index checked_count(std::size_t count) {
    if (count > std::size_t(std::numeric_limits<Index>::max()))
        throw InvalidInput(fmt::format(
            "{} incidences between cells: more than 2^31 - 1 cannot be numbered", count));
    return static_cast<Index>(count);
}

/// A vertex list behind its first number, and what it stands for. Vertices beyond the list are 0.
template <int capacity>
struct Tail {
    std::array<Index, capacity> vertices;
    Index entry;
};

template <int capacity>
bool same(const Tail<capacity>& a, const Tail<capacity>& b) {
    bool result = true;
    for (int i = 0; i < capacity; ++i)
        result = result && a.vertices[i] == b.vertices[i];
    return result;
}

constexpr std::int64_t as_one(Index high, Index low) {
    return std::int64_t{high} << 32 | low;
}

/// Whether a comes before b in lexicographic order, or at the same place but earlier. Two numbers
/// are compared as one.
template <int capacity>
bool comes_before(const Tail<capacity>& a, const Tail<capacity>& b) {
    if constexpr (capacity == 1)
        return as_one(a.vertices[0], a.entry) < as_one(b.vertices[0], b.entry);
    if constexpr (capacity == 2) {
        const std::int64_t x = as_one(a.vertices[0], a.vertices[1]);
        const std::int64_t y = as_one(b.vertices[0], b.vertices[1]);
        return x < y || (x == y && a.entry < b.entry);
    }
    for (int i = 0; i < capacity; ++i)
        if (a.vertices[i] != b.vertices[i])
            return a.vertices[i] < b.vertices[i];
    return a.entry < b.entry;
}

template <int capacity>
void insertion_sort(Tail<capacity>* begin, Tail<capacity>* end) {
    for (auto* i = begin; i < end; ++i) {
        const Tail<capacity> tail = *i;
        auto* j = i;
        for (; j > begin && comes_before(tail, j[-1]); --j)
            *j = j[-1];
        *j = tail;
    }
}

/// Tails in buckets by the first vertex of their lists: a counting sort. Memory is touched once.
template <int capacity>
class Buckets {
public:
    /// first[v + 1] is the number of lists that begin with v.
    explicit Buckets(std::vector<Index> first) : first_(std::move(first)) {
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        next_ = first_;
        tails_ = std::make_unique_for_overwrite<Tail<capacity>[]>(first_.back());
    }

    /// A place for one more list that begins with the vertex.
    Tail<capacity>& add(Index first_vertex) { return tails_[next_[first_vertex]++]; }

    Index size() const { return static_cast<Index>(first_.size()) - 1; }
    Tail<capacity>* begin(Index bucket) { return tails_.get() + first_[bucket]; }
    Tail<capacity>* end(Index bucket) { return tails_.get() + first_[bucket + 1]; }

    /// Sorts every bucket, equal lists by what they stand for. Most buckets hold a handful, the
    /// poles of a sphere many.
    void sort() {
        constexpr std::ptrdiff_t few = 32;
        for (Index b = 0; b < size(); ++b)
            if (end(b) - begin(b) > few)
                std::sort(begin(b), end(b), comes_before<capacity>);
            else
                insertion_sort(begin(b), end(b));
    }

private:
    std::vector<Index> first_, next_;
    std::unique_ptr<Tail<capacity>[]> tails_;
};

std::vector<Index> no_counts(const Simplices& simplices) {
    return std::vector<Index>(std::size_t(simplices.maxCoeff()) + 2, 0);
}

template <int capacity>
Buckets<capacity> bucketed_faces(const Simplices& simplices, Index m) {
    std::vector<Index> first = no_counts(simplices);
    for (Index s = 0; s < simplices.rows(); ++s) {
        const Index* list = &simplices(s, 0);
        first[list[0] + 1] += m - 1;
        ++first[list[1] + 1];
    }

    // entry s * m + j stands for simplex s without its vertex number m - 1 - j
    Buckets<capacity> buckets(std::move(first));
    for (Index s = 0; s < simplices.rows(); ++s) {
        const Index* list = &simplices(s, 0);
        for (Index j = 0; j < m; ++j) {
            const Index omitted = m - 1 - j;
            auto& tail = buckets.add(list[omitted == 0 ? 1 : 0]);
            tail.entry = s * m + j;
            tail.vertices = {};
            Index place = 0;
            for (Index i = omitted == 0 ? 2 : 1; i < m; ++i)
                if (i != omitted)
                    tail.vertices[place++] = list[i];
        }
    }
    buckets.sort();
    return buckets;
}

/// Calls begin(bucket, tail) with the first of equal lists, then member(tail) with each of them.
template <int capacity, class Begin, class Member>
void for_each_face(Buckets<capacity>& buckets, Begin begin, Member member) {
    for (Index b = 0; b < buckets.size(); ++b)
        for (const auto* i = buckets.begin(b); i < buckets.end(b); ++i) {
            if (i == buckets.begin(b) || !same(*i, i[-1]))
                begin(b, *i);
            member(*i);
        }
}

template <int capacity>
Faces faces_with(const Simplices& simplices) {
    const auto m = static_cast<Index>(simplices.cols());
    const Index entries = checked_count(std::size_t(simplices.rows()) * m);
    auto buckets = bucketed_faces<capacity>(simplices, m);

    Index count = 0;
    for_each_face(
        buckets, [&](Index, const auto&) { ++count; }, [](const auto&) {});
    Faces faces;
    faces.simplices.resize(count, m - 1);
    faces.counts.assign(count, 0);
    faces.coboundary.resize(simplices.rows(), count);
    faces.coboundary.resizeNonZeros(entries);
    Index* const columns = faces.coboundary.innerIndexPtr();
    Index face = -1;
    for_each_face(
        buckets,
        [&](Index first, const auto& tail) {
            Index* list = &faces.simplices(++face, 0);
            list[0] = first;
            for (Index i = 0; i < m - 2; ++i)
                list[i + 1] = tail.vertices[i];
        },
        [&](const auto& tail) {
            columns[tail.entry] = face;
            ++faces.counts[face];
        });

    Index* const rows = faces.coboundary.outerIndexPtr();
    std::int8_t* const signs = faces.coboundary.valuePtr();
    for (Index s = 0; s < simplices.rows(); ++s) {
        rows[s + 1] = (s + 1) * m;
        for (Index j = 0; j < m; ++j)
            signs[s * m + j] = (m - 1 - j) % 2 == 0 ? 1 : -1;
    }
    return faces;
}

template <int capacity>
SortedRows sorted_with(const Simplices& rows) {
    const auto m = static_cast<Index>(rows.cols());
    std::vector<Index> first = no_counts(rows);
    for (Index s = 0; s < rows.rows(); ++s)
        ++first[rows(s, 0) + 1];
    Buckets<capacity> buckets(std::move(first));
    for (Index s = 0; s < rows.rows(); ++s) {
        auto& tail = buckets.add(rows(s, 0));
        tail.entry = s;
        tail.vertices = {};
        for (Index c = 0; c < m - 1; ++c)
            tail.vertices[c] = rows(s, c + 1);
    }
    buckets.sort();

    SortedRows sorted{Simplices(rows.rows(), m), {}};
    sorted.order.reserve(rows.rows());
    for (Index b = 0; b < buckets.size(); ++b)
        for (const auto* i = buckets.begin(b); i < buckets.end(b); ++i) {
            Index* list = &sorted.rows(static_cast<Index>(sorted.order.size()), 0);
            list[0] = b;
            for (Index c = 0; c < m - 1; ++c)
                list[c + 1] = i->vertices[c];
            sorted.order.push_back(i->entry);
        }
    return sorted;
}

/// Calls f with the least capacity of tails that holds the width; of 31 vertices no complex has
/// fewer than 2^31 faces.
template <class F>
auto with_capacity(Index width, F f) {
    switch (width) {
    case 0:
        return f(std::integral_constant<int, 0>());
    case 1:
        return f(std::integral_constant<int, 1>());
    case 2:
        return f(std::integral_constant<int, 2>());
    case 3:
        return f(std::integral_constant<int, 3>());
    default:
        if (width > 29)
            throw InvalidInput(
                fmt::format("simplices of dimension {} have more than 2^31 - 1 faces", width + 1));
        return width <= 6 ? f(std::integral_constant<int, 6>())
                          : f(std::integral_constant<int, 30>());
    }
}

} // namespace

Faces faces_of(const Simplices& simplices) {
    return with_capacity(static_cast<Index>(simplices.cols()) - 2, [&](auto capacity) {
        return faces_with<decltype(capacity)::value>(simplices);
    });
}

SortedRows sorted_rows(const Simplices& rows) {
    return with_capacity(static_cast<Index>(rows.cols()) - 1, [&](auto capacity) {
        return sorted_with<decltype(capacity)::value>(rows);
    });
}

} // namespace polydec
