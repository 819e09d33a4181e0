// SPDX-License-Identifier: MIT
#include "dec/metric/values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace polydec {

namespace {

bool are_equal(const Vector& values) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return std::all_of(values.data(), values.data() + values.size(),
                       [&](double value) { return bits(value) == bits(values[0]); });
}

/// The upper half of the smallest float that is not less.
std::uint16_t upper_half(double value) {
    const auto near = static_cast<float>(value);
    const std::uint32_t above = std::bit_cast<std::uint32_t>(near) + (near < value ? 1 : 0);
    return static_cast<std::uint16_t>((above + 0xffff) >> 16);
}

double from_upper_half(std::uint16_t part) {
    return std::bit_cast<float>(std::uint32_t{part} << 16);
}

} // namespace

Values::Values(Vector values)
    : size_(static_cast<Index>(values.size())), first_(size_ > 0 ? values[0] : 0) {
    if (are_equal(values)) {
        vector_ = std::make_shared<Lazy<Vector>>();
        return;
    }
    vector_ = std::make_shared<Lazy<Vector>>(std::move(values));
    values_ = vector().data();
}

const Vector& Values::vector() const {
    return vector_->get([this]() -> Vector { return Vector::Constant(size_, first_); });
}

bool Values::are_above(double least) const {
    bool are = true; // branch-free, so that it vectorizes
    const Index count = values_ ? size_ : std::min<Index>(size_, 1);
    const double* const values = values_ ? values_ : &first_;
    for (Index i = 0; i < count; ++i)
        are &= values[i] > least && values[i] <= std::numeric_limits<double>::max();
    return are;
}

Bounds::Bounds(const Vector& values) : size_(static_cast<Index>(values.size())) {
    if (size_ == 0)
        return;
    // a power of two, so scaling does not round
    constexpr double most = 1e300;
    const double largest = values.maxCoeff();
    unit_ = largest > 1 / most && largest < most ? std::ldexp(1, std::ilogb(largest)) : 1;
    const double inverse = 1 / unit_;
    if (are_equal(values)) { // rounded like any other, so no bound depends on other cells
        unit_ *= from_upper_half(upper_half(inverse * largest));
        return;
    }
    parts_.resize(static_cast<std::size_t>(size_));
    std::transform(values.data(), values.data() + size_, parts_.begin(),
                   [=](double value) { return upper_half(inverse * value); });
}

bool Bounds::are_finite() const {
    constexpr std::uint16_t infinite = 0x7f80;
    bool are = std::isfinite(unit_);
    for (const std::uint16_t part : parts_)
        are &= (part & infinite) != infinite;
    return are;
}

Vector Bounds::vector() const {
    Vector result(size_);
    for (Index cell = 0; cell < size_; ++cell)
        result[cell] = (*this)[cell];
    return result;
}

} // namespace polydec
