// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <span>
#include <string>
#include <string_view>

namespace polydec {

/// The arrays of a page, coded so that they become small: each number takes four bytes, of which
/// the first ones of all numbers come first, then the second ones ..; whole numbers as differences
/// from the row before, at which a sign is the lowest bit. What page.html calls data, deflated and
/// in base64; decode.js reads it.
class PageData {
public:
    /// Whole numbers, `width` to a row.
    void add(std::string_view name, std::span<const Index> numbers, int width);

    /// Rows of numbers as floats, times `scale`, a power of two that makes the largest one a
    /// number from 1 to 2, so that none is out of their range. 7 digits.
    void add_floats(std::string_view name, const Eigen::Ref<const DenseMatrix>& rows);

    /// Rows of numbers as whole ones of this many bits: low + step * number, the same for all
    /// columns. They are off by at most step / 2.
    void add_rounded(std::string_view name, const Eigen::Ref<const DenseMatrix>& rows, int bits);

    /// Where each array stands, as a JSON object; and the text.
    std::string directory() const { return "{" + directory_ + "}"; }
    std::string text() const;

private:
    void add(std::string_view name, const std::vector<std::uint32_t>& words, int width,
             std::string_view more);

    std::string directory_, bytes_;
};

} // namespace polydec
