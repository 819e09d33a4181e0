// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <span>
#include <string>
#include <string_view>

namespace polydec {

/// The arrays of a page, encoded to compress well. Each number takes four bytes; the first bytes of
/// all numbers come first, then the second bytes, and so on. Integers are differences from the row
/// before, with the sign in the lowest bit. page.html calls this `data`, deflated and in base64;
/// decode.js reads it.
class PageData {
public:
    /// Integers, `width` to a row.
    void add(std::string_view name, std::span<const Index> numbers, int width);

    /// Rows of numbers as floats, times `scale`, a power of two that brings the largest into the
    /// range from 1 to 2, so that none overflows. 7 digits.
    void add_floats(std::string_view name, const Eigen::Ref<const DenseMatrix>& rows);

    /// Rows of numbers as integers of this many bits: low + step * number, the same for all
    /// columns. The error is at most step / 2.
    void add_rounded(std::string_view name, const Eigen::Ref<const DenseMatrix>& rows, int bits);

    /// The places of all arrays, as a JSON object; and the text.
    std::string directory() const { return "{" + directory_ + "}"; }
    std::string text() const;

private:
    void add(std::string_view name, const std::vector<std::uint32_t>& words, int width,
             std::string_view more);

    std::string directory_, bytes_;
};

} // namespace polydec
