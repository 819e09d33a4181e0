// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace polydec {

/// The points of a triangle side that are visible from one place along straight lines through the
/// crossed triangles. The side runs along the first axis of a plane from its tail at 0; the place
/// is below it.
struct Fan {
    double begin, end;   ///< along the side
    double along, below; ///< the place is at (along, -below)
    double offset;       ///< distance from the source to the place

    /// From the source to a point of the side.
    double distance(double x) const {
        return offset + std::sqrt((x - along) * (x - along) + below * below);
    }

    /// As the side looks from its other end.
    Fan reversed(double length) const {
        return {length - end, length - begin, length - along, below, offset};
    }
};

/// A fan at a side, and the triangle behind the side, which is above it.
struct Window {
    Fan fan;
    Index side;   ///< half-edge of the triangle behind; or -1 - v, for vertex v itself
    Index turns;  ///< consecutive turns around the tail, or, negative, around the head
    Index before; ///< the preceding window, see PassedWindow
    std::uint32_t has_branched : 1; ///< whether it crossed an edge of three or more triangles
    std::uint32_t key : 31;         ///< key in the queue
};

/// Windows in ascending order of distance, up to 12 binary digits. The order affects only speed,
/// and a coarser order is faster. A window that comes too late is treated as if at the last
/// distance taken.
/// Source: Ahuja, Mehlhorn, Orlin, Tarjan, Faster algorithms for the shortest path problem, J. ACM
/// 37, 1990 (radix heap).
class WindowQueue {
public:
    bool is_empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }

    /// The distance must not be negative.
    void push(Window window, double distance) {
        const auto digits = std::bit_cast<std::uint64_t>(distance) >> dropped_digits;
        window.key = std::max(static_cast<std::uint32_t>(digits), last_) & 0x7fffffff;
        shelf(window.key).push_back(window);
        ++size_;
    }

    /// The queue must not be empty.
    Window pop() {
        if (shelves_[0].empty())
            sort_next();
        const Window window = shelves_[0].back();
        shelves_[0].pop_back();
        --size_;
        return window;
    }

private:
    static constexpr int dropped_digits = 41; // of 52 behind the leading one

    std::vector<Window>& shelf(std::uint32_t key) { return shelves_[std::bit_width(key ^ last_)]; }

    /// Moves the windows of the first nonempty shelf to the shelves before it.
    void sort_next() {
        const auto first = std::find_if(shelves_.begin(), shelves_.end(),
                                        [](const auto& some) { return !some.empty(); });
        const auto by_key = [](const Window& a, const Window& b) { return a.key < b.key; };
        last_ = std::min_element(first->begin(), first->end(), by_key)->key;
        for (const Window& window : *first)
            shelf(window.key).push_back(window);
        first->clear();
    }

    std::array<std::vector<Window>, 24> shelves_; // by the highest bit that differs from last_
    std::uint32_t last_ = 0;
    std::size_t size_ = 0;
};

} // namespace polydec
