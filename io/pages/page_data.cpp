// SPDX-License-Identifier: MIT
#include "io/pages/page_data.h"

#include "io/base64.h"
#include "io/deflate.h"
#include "io/pages/page_text.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace polydec {

namespace {

/// Differences from the row before, modulo 2^32; small ones of either sign are small numbers.
std::vector<std::uint32_t> differences(std::vector<std::uint32_t> numbers, std::size_t width) {
    for (std::size_t i = numbers.size(); i-- > 0;) {
        const std::uint32_t d = numbers[i] - (i < width ? 0 : numbers[i - width]);
        numbers[i] = d << 1 ^ (d >> 31 ? 0xFFFFFFFFU : 0U);
    }
    return numbers;
}

/// Each number of the rows as a word.
template <class Code>
std::vector<std::uint32_t> words_of(const Eigen::Ref<const DenseMatrix>& rows, Code code) {
    std::vector<std::uint32_t> words;
    words.reserve(rows.size());
    for (const double number : rows.reshaped<Eigen::RowMajor>())
        words.push_back(code(number));
    return words;
}

} // namespace

void PageData::add(std::string_view name, const std::vector<std::uint32_t>& words, int width,
                   std::string_view more) {
    if (!directory_.empty())
        directory_ += ",";
    directory_ += fmt::format("{}:{{\"at\":{},\"count\":{},\"width\":{}{}}}", json_text(name),
                              bytes_.size(), words.size(), width, more);
    bytes_.reserve(bytes_.size() + 4 * words.size());
    for (unsigned shift = 0; shift < 32; shift += 8)
        for (const std::uint32_t word : words)
            bytes_ += static_cast<char>(word >> shift & 255U);
}

void PageData::add(std::string_view name, std::span<const Index> numbers, int width) {
    add(name, differences({numbers.begin(), numbers.end()}, width), width, ",\"kind\":\"whole\"");
}

void PageData::add_floats(std::string_view name, const Eigen::Ref<const DenseMatrix>& rows) {
    const double largest = rows.size() > 0 ? rows.cwiseAbs().maxCoeff() : 0;
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    const auto words = words_of(rows, [&](double number) {
        return std::bit_cast<std::uint32_t>(static_cast<float>(std::ldexp(number, -exponent)));
    });
    // a power of two below the least number is told by its exponent
    add(name, words, static_cast<int>(rows.cols()),
        fmt::format(",\"kind\":\"float\",\"exponent\":{}", exponent));
}

void PageData::add_rounded(std::string_view name, const Eigen::Ref<const DenseMatrix>& rows,
                           int bits) {
    const double low = rows.size() > 0 ? rows.minCoeff() : 0;
    const double high = rows.size() > 0 ? rows.maxCoeff() : 0;
    const double most = std::ldexp(1.0, bits) - 1;
    const double step = high / most - low / most; // no difference that would be no number
    const auto words = words_of(rows, [&](double number) {
        const double steps = step > 0 ? std::round(number / step - low / step) : 0;
        return static_cast<std::uint32_t>(std::min(most, steps));
    });
    const int width = static_cast<int>(rows.cols());
    add(name, differences(words, width), width,
        fmt::format(",\"kind\":\"rounded\",\"low\":{},\"step\":{}", json_number(low),
                    json_number(step)));
}

std::string PageData::text() const {
    return base64_text(deflate(bytes_));
}

} // namespace polydec
