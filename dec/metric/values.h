// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/types.h"

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

namespace polydec {

/// One number per cell; stores a single number if all are equal. An immutable handle.
class Values {
public:
    Values() : Values(Vector()) {}
    Values(Vector values);

    Index size() const { return size_; }
    double operator[](Index cell) const { return values_ ? values_[cell] : first_; }

    /// Whether all are finite numbers above `least`.
    bool are_above(double least) const;

    /// All numbers as a vector; computed on first use, and kept.
    const Vector& vector() const;

private:
    Index size_;
    double first_;
    const double* values_ = nullptr; // null: all are equal
    std::shared_ptr<const Lazy<Vector>> vector_;
};

/// An upper bound per cell, not negative, to a few digits. Two bytes each; rounded up by less than
/// 1 % if above 1e-38 of the largest.
class Bounds {
public:
    Bounds() = default;
    Bounds(const Vector& values);

    Index size() const { return size_; }
    double operator[](Index cell) const {
        return parts_.empty()
                   ? unit_
                   : unit_ * double{std::bit_cast<float>(std::uint32_t{parts_[cell]} << 16)};
    }
    Vector vector() const;
    bool are_finite() const;

private:
    Index size_ = 0;
    double unit_ = 0;
    std::vector<std::uint16_t> parts_; // upper halves of floats, in units; empty: all are 1
};

} // namespace polydec
