// SPDX-License-Identifier: MIT
#pragma once

#include "io/byte_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace polydec {

/// The number types of a binary array.
enum class NumberType {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

/// Their names in a format, in the same order; some have several, and some formats lack types.
using TypeNames = std::array<std::array<std::string_view, 3>, 10>;

/// The type with this name; none for other words.
inline std::optional<NumberType> type_named(std::string_view name, const TypeNames& names) {
    for (std::size_t type = 0; type < names.size() && !name.empty(); ++type)
        if (std::find(names[type].begin(), names[type].end(), name) != names[type].end())
            return static_cast<NumberType>(type);
    return std::nullopt;
}

/// Bytes of one number.
inline std::size_t size_of(NumberType type) {
    constexpr std::array<std::size_t, 10> sizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

/// The number stored at `place`. A double is exact except for integers beyond 2^53, which are
/// rounded: they exceed an Index in any case.
inline double value_at(const char* place, NumberType type, std::endian order) {
    switch (type) {
    case NumberType::int8:
        return number_at<std::int8_t>(place, order);
    case NumberType::uint8:
        return number_at<std::uint8_t>(place, order);
    case NumberType::int16:
        return number_at<std::int16_t>(place, order);
    case NumberType::uint16:
        return number_at<std::uint16_t>(place, order);
    case NumberType::int32:
        return number_at<std::int32_t>(place, order);
    case NumberType::uint32:
        return number_at<std::uint32_t>(place, order);
    case NumberType::int64:
        return static_cast<double>(number_at<std::int64_t>(place, order));
    case NumberType::uint64:
        return static_cast<double>(number_at<std::uint64_t>(place, order));
    case NumberType::float32:
        return static_cast<double>(number_at<float>(place, order));
    case NumberType::float64:
        break;
    }
    return number_at<double>(place, order);
}

} // namespace polydec
