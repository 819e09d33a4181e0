// SPDX-License-Identifier: MIT
#pragma once

#include "base/parallel.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace polydec {

/// Number of vertices per block: a block's data fit into a core's cache.
constexpr Index block_size = 2048;

constexpr Index count_blocks(Index vertices) {
    return vertices / block_size + (vertices % block_size > 0 ? 1 : 0);
}

/// Records by blocks of their vertices, in their original order.
template <class Record>
struct ByBlock {
    std::vector<Index> begins;
    std::unique_ptr<Record[]> records;

    std::span<const Record> of(Index block) const {
        return {&records[begins[block]], &records[begins[block + 1]]};
    }
};

/// Record i belongs to vertex_of(i), below `vertices`, and is make(i). Several stretches are
/// counted, then written, in parallel; the result does not depend on the stretches.
template <class Record, class VertexOf, class Make>
ByBlock<Record> by_block(Index count, Index vertices, VertexOf vertex_of, Make make) {
    constexpr Index least_stretch = 1 << 15, most_stretches = 64;
    const Index stretch = std::max(least_stretch, count / most_stretches + 1);
    const auto blocks = static_cast<std::size_t>(count_blocks(vertices));
    std::vector<Index> places((std::size_t(count / stretch) + 1) * blocks, 0);
    const auto of_stretch = [&](Index begin) { return &places[begin / stretch * blocks]; };
    for_each_part(count, stretch, [&](Index begin, Index end) {
        Index* const own = of_stretch(begin);
        for (Index i = begin; i < end; ++i)
            ++own[vertex_of(i) / block_size];
    });

    ByBlock<Record> result{std::vector<Index>(blocks + 1),
                           std::make_unique_for_overwrite<Record[]>(std::size_t(count))};
    Index sum = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        result.begins[block] = sum;
        for (std::size_t place = block; place < places.size(); place += blocks)
            sum += std::exchange(places[place], sum);
    }
    result.begins[blocks] = sum;
    for_each_part(count, stretch, [&](Index begin, Index end) {
        Index* const own = of_stretch(begin);
        for (Index i = begin; i < end; ++i)
            result.records[own[vertex_of(i) / block_size]++] = make(i);
    });
    return result;
}

} // namespace polydec
