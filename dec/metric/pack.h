// SPDX-License-Identifier: MIT
#pragma once

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

    /// Doubles that lie side by side.
    static Pack from(const double* doubles) {
        Pack pack;
        std::memcpy(&pack.lanes_, doubles, sizeof pack.lanes_);
        return pack;
    }
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
    using Lanes = double __attribute__((vector_size(size * sizeof(double))));
    using Bits = std::int64_t __attribute__((vector_size(size * sizeof(double))));

    explicit Pack(const Lanes& lanes) : lanes_(lanes) {}

    Lanes lanes_;
};

/// b where a is positive, else 0.
inline double where_positive(double a, double b) {
    return a > 0 ? b : 0;
}

inline void put(double number, double* at) {
    *at = number;
}

} // namespace polydec
