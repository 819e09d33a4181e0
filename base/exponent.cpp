// SPDX-License-Identifier: MIT
#include "base/exponent.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace polydec {

int exponent_of(const Vector& values) {
    const double largest = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
    return largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
}

Vector times_power(const Vector& values, int exponent) {
    constexpr int factor = 1000; // 2 to this power is a normal number
    if (std::abs(exponent) <= factor)
        return std::ldexp(1.0, exponent) * values;
    return values.unaryExpr([=](double value) { return std::ldexp(value, exponent); });
}

double ScaledNumber::in_range(std::string_view what) const {
    const double number = std::ldexp(part, exponent);
    if (!std::isfinite(number) || (number == 0 && part != 0))
        throw OutOfRange(fmt::format("{} is {:.3g} times 2^{}, outside the range of double "
                                     "precision: scale the values or the mesh to sizes nearer "
                                     "to 1",
                                     what, part, exponent));
    return number;
}

double ratio(const ScaledNumber& a, const ScaledNumber& b) {
    return std::ldexp(a.part / b.part, a.exponent - b.exponent);
}

} // namespace polydec
