// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace polydec {

/// Turns numbers, lowest byte first, into base64 text and hands it on piece by piece.
template <typename Sink>
class Base64Writer {
public:
    explicit Base64Writer(Sink sink) : sink_(std::move(sink)) {}

    template <typename Number>
    void write(Number number) {
        auto bytes = std::bit_cast<std::array<unsigned char, sizeof(Number)>>(number);
        if constexpr (std::endian::native == std::endian::big) {
            std::reverse(bytes.begin(), bytes.end());
        }
        for (const auto byte : bytes) {
            group_ = group_ << 8 | byte;
            if (++bytes_ == 3) {
                put(4);
            }
        }
        if (text_.size() > piece) {
            sink_(text_);
            text_.clear();
        }
    }

    /// Completes the last group of three bytes; must be called once, at the end.
    void finish() {
        if (bytes_ > 0) {
            const unsigned digits = bytes_ + 1;
            group_ <<= 8 * (3 - bytes_);
            put(digits);
            text_.append(4 - digits, '=');
        }
        sink_(text_);
        text_.clear();
    }

private:
    static constexpr std::size_t piece = std::size_t{1} << 16;

    void put(unsigned digits) {
        constexpr std::string_view alphabet =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (unsigned digit = 0; digit < digits; ++digit) {
            text_ += alphabet[group_ >> (18 - 6 * digit) & 63U];
        }
        group_ = 0;
        bytes_ = 0;
    }

    Sink sink_;
    std::string text_;
    std::uint32_t group_ = 0;
    unsigned bytes_ = 0;
};

} // namespace polydec
