// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace polydec {

/// Number of cofaces of each cell: a byte per cell, more only if one cell needs it, nothing if
/// there are no cofaces.
class CofaceCounts {
public:
    CofaceCounts() = default;

    /// `size` cells without cofaces.
    explicit CofaceCounts(std::size_t size) : size_(size) {}

    CofaceCounts(const std::vector<Index>& counts) : size_(counts.size()) {
        const Index largest = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
        if (largest > UINT8_MAX)
            large_ = counts;
        else if (largest > 0)
            small_.assign(counts.begin(), counts.end());
    }

    std::size_t size() const { return size_; }

    Index operator[](std::size_t s) const {
        return !small_.empty() ? small_[s] : !large_.empty() ? large_[s] : 0;
    }

    class const_iterator {
    public:
        using iterator_category = std::input_iterator_tag;
        using value_type = Index;
        using difference_type = std::ptrdiff_t;
        using pointer = const Index*;
        using reference = Index;

        const_iterator(const CofaceCounts* counts, std::size_t place)
            : counts_(counts), place_(place) {}
        Index operator*() const { return (*counts_)[place_]; }
        const_iterator& operator++() {
            ++place_;
            return *this;
        }
        const_iterator operator++(int) { return {counts_, place_++}; }
        difference_type operator-(const const_iterator& other) const {
            return static_cast<difference_type>(place_ - other.place_);
        }
        bool operator==(const const_iterator&) const = default;

    private:
        const CofaceCounts* counts_;
        std::size_t place_;
    };
    using iterator = const_iterator;

    const_iterator begin() const { return {this, 0}; }
    const_iterator end() const { return {this, size_}; }

    bool operator==(const CofaceCounts&) const = default;

private:
    std::size_t size_ = 0;
    std::vector<std::uint8_t> small_; // empty: large_ holds the counts; both empty: zeros
    std::vector<Index> large_;
};

} // namespace polydec
