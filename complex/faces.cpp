// SPDX-License-Identifier: MIT
#include "complex/faces.h"

#include "base/errors.h"
#include "complex/vertex_blocks.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <limits>
#include <numeric>

namespace polydec {

namespace {

void check_count(std::size_t count) {
    if (count > std::size_t(std::numeric_limits<Index>::max()))
        throw InvalidInput(fmt::format("{} incidences between cells are too many: expected at most "
                                       "2^31 - 1; use a smaller mesh",
                                       count));
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
void sort(std::span<Tail<capacity>> tails) {
    constexpr std::size_t few = 32;
    if (tails.size() <= few)
        insertion_sort(tails.data(), tails.data() + tails.size());
    else
        std::sort(tails.begin(), tails.end(), comes_before<capacity>);
}

template <int capacity>
struct List {
    Index first;
    Tail<capacity> tail;
};

/// The lists of one block of vertices, by their first ones.
template <int capacity>
class Block {
public:
    Block(std::span<const List<capacity>> lists, Index block)
        : first_vertex_(block * block_size),
          tails_(std::make_unique_for_overwrite<Tail<capacity>[]>(lists.size())) {
        for (const auto& list : lists)
            ++ends_[list.first - first_vertex_ + 1];
        std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
        for (const auto& list : lists)
            tails_[ends_[list.first - first_vertex_]++] = list.tail;
    }

    std::span<Tail<capacity>> of(Index vertex) {
        const Index v = vertex - first_vertex_;
        return {&tails_[v > 0 ? ends_[v - 1] : 0], &tails_[ends_[v]]};
    }

private:
    Index first_vertex_;
    std::unique_ptr<Tail<capacity>[]> tails_;
    std::array<Index, block_size + 1> ends_{};
};

/// Calls work(block, first vertex, last vertex and one).
template <class Work>
void for_each_block(Index vertices, Work work) {
    for_each_part(count_blocks(vertices), 1, [&](Index block, Index) {
        const Index first = block * block_size;
        work(block, first, first + std::min(block_size, vertices - first));
    });
}

/// Finds the facets vertex by vertex: those whose first vertex is v lie in the simplices that have
/// v as first or second vertex. Few lists are sorted at a time, and vertices do not meet, so many
/// are looked at at once.
template <int capacity>
class FacetSearch {
public:
    FacetSearch(const SortedSimplices& simplices, const std::vector<std::int8_t>& signs)
        : simplices_(*simplices.rows),
          begins_(simplices.begins),
          signs_(signs.empty() ? nullptr : signs.data()),
          are_coherent_(!signs.empty()),
          second_(without_first(simplices)),
          table_(simplices_.rows(), simplices_.cols()) {
        faces_.simplices.vertices = simplices.vertices;
    }

    Faces run() && {
        std::vector<Part> parts(begins_.size() - 1);
        for_each_block(faces_.simplices.vertices, [&](Index block, Index begin, Index end) {
            parts[block] = search(block, begin, end);
        });
        put_together(parts);
        faces_.are_coherent = are_coherent_;
        return std::move(faces_);
    }

private:
    /// The facets of a block of first vertices, in order; there is room for more.
    struct Part {
        std::unique_ptr<Index[]> vertices, counts;
        Index size = 0;
    };

    /// Vertices of a simplex, known to the compiler where they are few.
    Index m() const { return capacity <= 4 ? capacity + 2 : static_cast<Index>(simplices_.cols()); }

    /// Entry s * m + j stands for simplex s without its vertex number m - 1 - j.
    ByBlock<List<capacity>> without_first(const SortedSimplices& simplices) const {
        return by_block<List<capacity>>(
            static_cast<Index>(simplices_.rows()), simplices.vertices,
            [&](Index s) { return simplices_(s, 1); },
            [&](Index s) {
                List<capacity> list{simplices_(s, 1), {{}, s * m() + m() - 1}};
                for (Index i = 2; i < m(); ++i)
                    list.tail.vertices[i - 2] = simplices_(s, i);
                return list;
            });
    }

    /// The facets with this first vertex; s is the first simplex that has it, and becomes the one
    /// behind.
    void collect(Index& s, Index first_vertex, std::span<const Tail<capacity>> second,
                 std::vector<Tail<capacity>>& tails) const {
        Index end = s;
        while (end < simplices_.rows() && simplices_(end, 0) == first_vertex)
            ++end;
        tails.resize(std::size_t(end - s) * (m() - 1) + second.size());
        Tail<capacity>* tail = tails.data();
        for (; s < end; ++s) {
            const Index* list = &simplices_(s, 0);
            for (Index j = 0; j < m() - 1; ++j, ++tail) {
                tail->entry = s * m() + j;
                for (Index i = 1, place = 0; i < m(); ++i)
                    if (i != m() - 1 - j)
                        tail->vertices[place++] = list[i];
            }
        }
        std::copy(second.begin(), second.end(), tail);
    }

    /// The table gets the numbers of the facets within the block.
    Part search(Index block, Index begin, Index end) {
        Block<capacity> second(second_.of(block), block);
        const std::size_t room =
            std::size_t(begins_[block + 1] - begins_[block]) * (m() - 1) + second_.of(block).size();
        Part part{std::make_unique_for_overwrite<Index[]>(room * (m() - 1)),
                  std::make_unique_for_overwrite<Index[]>(room)};
        Index* const table = table_.data();
        Index *list = part.vertices.get(), s = begins_[block];
        std::vector<Tail<capacity>> tails;
        for (Index v = begin; v < end; ++v) {
            collect(s, v, second.of(v), tails);
            sort(std::span(tails));
            for (std::size_t i = 0, j = 0; i < tails.size(); i = j) {
                *list++ = v;
                for (Index place = 0; place < m() - 2; ++place)
                    *list++ = tails[i].vertices[place];
                for (; j < tails.size() && same(tails[i], tails[j]); ++j)
                    table[tails[j].entry] = part.size;
                part.counts[part.size++] = static_cast<Index>(j - i);
                if (signs_ && j == i + 2)
                    check_coherence(tails[i].entry, tails[i + 1].entry);
            }
        }
        return part;
    }

    /// Whether two simplices have opposite signs at their facet.
    void check_coherence(Index entry, Index other) {
        const auto is_positive = [this](Index e) {
            return (signs_[e / m()] > 0) == (e % m() % 2 == 0);
        };
        if (is_positive(entry) == is_positive(other))
            are_coherent_.store(false, std::memory_order_relaxed);
    }

    /// Makes numbers within blocks those of all.
    void finish_table(Index begin, Index end) {
        const std::vector<Index>& begins = faces_.simplices.begins;
        Index* face = &table_(begin, 0);
        for (Index s = begin; s < end; ++s)
            for (Index j = 0; j < m(); ++j)
                *face++ += begins[simplices_(s, j < m() - 1 ? 0 : 1) / block_size];
    }

    void put_together(const std::vector<Part>& parts) {
        std::vector<Index>& offset = faces_.simplices.begins;
        offset = {0};
        for (const Part& part : parts)
            offset.push_back(offset.back() + part.size);
        Simplices rows(offset.back(), m() - 1);
        std::vector<Index> counts(static_cast<std::size_t>(offset.back()));
        for_each_part(static_cast<Index>(parts.size()), 1, [&](Index p, Index) {
            std::copy_n(parts[p].counts.get(), parts[p].size, counts.begin() + offset[p]);
            std::copy_n(parts[p].vertices.get(), std::ptrdiff_t{parts[p].size} * (m() - 1),
                        rows.data() + std::ptrdiff_t{offset[p]} * (m() - 1));
        });
        faces_.simplices.rows = std::make_shared<const Simplices>(std::move(rows));
        faces_.counts = counts;
        constexpr Index part_size = 1 << 14;
        for_each_part(static_cast<Index>(simplices_.rows()), part_size,
                      [&](Index begin, Index end) { finish_table(begin, end); });
        faces_.table = std::make_shared<const Simplices>(std::move(table_));
    }

    const Simplices& simplices_;
    const std::vector<Index>& begins_;
    const std::int8_t* signs_; // or null
    std::atomic<bool> are_coherent_;
    ByBlock<List<capacity>> second_; // all simplices without their first vertices
    Simplices table_;
    Faces faces_;
};

/// The ends of edges, which need no search: these are all vertices, and their faces.
Faces ends_of(const SortedSimplices& edges) {
    const Index vertices = edges.vertices;
    Faces faces;
    faces.simplices.rows =
        std::make_shared<const Simplices>(Column<Index>::LinSpaced(vertices, 0, vertices - 1));
    faces.table = edges.rows;
    std::vector<Index> counts(static_cast<std::size_t>(vertices), 0);
    for (const Index vertex : edges.rows->reshaped<Eigen::RowMajor>())
        ++counts[vertex];
    faces.counts = counts;
    return faces;
}

/// List i, sorted by insertion, with entry i, or ~i if that takes an odd permutation.
template <int capacity>
List<capacity> sorted_list(const Simplices& rows, Index i) {
    const auto m = static_cast<Index>(rows.cols());
    std::array<Index, capacity + 1> list{};
    Index entry = i;
    for (Index j = 0; j < m; ++j) {
        Index place = j;
        for (; place > 0 && rows(i, j) < list[place - 1]; --place, entry = ~entry)
            list[place] = list[place - 1];
        list[place] = rows(i, j);
    }
    List<capacity> result{list[0], {{}, entry}};
    std::copy(list.begin() + 1, list.end(), result.tail.vertices.begin());
    return result;
}

template <int capacity>
SortedRows sorted_with(const Simplices& rows, Index vertices) {
    const auto m = static_cast<Index>(rows.cols());
    auto lists = by_block<List<capacity>>(
        static_cast<Index>(rows.rows()), vertices,
        [&](Index i) { return *std::min_element(&rows(i, 0), &rows(i, 0) + m); },
        [&](Index i) { return sorted_list<capacity>(rows, i); });
    const auto count = static_cast<std::size_t>(rows.rows());
    Simplices simplices(rows.rows(), m);
    SortedRows sorted;
    sorted.order.resize(count);
    sorted.signs.resize(count);
    std::atomic<bool> are_simplices = true;
    for_each_block(vertices, [&](Index block, Index begin, Index end) {
        Block<capacity> by_vertex(lists.of(block), block);
        Index o = lists.begins[block];
        bool fine = true;
        for (Index v = begin; v < end; ++v) {
            const auto tails = by_vertex.of(v);
            sort(tails);
            for (std::size_t i = 0; i < tails.size(); ++i, ++o) {
                const auto& [list, entry] = tails[i];
                sorted.order[o] = entry < 0 ? ~entry : entry;
                sorted.signs[o] = entry < 0 ? -1 : 1;
                Index* const row = &simplices(o, 0);
                row[0] = v;
                for (Index j = 1; j < m; ++j) {
                    row[j] = list[j - 1];
                    fine = fine && row[j] != row[j - 1];
                }
                fine = fine && (i == 0 || !same(tails[i], tails[i - 1]));
            }
        }
        if (!fine)
            are_simplices = false;
    });
    // a member at a time: g++ 12 frees nested ones twice where a later initializer throws
    sorted.simplices.rows = std::make_shared<const Simplices>(std::move(simplices));
    sorted.simplices.vertices = vertices;
    sorted.simplices.begins = std::move(lists.begins);
    sorted.are_simplices = are_simplices;
    return sorted;
}

/// Calls f with the least of these ascending capacities of tails that holds the width.
template <int capacity, int... larger, class F>
auto with_least(Index width, F f) {
    if constexpr (sizeof...(larger) > 0)
        if (width > capacity)
            return with_least<larger...>(width, f);
    return f(std::integral_constant<int, capacity>());
}

/// Of 31 vertices no complex has fewer than 2^31 faces.
template <class F>
auto with_capacity(Index width, F f) {
    if (width > 29)
        throw InvalidInput(
            fmt::format("simplices of dimension {} have more than 2^31 - 1 faces", width + 1));
    return with_least<1, 2, 3, 4, 6, 30>(width, f);
}

} // namespace

Faces faces_of(const SortedSimplices& simplices, const std::vector<std::int8_t>& signs) {
    const auto width = static_cast<Index>(simplices.rows->cols());
    check_count(std::size_t(simplices.rows->rows()) * width);
    if (width == 2)
        return ends_of(simplices);
    return with_capacity(width - 2, [&](auto capacity) {
        return FacetSearch<decltype(capacity)::value>(simplices, signs).run();
    });
}

SortedRows sorted_rows(const Simplices& rows, Index vertices) {
    return with_capacity(static_cast<Index>(rows.cols()) - 1, [&](auto capacity) {
        return sorted_with<decltype(capacity)::value>(rows, vertices);
    });
}

} // namespace polydec
