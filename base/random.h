// SPDX-License-Identifier: MIT
#pragma once

#include "base/lists.h"

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace polydec {

/// Random numbers that are the same on every system: std fixes the engine, not its distributions.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1), a multiple of 2^-53.
    double fraction() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

    /// Uniform in the unit cube of R^n.
    Vector point(int n) {
        return Vector::NullaryExpr(n, [this](Eigen::Index) { return fraction(); });
    }

    /// Uniform among the directions of R^n: rejection sampling in the unit ball, normalized.
    Vector direction(int n) {
        while (true) {
            const Vector p = 2.0 * point(n).array() - 1.0;
            const double squared = p.squaredNorm();
            if (squared <= 1.0 && squared > 1e-4)
                return p.normalized();
        }
    }

    /// A random order of 0 .. size-1 (Fisher and Yates).
    std::vector<Index> order(Eigen::Index size) {
        std::vector<Index> result = numbers_below(size);
        for (std::size_t i = result.size(); i > 1; --i) {
            const double place = fraction() * static_cast<double>(i);
            std::swap(result[i - 1], result[static_cast<std::size_t>(place)]);
        }
        return result;
    }

private:
    std::mt19937_64 engine_;
};

/// The same for vectors that only need to have no pattern.
class Noise {
public:
    explicit Noise(std::uint32_t seed) : engine_(seed) {}

    /// Uniform in [-1/2, 1/2), multiples of 2^-32, for each entry in order.
    template <class Entries>
    void fill(Entries&& entries) {
        for (double& entry : entries)
            entry = static_cast<double>(engine_()) * 0x1p-32 - 0.5;
    }

private:
    std::mt19937 engine_;
};

} // namespace polydec
