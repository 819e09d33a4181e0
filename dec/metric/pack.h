// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace polydec {

/// Doubles side by side, as many as registers of every machine hold. Operations act on each double
/// separately, with identical bits.
class Pack {
public:
    static constexpr int size = 2;

    Pack() = default; // uninitialized
    Pack(double x) : lanes_(Lanes{} + x) {}
    Pack(double first, double second) : lanes_{first, second} {}

    double operator[](int lane) const { return lanes_[lane]; }

    friend void put(const Pack& pack, double* doubles) {
        std::memcpy(doubles, &pack.lanes_, sizeof pack.lanes_);
    }

    friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes_ + b.lanes_); }
    friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes_ - b.lanes_); }
    friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes_ * b.lanes_); }
    friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes_ / b.lanes_); }
    friend Pack min(const Pack& a, const Pack& b) {
        return Pack(b.lanes_ < a.lanes_ ? b.lanes_ : a.lanes_);
    }
    friend Pack max(const Pack& a, const Pack& b) {
        return Pack(a.lanes_ < b.lanes_ ? b.lanes_ : a.lanes_);
    }
    friend Pack abs(const Pack& a) {
        constexpr auto all_but_sign = std::int64_t(~std::uint64_t(0) >> 1);
        return Pack(Lanes(Bits(a.lanes_) & (Bits{} + all_but_sign)));
    }
    friend Pack where_positive(const Pack& a, const Pack& b) {
        return Pack(a.lanes_ > Lanes{} ? b.lanes_ : Lanes{});
    }
    friend Pack sqrt(const Pack& a) { return {std::sqrt(a[0]), std::sqrt(a[1])}; }

private:
    friend class UpperHalves;
    using Lanes = double __attribute__((vector_size(size * sizeof(double))));
    using Bits = std::int64_t __attribute__((vector_size(size * sizeof(double))));

    explicit Pack(const Lanes& lanes) : lanes_(lanes) {}

    Lanes lanes_;
};

/// Two packs of numbers that are not negative, in the room of one: upper halves of the doubles,
/// rounded up.
class UpperHalves {
public:
    UpperHalves() = default;
    UpperHalves(const Pack& first, const Pack& second) {
        const Words words = (up(first) & upper) | (up(second) >> 32);
        std::memcpy(words_.data(), &words, sizeof words);
    }

    Pack first() const { return Pack(Pack::Lanes(words() & upper)); }
    Pack second() const { return Pack(Pack::Lanes(words() << 32)); }

private:
    using Words = std::uint64_t __attribute__((vector_size(Pack::size * sizeof(std::uint64_t))));
    static constexpr std::uint64_t lower = 0xffffffff, upper = ~lower;

    static Words up(const Pack& pack) { return Words(pack.lanes_) + lower; }
    Words words() const {
        Words words;
        std::memcpy(&words, words_.data(), sizeof words);
        return words;
    }

    std::array<std::uint64_t, Pack::size> words_{};
};

/// b where a is positive, else 0.
inline double where_positive(double a, double b) {
    return a > 0 ? b : 0;
}

inline void put(double number, double* at) {
    *at = number;
}

} // namespace polydec
