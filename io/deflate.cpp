// SPDX-License-Identifier: MIT
#include "io/deflate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <zlib.h>

namespace polydec {

std::string deflate(std::string_view bytes) {
    constexpr int level = 6, raw = -15, memory = 9;
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, raw, memory, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
    std::string result;
    std::array<char, 1 << 16> piece;
    // zlib counts what it is given in numbers that a long text would not fit in
    for (bool last = false; !last;) {
        const auto size = std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max());
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream.avail_in = static_cast<uInt>(size);
        bytes.remove_prefix(size);
        last = bytes.empty();
        do {
            stream.next_out = reinterpret_cast<Bytef*>(piece.data());
            stream.avail_out = static_cast<uInt>(piece.size());
            ::deflate(&stream, last ? Z_FINISH : Z_NO_FLUSH);
            result.append(piece.data(), piece.size() - stream.avail_out);
        } while (stream.avail_out == 0);
    }
    deflateEnd(&stream);
    return result;
}

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
