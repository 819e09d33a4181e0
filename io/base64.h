// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace polydec {

/// Encodes numbers, lowest byte first, as base64 text and passes it to the sink in chunks.
template <typename Sink>
class Base64Writer {
public:
    explicit Base64Writer(Sink sink) : sink_(std::move(sink)) {}

    template <typename Number>
    void write(const Number& number) {
        write(std::span<const Number>(&number, 1));
    }

    template <typename Number>
    void write(std::span<const Number> numbers) {
        static_assert(piece % sizeof(Number) == 0);
        while (!numbers.empty()) {
            if (piece - size_ < sizeof(Number))
                encode(size_ / 3 * 3);
            const auto count = std::min((piece - size_) / sizeof(Number), numbers.size());
            std::memcpy(&bytes_[size_], numbers.data(), count * sizeof(Number));
            if constexpr (std::endian::native == std::endian::big)
                for (std::size_t i = 0; i < count; ++i)
                    std::reverse(&bytes_[size_ + i * sizeof(Number)],
                                 &bytes_[size_ + (i + 1) * sizeof(Number)]);
            size_ += count * sizeof(Number);
            numbers = numbers.subspan(count);
        }
    }

    /// Completes the last group of three bytes; must be called once, at the end.
    void finish() { encode(size_); }

private:
    static constexpr std::size_t piece = std::size_t{3} << 14;
    static constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    /// Passes on the first bytes, and keeps the others.
    void encode(std::size_t count) {
        char* next = text_.data();
        for (std::size_t i = 0; i < count; i += 3) {
            std::uint32_t group = 0;
            for (std::size_t b = i; b < i + 3; ++b)
                group = group << 8 | (b < count ? bytes_[b] : 0U);
            for (unsigned shift = 24; shift > 0;)
                *next++ = alphabet[group >> (shift -= 6) & 63U];
        }
        if (count % 3 > 0)
            std::fill(next - (3 - count % 3), next, '=');
        sink_(std::string_view(text_.data(), next));
        size_ -= count;
        std::memmove(bytes_.data(), &bytes_[count], size_);
    }

    Sink sink_;
    std::array<unsigned char, piece + 3> bytes_;
    std::array<char, piece / 3 * 4> text_;
    std::size_t size_ = 0; // pending bytes
};

/// Bytes as base64 text.
inline std::string base64_text(std::span<const char> bytes) {
    std::string text;
    Base64Writer writer([&](std::string_view piece) { text += piece; });
    writer.write(bytes);
    writer.finish();
    return text;
}

/// Decodes base64 text, any number of bytes at a time. Skips white space; texts may follow one
/// another, each completed by its own =.
class Base64Reader {
public:
    explicit Base64Reader(std::string_view text) : text_(text) {}

    /// Upper bound on the bytes in the rest of the text.
    std::size_t remaining() const { return waiting_.size() + text_.size(); }

    /// Appends the next bytes; returns false if the text ends too early or is not base64.
    bool read(std::size_t bytes, std::string& result) {
        if (bytes > remaining())
            return false;
        while (waiting_.size() < bytes)
            if (!read_group())
                return false;
        result.append(waiting_, 0, bytes);
        waiting_.erase(0, bytes);
        return true;
    }

private:
    /// Decodes four digits to three bytes, or to fewer if the last ones are =.
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
    std::string waiting_; ///< bytes decoded but not yet read: at most two, between calls
};

} // namespace polydec
