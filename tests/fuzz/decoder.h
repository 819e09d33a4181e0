// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace polydec::fuzz {

/// Makes small numbers of bytes, one after the other; zeros behind their end.
class Decoder {
public:
    explicit Decoder(std::string_view bytes) : bytes_(bytes) {}

    int byte() {
        if (bytes_.empty())
            return 0;
        const auto first = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return first;
    }

    /// A number from 0 to `count` - 1.
    int below(int count) { return byte() % count; }

    /// A number with few digits, where a byte 255 is followed by any double.
    double real() {
        const int first = byte();
        if (first < 255)
            return (first % 32 - 16) / 4.0;
        double number = 0;
        const auto size = std::min(bytes_.size(), sizeof(number));
        std::memcpy(&number, bytes_.data(), size);
        bytes_.remove_prefix(size);
        return number;
    }

    /// The bytes that are left as rows of `corners` numbers below `vertices`; with a byte 255, one
    /// that is not.
    Simplices simplices(int corners, int vertices) {
        const auto rows = static_cast<Eigen::Index>(bytes_.size()) / corners;
        Simplices result(rows, corners);
        for (Index& vertex : result.reshaped<Eigen::RowMajor>()) {
            const int number = byte();
            vertex = number == 255 ? -1 : number % vertices;
        }
        return result;
    }

private:
    std::string_view bytes_;
};

} // namespace polydec::fuzz
