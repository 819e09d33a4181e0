// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace polydec::tools {

/// The hash SHA-256 of bytes that are added in parts.
/// Source: FIPS 180-4, sections 5 and 6.2.
class Sha256 {
public:
    void add(std::string_view bytes);

    /// The hash of all that was added, 64 hexadecimal digits. Nothing can be added afterwards.
    std::string digits();

private:
    void take_block();

    std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                           0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<std::uint8_t, 64> block_ = {};
    std::size_t filled_ = 0; // bytes of the block
    std::uint64_t total_ = 0;
};

} // namespace polydec::tools
