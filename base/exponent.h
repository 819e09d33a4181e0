// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <string_view>

namespace polydec {

/// The exponent of two of the largest of these values; 0 if that is 0 or not finite. The values
/// over this power of two have squares and products in range.
int exponent_of(const Vector& values);

/// The values times 2^exponent.
Vector times_power(const Vector& values, int exponent);

/// part * 2^exponent. Throws InvalidInput, naming `what`, if that overflows or vanishes.
double in_range(double part, int exponent, std::string_view what);

} // namespace polydec
