// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/shared.h"
#include "base/types.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace polydec {

/// One number per cell; stores a single number if all are equal. An immutable handle.
class Values {
public:
    Values() : Values(Vector()) {}
    Values(Vector values);

    Index size() const { return size_; }
    double operator[](Index cell) const { return values_ ? values_[cell] : first_; }

    /// All numbers, without a vector of them; to be used while this exists.
    auto numbers() const {
        using Step = Eigen::InnerStride<Eigen::Dynamic>;
        return Eigen::Map<const Eigen::VectorXd, 0, Step>(values_ ? values_ : &first_, size_,
                                                          Step(values_ ? 1 : 0));
    }

    /// Whether all are finite numbers above `least`.
    bool are_above(double least) const;

    /// All numbers as a vector; computed on first use, and kept.
    const Vector& vector() const&;
    Vector vector() && { return vector(); }

private:
    Index size_;
    double first_;
    const double* values_ = nullptr; // null: all are equal
    Shared<const Lazy<Vector>> vector_;
};

/// An upper bound per cell, not negative, to a few digits, in two bytes: nine bits of a double's
/// exponent and seven places. Rounded up by less than 1 %, if within 1e77 times the scale.
class Bounds {
public:
    using Part = std::uint16_t;

    /// Which exponents are kept: those near this one.
    class Scale {
    public:
        explicit Scale(int exponent)
            : least_(std::int64_t{std::clamp(1023 - 255 + exponent, 0, 2047 - 511)} << places) {}

        /// What is kept of a bound; infinite for a NaN.
        [[gnu::always_inline]] Part part(double bound) const {
            constexpr std::int64_t up = (std::int64_t{1} << dropped) - 1;
            const auto bits = std::bit_cast<std::int64_t>(std::abs(bound)); // of a NaN, too
            const auto part =
                std::clamp<std::int64_t>(((bits + up) >> dropped) - least_, 1, infinite);
            return static_cast<Part>(bound == 0 ? 0 : part);
        }
        double bound(Part part) const {
            return part == 0          ? 0
                   : part == infinite ? std::numeric_limits<double>::infinity()
                                      : std::bit_cast<double>((part + least_) << dropped);
        }

        static constexpr Part infinite = 511 << 7;

    private:
        static constexpr int places = 7, dropped = 52 - places;
        std::int64_t least_;
    };

    Bounds() = default;
    Bounds(const Vector& values);
    Bounds(Column<Part> parts, Scale scale);

    Index size() const { return size_; }
    double operator[](Index cell) const {
        return scale_.bound(parts_[parts_.size() == 1 ? 0 : cell]);
    }
    Vector vector() const;
    bool are_finite() const;

private:
    Index size_ = 0;
    Scale scale_{0};
    Column<Part> parts_; // a single one if all are equal
};

} // namespace polydec
