// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "base/types.h"

#include <string_view>

namespace polydec {

/// The exponent of two of the largest of these values; 0 if that is 0 or not finite. The values
/// over this power of two have squares and products in range.
int exponent_of(const Vector& values);

/// The values times 2^exponent.
Vector times_power(const Vector& values, int exponent);

/// A result, not an input, is outside the range of double precision.
class OutOfRange : public InvalidInput {
public:
    using InvalidInput::InvalidInput;
};

/// part * 2^exponent: a square or a product, which may be outside the range of double precision.
struct ScaledNumber {
    double part = 0;
    int exponent = 0;

    /// Throws OutOfRange, naming `what`, on overflow and underflow.
    double in_range(std::string_view what) const;
};

/// a / b; not finite if b is 0 or the ratio overflows.
double ratio(const ScaledNumber& a, const ScaledNumber& b);

/// x^T A y, where map(y) is A y.
template <class Map>
ScaledNumber product(const Vector& x, const Vector& y, const Map& map) {
    const int of_x = exponent_of(x), of_y = exponent_of(y);
    return {times_power(x, -of_x).dot(map(times_power(y, -of_y))), of_x + of_y};
}

/// x^T A x, likewise.
template <class Map>
ScaledNumber square(const Vector& x, const Map& map) {
    const int exponent = exponent_of(x);
    const Vector scaled = times_power(x, -exponent);
    return {scaled.dot(map(scaled)), 2 * exponent};
}

} // namespace polydec
