// SPDX-License-Identifier: MIT
#include "io/inflate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace polydec {

namespace {

struct Damaged {};

/// Bits from the lowest of each byte on.
class BitReader {
public:
    explicit BitReader(std::string_view bytes) : bytes_(bytes) {}

    unsigned bits(unsigned count) {
        while (filled_ < count) {
            buffer_ |= std::uint32_t{next_byte()} << filled_;
            filled_ += 8;
        }
        const auto result = buffer_ & ((1U << count) - 1U);
        buffer_ >>= count;
        filled_ -= count;
        return result;
    }

    /// Whole bytes, after what is left of the current one.
    unsigned char byte() {
        buffer_ = 0;
        filled_ = 0;
        return next_byte();
    }

private:
    unsigned char next_byte() {
        if (bytes_.empty()) {
            throw Damaged();
        }
        const auto byte = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return byte;
    }

    std::string_view bytes_;
    std::uint32_t buffer_ = 0;
    unsigned filled_ = 0;
};

/// A Huffman code is known by the lengths of its words: of one length they are numbered one after
/// the other, in the order of their symbols (RFC 1951, section 3.2.2).
class HuffmanCode {
public:
    explicit HuffmanCode(std::span<const std::uint8_t> lengths) {
        for (const auto length : lengths) {
            ++counts_[length];
        }
        counts_[0] = 0;
        std::array<std::size_t, longest + 2> begins{};
        std::partial_sum(counts_.begin(), counts_.end(), begins.begin() + 1);
        symbols_.resize(begins.back());
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
            if (lengths[symbol] > 0) {
                symbols_[begins[lengths[symbol]]++] = static_cast<unsigned>(symbol);
            }
        }
    }

    /// Reads a word bit by bit. Below the first word of each length are those that begin with
    /// shorter ones.
    unsigned read(BitReader& reader) const {
        std::size_t word = 0;
        std::size_t first = 0;
        std::size_t begin = 0;
        for (std::size_t length = 1; length <= longest; ++length) {
            word = word << 1U | reader.bits(1);
            first <<= 1U;
            if (word < first) {
                throw Damaged();
            }
            if (word - first < counts_[length]) {
                return symbols_[begin + word - first];
            }
            first += counts_[length];
            begin += counts_[length];
        }
        throw Damaged();
    }

private:
    static constexpr std::size_t longest = 15;
    std::array<std::size_t, longest + 1> counts_{};
    std::vector<unsigned> symbols_;
};

struct Codes {
    HuffmanCode literals, distances;
};

Codes fixed_codes() {
    std::array<std::uint8_t, 288> lengths{};
    std::fill(lengths.begin(), lengths.begin() + 144, std::uint8_t{8});
    std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
    std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
    std::fill(lengths.begin() + 280, lengths.end(), std::uint8_t{8});
    std::array<std::uint8_t, 30> distances{};
    distances.fill(5);
    return {HuffmanCode(lengths), HuffmanCode(distances)};
}

/// The lengths of both codes are themselves written in a code, with words for repeated ones.
Codes read_codes(BitReader& reader) {
    const auto literals = reader.bits(5) + 257;
    const auto distances = reader.bits(5) + 1;
    const auto words = reader.bits(4) + 4;
    constexpr std::array<std::uint8_t, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                 11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::array<std::uint8_t, 19> short_lengths{};
    for (unsigned i = 0; i < words; ++i) {
        short_lengths[order[i]] = static_cast<std::uint8_t>(reader.bits(3));
    }
    const HuffmanCode code(short_lengths);
    std::vector<std::uint8_t> lengths;
    while (lengths.size() < literals + distances) {
        const auto word = code.read(reader);
        if (word < 16) {
            lengths.push_back(static_cast<std::uint8_t>(word));
            continue;
        }
        if (word == 16 && lengths.empty()) {
            throw Damaged();
        }
        const auto repeated = word == 16 ? lengths.back() : std::uint8_t{0};
        const auto times = word == 16   ? 3 + reader.bits(2)
                           : word == 17 ? 3 + reader.bits(3)
                                        : 11 + reader.bits(7);
        lengths.insert(lengths.end(), times, repeated);
    }
    if (lengths.size() > literals + distances) {
        throw Damaged();
    }
    const std::span all(lengths);
    return {HuffmanCode(all.first(literals)), HuffmanCode(all.subspan(literals))};
}

