// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/types.h"

#include <memory>
#include <vector>

namespace polydec {

/// A number for each cell, of which one is kept if all are equal. A handle on what never changes.
class Values {
public:
    Values() : Values(Vector()) {}
    Values(Vector values);

    Index size() const { return size_; }
    double operator[](Index cell) const { return values_ ? values_[cell] : first_; }

    /// All of them: made when it is first asked for, and kept.
    const Vector& vector() const;

private:
    Index size_;
    double first_;
    const double* values_ = nullptr; // null: all are equal
    std::shared_ptr<const Lazy<Vector>> vector_;
};

/// How large something is at most, for each cell: of such numbers, which are not negative, the
/// first digits count. Four bytes each, rounded up, for numbers within 1e-38 of the largest.
class Bounds {
public:
    Bounds() = default;
    Bounds(const Vector& values);

    Index size() const { return size_; }
    double operator[](Index cell) const {
        return parts_.empty() ? unit_ : unit_ * double{parts_[cell]};
    }
    operator Vector() const;

private:
    Index size_ = 0;
    double unit_ = 0;
    std::vector<float> parts_; // in units; empty: all are equal to it
};

} // namespace polydec
