// SPDX-License-Identifier: MIT
#include "dec/metric/values.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Whether all have the same bits.
bool are_equal(const auto& values) {
    return values.size() < 2 || std::memcmp(values.data(), values.data() + 1,
                                            (values.size() - 1) * sizeof values[0]) == 0;
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

const Vector& Values::vector() const& {
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

Bounds::Bounds(const Vector& values) {
    const double largest = values.size() > 0 ? values.maxCoeff() : 0;
    const Scale scale(largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0);
    *this = Bounds(values.unaryExpr([&](double value) { return scale.part(value); }), scale);
}

Bounds::Bounds(Column<Part> parts, Scale scale)
    : size_(static_cast<Index>(parts.size())), scale_(scale), parts_(std::move(parts)) {
    if (are_equal(parts_))
        parts_.conservativeResize(std::min<Eigen::Index>(size_, 1));
}

bool Bounds::are_finite() const {
    return std::find(parts_.begin(), parts_.end(), Scale::infinite) == parts_.end();
}

Vector Bounds::vector() const {
    Vector result(size_);
    for (Index cell = 0; cell < size_; ++cell)
        result[cell] = (*this)[cell];
    return result;
}

} // namespace polydec