/// Writes what one stream holds into a text of known size.
class Inflater {
public:
    Inflater(std::string_view stream, std::size_t size) : reader_(stream), size_(size) {
        result_.reserve(size);
    }

    std::string run() {
        const unsigned method = reader_.byte();
        const unsigned flags = reader_.byte();
        if ((method & 15U) != 8 || (method << 8U | flags) % 31 != 0 || (flags & 32U) != 0) {
            throw Damaged();
        }
        bool is_last = false;
        while (!is_last) {
            is_last = reader_.bits(1) != 0;
            read_block(reader_.bits(2));
        }
        if (result_.size() != size_ || read_checksum() != checksum()) {
            throw Damaged();
        }
        return std::move(result_);
    }

private:
    void read_block(unsigned kind) {
        switch (kind) {
        case 0:
            return copy_stored();
        case 1:
            return decode(fixed_codes());
        case 2:
            return decode(read_codes(reader_));
        default:
            throw Damaged();
        }
    }

    void put(char byte) {
        if (result_.size() == size_) {
            throw Damaged();
        }
        result_ += byte;
    }

    void copy_stored() {
        unsigned length = reader_.byte();
        length |= unsigned{reader_.byte()} << 8U;
        unsigned complement = reader_.byte();
        complement |= unsigned{reader_.byte()} << 8U;
        if ((length ^ complement) != 0xFFFFU) {
            throw Damaged();
        }
        for (unsigned i = 0; i < length; ++i) {
            put(static_cast<char>(reader_.byte()));
        }
    }

    void decode(const Codes& codes) {
        constexpr unsigned end_of_block = 256;
        for (auto symbol = codes.literals.read(reader_); symbol != end_of_block;
             symbol = codes.literals.read(reader_)) {
            if (symbol < end_of_block) {
                put(static_cast<char>(symbol));
            } else {
                const auto length = read_length(symbol - end_of_block - 1);
                repeat(length, read_distance(codes.distances.read(reader_)));
            }
        }
    }

    /// Lengths and distances grow by powers of two, with bits in between (section 3.2.5).
    std::size_t read_length(unsigned symbol) {
        if (symbol > 28) {
            throw Damaged();
        }
        if (symbol < 8 || symbol == 28) {
            return symbol == 28 ? 258 : 3 + symbol;
        }
        const auto bits = symbol / 4 - 1;
        return 3 + ((4 + symbol % 4) << bits) + reader_.bits(bits);
    }

    std::size_t read_distance(unsigned symbol) {
        if (symbol > 29) {
            throw Damaged();
        }
        if (symbol < 4) {
            return 1 + symbol;
        }
        const auto bits = symbol / 2 - 1;
        return 1 + ((2 + symbol % 2) << bits) + reader_.bits(bits);
    }

    void repeat(std::size_t length, std::size_t distance) {
        if (distance > result_.size()) {
            throw Damaged();
        }
        for (std::size_t i = 0; i < length; ++i) {
            put(result_[result_.size() - distance]);
        }
    }

    std::uint32_t read_checksum() {
        std::uint32_t sum = 0;
        for (int i = 0; i < 4; ++i) {
            sum = sum << 8U | reader_.byte();
        }
        return sum;
    }

    /// Adler-32: the sum of the bytes, and the sum of these sums.
    std::uint32_t checksum() const {
        constexpr std::uint32_t prime = 65521;
        std::uint32_t low = 1;
        std::uint32_t high = 0;
        for (const char c : result_) {
            low = (low + static_cast<unsigned char>(c)) % prime;
            high = (high + low) % prime;
        }
        return high << 16U | low;
    }

    BitReader reader_;
    std::size_t size_;
    std::string result_;
};

} // namespace

std::optional<std::string> inflate(std::string_view stream, std::size_t size) {
    constexpr std::size_t most_bytes_per_byte = 1032;
    if (size / most_bytes_per_byte > stream.size()) {
        return std::nullopt;
    }
    try {
        return Inflater(stream, size).run();
    } catch (const Damaged&) {
        return std::nullopt;
    }
}

} // namespace polydec
