// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace polydec {

/// A number with twice the digits of a double: the sum of two doubles, the second below the last
/// digit of the first. Sums and products have errors of a few 1e-32. For computations with
/// cancellation. Source: Dekker 1971.
class TwoDoubles {
public:
    TwoDoubles(double x = 0) : high_(x) {}

    explicit operator double() const { return high_; }

    /// a - b, exactly.
    static TwoDoubles difference(double a, double b) { return sum(a, -b); }

    friend TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
        const TwoDoubles high = sum(a.high_, b.high_), low = sum(a.low_, b.low_);
        const TwoDoubles middle = quick_sum(high.high_, high.low_ + low.high_);
        return quick_sum(middle.high_, middle.low_ + low.low_);
    }
    friend TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b) {
        return a + TwoDoubles(-b.high_, -b.low_);
    }
    friend TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
        const TwoDoubles high = product(a.high_, b.high_);
        return quick_sum(high.high_, high.low_ + (a.high_ * b.low_ + a.low_ * b.high_));
    }
    friend TwoDoubles operator/(const TwoDoubles& a, const TwoDoubles& b) {
        const double first = a.high_ / b.high_;
        const TwoDoubles rest = a - b * first;
        const double second = rest.high_ / b.high_;
        const double third = (rest - b * second).high_ / b.high_;
        return quick_sum(first, second) + third;
    }
    friend TwoDoubles sqrt(const TwoDoubles& a) {
        if (!(a.high_ > 0))
            return 0;
        const double root = std::sqrt(a.high_);
        return quick_sum(root, (a - product(root, root)).high_ / (2 * root));
    }

private:
    TwoDoubles(double high, double low) : high_(high), low_(low) {}

    static TwoDoubles sum(double a, double b) {
        const double s = a + b, part = s - a;
        return {s, (a - (s - part)) + (b - part)};
    }
    /// The same for |a| >= |b|.
    static TwoDoubles quick_sum(double a, double b) {
        const double s = a + b;
        return {s, b - (s - a)};
    }
    static TwoDoubles product(double a, double b) {
        const auto [a1, a2] = halves(a);
        const auto [b1, b2] = halves(b);
        const double p = a * b;
        return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
    }
    struct Halves {
        double first, second;
    };
    static Halves halves(double a) {
        const double t = 134217729.0 * a, first = t - (t - a); // 2^27 + 1
        return {first, a - first};
    }

    double high_, low_ = 0;
};

} // namespace polydec
