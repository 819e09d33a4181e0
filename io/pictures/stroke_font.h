// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace polydec {

/// The strokes of a printable ASCII character, separated by spaces: each a list of points, two
/// digits x y to a point. x is 0 to 4 from the left; the baseline is y = 2, capitals end at y = 8.
/// A stroke of one point twice is a dot. Other characters look like '?'.
std::string_view glyph(char character);

} // namespace polydec
