// SPDX-License-Identifier: MIT
#include "io/base64.h"
#include "io/deflate.h"
#include "io/xml_reader.h"
#include "io/xml_text.h"
#include "tests/fuzz/targets.h"

#include <algorithm>

namespace polydec::fuzz {

void xml(std::string_view bytes) {
    const SourceFile file{"a.vtu", std::string(bytes)};
    XmlReader reader(file);
    XmlTag tag;
    const auto lines = std::count(bytes.begin(), bytes.end(), '\n') + 1;
    auto left = bytes.size();
    while (accepts([&] {
        if (!reader.next(tag))
            throw InvalidInput("the end");
    })) {
        require(reader.rest().size() < left, "each tag takes bytes");
        require(reader.text().size() <= left, "text stands in front of its tag");
        left = reader.rest().size();
        require(tag.opens || tag.closes, "a tag opens or closes its element");
        require(tag.line >= 1 && static_cast<std::ptrdiff_t>(tag.line) <= lines,
                "a tag is on one of the lines");
        for (const auto& [key, value] : tag.attributes)
            require(!key.empty() && value.size() <= bytes.size(), "attributes are in the text");
    }
}

/// Two bytes of size, then what follows the head of a zlib stream, which is always the same.
void inflate(std::string_view bytes) {
    if (bytes.size() < 2)
        return;
    const auto size = static_cast<std::size_t>(static_cast<unsigned char>(bytes[0])) |
                      static_cast<std::size_t>(static_cast<unsigned char>(bytes[1])) << 8U;
    const auto stream = "\x78\x9C" + std::string(bytes.substr(2));
    const auto result = polydec::inflate(stream, size);
    require(!result || result->size() == size, "what is inflated has the size asked for");
}

void base64(std::string_view bytes) {
    // as text, in pieces of growing size
    Base64Reader reader(bytes);
    std::string read;
    std::size_t size = 0;
    while (reader.read(size + 1, read))
        size += size + 1;
    require(3 * bytes.size() >= 4 * size, "four digits make three bytes at most");

    // as bytes, there and back
    std::string text;
    Base64Writer writer([&text](std::string_view piece) { text += piece; });
    for (const char byte : bytes)
        writer.write(byte);
    writer.finish();
    std::string back;
    require(Base64Reader(text).read(bytes.size(), back) && back == bytes,
            "bytes come back from base64");
}

} // namespace polydec::fuzz
