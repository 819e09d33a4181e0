// SPDX-License-Identifier: MIT
#include "io/inflate.h"

#include <limits>
#include <new>
#include <zlib.h>

namespace polydec {

std::optional<std::string> inflate(std::string_view stream, std::size_t size) {
    constexpr std::size_t most = std::numeric_limits<uLong>::max();
    if (size / most_inflated_per_byte > stream.size() || size > most || stream.size() > most)
        return std::nullopt;
    std::string result(size, '\0');
    uLongf written = size;
    const int outcome = ::uncompress(reinterpret_cast<Bytef*>(result.data()), &written,
                                     reinterpret_cast<const Bytef*>(stream.data()), stream.size());
    if (outcome == Z_MEM_ERROR)
        throw std::bad_alloc();
    if (outcome != Z_OK || written != size)
        return std::nullopt;
    return result;
}

} // namespace polydec
