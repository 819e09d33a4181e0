// SPDX-License-Identifier: MIT
#include "complex/faces.h"

#include "base/errors.h"
#include "base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>

namespace polydec {

namespace {

void check_count(std::size_t count) {
    if (count > std::size_t(std::numeric_limits<Index>::max()))
        throw InvalidInput(fmt::format(
            "{} incidences between cells: more than 2^31 - 1 cannot be numbered", count));
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

/// Whether a comes before b in lexicographic order; two numbers are compared as one.
template <int capacity>
bool comes_before(const Tail<capacity>& a, const Tail<capacity>& b) {
    if constexpr (capacity == 2)
        return as_one(a.vertices[0], a.vertices[1]) < as_one(b.vertices[0], b.vertices[1]);
    for (int i = 0; i < capacity; ++i)
        if (a.vertices[i] != b.vertices[i])
            return a.vertices[i] < b.vertices[i];
    return false;
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

/// Most vertices have a handful of lists, which a simple sort does best; the poles of a sphere
/// many.
template <int capacity>
void sort(std::vector<Tail<capacity>>& tails) {
    constexpr std::size_t few = 32;
    if (tails.size() <= few)
        insertion_sort(tails.data(), tails.data() + tails.size());
    else
        std::sort(tails.begin(), tails.end(), comes_before<capacity>);
}

Index largest_vertex(const Simplices& lists) {
    return Eigen::Map<const Eigen::VectorX<Index>>(lists.data(), lists.size()).maxCoeff();
}

/// So many vertices are one piece of work.
constexpr Index part_size = 4096;

/// Lists by one of their vertices: those with v are order[first[v]] .. order[first[v + 1] - 1],
/// ascending.
struct ByVertex {
    std::vector<Index> first, order;

    Index vertices() const { return static_cast<Index>(first.size()) - 1; }
};

/// A counting sort by the vertex at a place of the lists; vertices < bound.
ByVertex by_vertex(const Simplices& lists, Index place, Index bound) {
    ByVertex result{std::vector<Index>(std::size_t(bound) + 1, 0),
                    std::vector<Index>(static_cast<std::size_t>(lists.rows()))};
    for (Index s = 0; s < lists.rows(); ++s)
        ++result.first[lists(s, place) + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    std::vector<Index> next = result.first;
    for (Index s = 0; s < lists.rows(); ++s)
        result.order[next[lists(s, place)]++] = s;
    return result;
}

/// Finds the facets vertex by vertex: those whose first vertex is v lie in the simplices that have
/// v as first or second vertex. Few lists are sorted at a time, and vertices do not meet, so many
/// are looked at at once.
template <int capacity>
class FacetSearch {
public:
    FacetSearch(const Simplices& simplices, Faces& result)
        : simplices_(simplices),
          begin_(first_rows(simplices)),
          second_(by_vertex(simplices, 1, static_cast<Index>(begin_.size()) - 1)),
          faces_(result) {
        faces_.coboundary.resize(simplices.rows(), 0);
        faces_.coboundary.resizeNonZeros(simplices.rows() * m());
    }

    void run();

private:
    /// The facets of some first vertices, in order; there is room for more.
    struct Part {
        std::unique_ptr<Index[]> vertices, counts;
        Index size = 0;
    };

    /// Vertices of a simplex, known to the compiler where they are few.
    Index m() const { return capacity <= 3 ? capacity + 2 : static_cast<Index>(simplices_.cols()); }

    /// Row v: the first simplex whose first vertex is v or more.
    static std::vector<Index> first_rows(const Simplices& simplices) {
        std::vector<Index> begin(std::size_t(largest_vertex(simplices)) + 2);
        Index s = 0;
        for (std::size_t v = 0; v < begin.size(); ++v) {
            while (s < simplices.rows() && simplices(s, 0) < static_cast<Index>(v))
                ++s;
            begin[v] = s;
        }
        return begin;
    }

    /// In how many simplices the facets lie that begin with one of these vertices.
    Index incidences(Index begin, Index end) const {
        return (begin_[end] - begin_[begin]) * (m() - 1) + second_.first[end] -
               second_.first[begin];
    }

    void collect(Index first_vertex, std::vector<Tail<capacity>>& tails) const;
    Part search(Index begin, Index end);
    void put_together(const std::vector<Part>& parts);
    void finish_rows(Index begin, Index end, const std::vector<Index>& offset);

    const Simplices& simplices_;
    std::vector<Index> begin_;
    ByVertex second_;
    Faces& faces_;
};

/// Entry s * m + j stands for simplex s without its vertex number m - 1 - j.
template <int capacity>
void FacetSearch<capacity>::collect(Index first_vertex, std::vector<Tail<capacity>>& tails) const {
    tails.resize(incidences(first_vertex, first_vertex + 1));
    Tail<capacity>* tail = tails.data();
    for (Index s = begin_[first_vertex]; s < begin_[first_vertex + 1]; ++s) {
        const Index* list = &simplices_(s, 0);
        for (Index j = 0; j < m() - 1; ++j, ++tail) {
            tail->entry = s * m() + j;
            for (Index i = 1, place = 0; i < m(); ++i)
                if (i != m() - 1 - j)
                    tail->vertices[place++] = list[i];
        }
    }
    for (Index o = second_.first[first_vertex]; o < second_.first[first_vertex + 1]; ++o, ++tail) {
        const Index s = second_.order[o];
        tail->entry = s * m() + m() - 1;
        for (Index i = 2; i < m(); ++i)
            tail->vertices[i - 2] = simplices_(s, i);
    }
}

/// The coboundary gets the numbers of the facets within the part.
template <int capacity>
auto FacetSearch<capacity>::search(Index begin, Index end) -> Part {
    const auto room = static_cast<std::size_t>(incidences(begin, end));
    Part part{std::make_unique_for_overwrite<Index[]>(room * (m() - 1)),
              std::make_unique_for_overwrite<Index[]>(room)};
    Index* const columns = faces_.coboundary.innerIndexPtr();
    Index* list = part.vertices.get();
    std::vector<Tail<capacity>> tails;
    for (Index v = begin; v < end; ++v) {
        collect(v, tails);
        sort(tails);
        for (std::size_t i = 0; i < tails.size(); ++i) {
            if (i == 0 || !same(tails[i], tails[i - 1])) {
                *list++ = v;
                for (Index place = 0; place < m() - 2; ++place)
                    *list++ = tails[i].vertices[place];
                part.counts[part.size++] = 0;
            }
            ++part.counts[part.size - 1];
            columns[tails[i].entry] = part.size - 1;
        }
    }
    return part;
}

/// Makes numbers within parts, whose facets begin at the offsets, those of all.
template <int capacity>
void FacetSearch<capacity>::finish_rows(Index begin, Index end, const std::vector<Index>& offset) {
    Index* const rows = faces_.coboundary.outerIndexPtr();
    Index* column = faces_.coboundary.innerIndexPtr() + begin * m();
    std::int8_t* sign = faces_.coboundary.valuePtr() + begin * m();
    for (Index s = begin; s < end; ++s) {
        rows[s + 1] = (s + 1) * m();
        for (Index j = 0; j < m(); ++j) {
            *column++ += offset[simplices_(s, j < m() - 1 ? 0 : 1) / part_size];
            *sign++ = (m() - 1 - j) % 2 == 0 ? 1 : -1;
        }
    }
}

template <int capacity>
void FacetSearch<capacity>::put_together(const std::vector<Part>& parts) {
    std::vector<Index> offset{0};
    for (const Part& part : parts)
        offset.push_back(offset.back() + part.size);
    faces_.simplices.resize(offset.back(), m() - 1);
    faces_.counts.resize(offset.back());
    for_each_part(static_cast<Index>(parts.size()), 1, [&](Index p, Index) {
        std::copy_n(parts[p].counts.get(), parts[p].size, faces_.counts.begin() + offset[p]);
        std::copy_n(parts[p].vertices.get(), std::ptrdiff_t{parts[p].size} * (m() - 1),
                    faces_.simplices.data() + std::ptrdiff_t{offset[p]} * (m() - 1));
    });
    faces_.coboundary.conservativeResize(simplices_.rows(), offset.back());
    for_each_part(static_cast<Index>(simplices_.rows()), part_size,
                  [&](Index begin, Index end) { finish_rows(begin, end, offset); });
}

template <int capacity>
void FacetSearch<capacity>::run() {
    const Index vertices = second_.vertices();
    std::vector<Part> parts((std::size_t(vertices) + part_size - 1) / part_size);
    for_each_part(vertices, part_size,
                  [&](Index begin, Index end) { parts[begin / part_size] = search(begin, end); });
    put_together(parts);
}

template <int capacity>
SortedRows sorted_with(const Simplices& rows) {
    const auto m = static_cast<Index>(rows.cols());
    ByVertex leading = by_vertex(rows, 0, largest_vertex(rows) + 1);
    Simplices sorted(rows.rows(), m);
    for_each_part(leading.vertices(), part_size, [&](Index begin, Index end) {
        std::vector<Tail<capacity>> tails;
        for (Index v = begin; v < end; ++v) {
            tails.clear();
            for (Index o = leading.first[v]; o < leading.first[v + 1]; ++o) {
                Tail<capacity>& tail = tails.emplace_back();
                tail.entry = leading.order[o];
                for (Index i = 1; i < m; ++i)
                    tail.vertices[i - 1] = rows(tail.entry, i);
            }
            sort(tails);
            Index o = leading.first[v];
            for (const auto& tail : tails) {
                leading.order[o] = tail.entry;
                sorted(o, 0) = v;
                for (Index i = 1; i < m; ++i)
                    sorted(o, i) = tail.vertices[i - 1];
                ++o;
            }
        }
    });
    return {std::move(sorted), std::move(leading.order)};
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
        check_count(std::size_t(simplices.rows()) * simplices.cols());
        Faces faces;
        FacetSearch<decltype(capacity)::value>(simplices, faces).run();
        return faces;
    });
}

SortedRows sorted_rows(const Simplices& rows) {
    return with_capacity(static_cast<Index>(rows.cols()) - 1, [&](auto capacity) {
        return sorted_with<decltype(capacity)::value>(rows);
    });
}

} // namespace polydec
