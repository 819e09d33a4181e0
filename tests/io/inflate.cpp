// SPDX-License-Identifier: MIT
#include "io/deflate.h"
#include "tests/io/bytes.h"

namespace polydec::test::in_inflate {

/// What zlib 1.2.13 makes of these contents: stored, with its fixed code, with codes of their own.
struct Sample {
    std::string content;
    std::string stream;
};

std::string squares() {
    std::string text;
    for (int i = 0; i < 200; ++i)
        text += (i == 0 ? "" : " ") + std::to_string(i * i % 97);
    return text;
}

const std::string short_text = "abcabcabcabcabc, dual of dual";

std::vector<Sample> samples() {
    return {
        {short_text, from_hex("7801011d00e2ff6162636162636162636162636162632c206475616c206f6620647"
                              "5616c9ee60a6c")},
        {short_text, from_hex("78014b4c4a4e44423a0a29a589390af969601a009ee60a6c")},
        {squares(),
         from_hex(
             "78daed90098d45210c45ad1c09af2d14f06f6c0e08f80a262184e5aefd080687687252cd38f46007"
             "450ec6622549059d1c11c5fa88641647b45c053c0fe6c7a627b9d89b39c864aba6d42482ddb48c4d"
             "25219253ecc93a2cf77aeb5d7df4ab2f48a8046992e30929a7a8d21a68a39996fb9a1be106891"
             "7aa6f40631ad6c806ef57226f1d4b59ad6e49ab5ab85e7947709c45f0fdcfe4f74cfe00dbd5642d")},
        {std::string(100000, 'x'),
         from_hex("78daedc13101000000c2a0da8b6f0d0fa" + std::string(193, '0') + "8057037e2a25ba")},
    };
}

TEST(Inflate, GivesBackWhatZlibCompressed) {
    for (const auto& sample : samples())
        EXPECT_EQ(inflate(sample.stream, sample.content.size()), sample.content);
}

TEST(Inflate, RefusesAnyOtherSize) {
    for (const auto& sample : samples()) {
        EXPECT_EQ(inflate(sample.stream, sample.content.size() + 1), std::nullopt);
        EXPECT_EQ(inflate(sample.stream, sample.content.size() - 1), std::nullopt);
        EXPECT_EQ(inflate(sample.stream, std::size_t{1} << 40U), std::nullopt);
        EXPECT_EQ(inflate("", 0), std::nullopt);
    }
}

TEST(Inflate, NoDamageGoesUnnoticed) {
    for (const auto& sample : samples()) {
        const auto& stream = sample.stream;
        std::size_t refused = 0;
        for (std::size_t size = 0; size < stream.size(); ++size)
            EXPECT_EQ(inflate(stream.substr(0, size), sample.content.size()), std::nullopt);
        // Bits that nobody reads, at the end of the last byte in front of the checksum, may be any;
        // and it is all the same from where a run of equal letters is repeated.
        for (std::size_t bit = 0; bit < 8 * stream.size(); ++bit) {
            auto damaged = stream;
            damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
            const auto content = inflate(damaged, sample.content.size());
            EXPECT_TRUE(!content || *content == sample.content) << bit;
            refused += content ? 0 : 1;
        }
        EXPECT_GT(refused, 4 * stream.size());
    }
}

} // namespace polydec::test::in_inflate
