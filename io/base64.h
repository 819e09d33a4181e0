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
        if constexpr (std::endian::native == std::endian::big)
            std::reverse(bytes.begin(), bytes.end());
        for (const auto byte : bytes) {
            group_ = group_ << 8 | byte;
            if (++bytes_ == 3)
                put(4);
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
        for (unsigned digit = 0; digit < digits; ++digit)
            text_ += alphabet[group_ >> (18 - 6 * digit) & 63U];
        group_ = 0;
        bytes_ = 0;
    }

    Sink sink_;
    std::string text_;
    std::uint32_t group_ = 0;
    unsigned bytes_ = 0;
};

/// Turns base64 text into bytes, as many at a time as are asked for. White space is passed over,
/// and texts may follow one another, each completed by its own =.
class Base64Reader {
public:
    explicit Base64Reader(std::string_view text) : text_(text) {}

    /// Appends the next bytes; false if the text ends before, or holds what is not base64.
    bool read(std::size_t bytes, std::string& result) {
        if (bytes > waiting_.size() + text_.size())
            return false;
        while (waiting_.size() < bytes)
            if (!read_group())
                return false;
        result.append(waiting_, 0, bytes);
        waiting_.erase(0, bytes);
        return true;
    }

private:
    /// Four digits make three bytes, or fewer where the last ones are =.
    bool read_group() {
        std::uint32_t group = 0;
        int digits = 0;
        for (int place = 0; place < 4; ++place) {
            const auto begin = std::min(text_.find_first_not_of(" \t\r\n"), text_.size());
            text_.remove_prefix(begin);
            if (text_.empty())
                return false;
            const int value = digit_value(text_.front());
            const bool is_end = text_.front() == '=' && place >= 2;
            text_.remove_prefix(1);
            if (!is_end && (value < 0 || digits < place))
                return false;
            digits += is_end ? 0 : 1;
            group = group << 6 | static_cast<std::uint32_t>(is_end ? 0 : value);
        }
        for (int byte = 0; byte + 1 < digits; ++byte)
            waiting_ += static_cast<char>(group >> (16 - 8 * byte) & 255U);
        return true;
    }

    static int digit_value(char c) {
        if (c >= 'A' && c <= 'Z')
            return c - 'A';
        if (c >= 'a' && c <= 'z')
            return c - 'a' + 26;
        if (c >= '0' && c <= '9')
            return c - '0' + 52;
        return c == '+' ? 62 : c == '/' ? 63 : -1;
    }

    std::string_view text_;
    std::string waiting_; ///< bytes that were read but not asked for: at most two, between calls
};

} // namespace polydec
