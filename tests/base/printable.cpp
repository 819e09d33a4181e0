// SPDX-License-Identifier: MIT
#include "base/printable.h"

#include "tests/support/test.h"

namespace polydec::test::in_printable {

TEST(Printable, what_can_be_shown_stays) {
    for (const std::string text : {"", "mesh.off", "größe 3 m²", "網格.obj", "🙂", "a\\b"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, what_cannot_is_escaped) {
    EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\rd");
    EXPECT_EQ(printable("\x1b[31m\x7f"), "\\x1b[31m\\x7f");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(printable("\u202egpj.off"), "\\u202egpj.off") << "turns the direction of writing";
    EXPECT_EQ(printable("a\u0085b"), "a\\u0085b");
}

TEST(Printable, bytes_that_are_no_utf8_are_told) {
    for (const std::string text :
         {"\xff", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xc3"}) {
        EXPECT_FALSE(is_utf8(text));
        EXPECT_EQ(bytes_of_character(text), 0U);
        EXPECT_TRUE(is_utf8(printable(text)));
        EXPECT_EQ(printable(text).size(), 4 * text.size());
    }
    EXPECT_TRUE(is_utf8("größe 網格 🙂"));
}

TEST(Printable, of_a_long_name_the_end_is_kept) {
    std::string name(5000, 'x');
    name += "/mesh.off";
    const auto shown = printable(name, 50);
    EXPECT_EQ(shown, "..." + name.substr(name.size() - 50));
    EXPECT_TRUE(is_utf8(printable("aé網🙂" + std::string(46, 'x') + "網", 50)));
    EXPECT_LE(printable(std::string(5000, '\n'), 50).size(), 53U);
}

TEST(Printable, messages_keep_their_lines_and_end) {
    EXPECT_EQ(printable_message("one\ntwo\x1b"), "one\ntwo\\x1b");
    EXPECT_EQ(printable_message("123456", 5), "12345 ..");
    EXPECT_EQ(printable_message("1234é", 5), "1234 ..");
}

} // namespace polydec::test::in_printable
