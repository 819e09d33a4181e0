// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_says {

const std::string message = "a.off:3: vertex number -0.42 is infinite; expected 0 to 12 tags";

TEST(Says, holds_for_words_in_their_order) {
    EXPECT_SAYS(message, "a.off:3", "vertex", "infinite", "12");
    EXPECT_SAYS(message, message);
    EXPECT_FALSE(says(message, {"vertex", "a.off:3"}));
    EXPECT_FALSE(says(message, {"vertex", "vertex"}));
    EXPECT_FALSE(says(message, {"vertex", "edge"}));
    EXPECT_FALSE(says("accepted", {"vertex"}));
    EXPECT_FALSE(says("", {"vertex"}));
}

TEST(Says, takes_whole_numbers_and_words_from_their_beginning) {
    EXPECT_SAYS(message, "-0.42", "0", "12", "tag");
    for (const char* part : {"4", "0.42", "42", "-0.4", "-0", "1", "2"})
        EXPECT_FALSE(says(message, {part})) << part;
    EXPECT_FALSE(says(message, {"a.off:3", "finite"}));
    EXPECT_FALSE(says("a.off:31: no cells", {"a.off:3"}));
    EXPECT_FALSE(says("a.off:3: no cells", {"a.off: "}));
    EXPECT_SAYS("the 2-cell 1 has a value of 1e-6.", "2-cell 1", "1e-6");
}

TEST(Says, needs_words) {
    EXPECT_FALSE(says(message, {}));
    EXPECT_FALSE(says(message, {""}));
}

TEST(Says, prints_the_message_and_the_word) {
    const std::string text = says(message, {"vertex", "edge"}).message();
    EXPECT_NE(text.find(message), std::string::npos);
    EXPECT_NE(text.find("\"edge\""), std::string::npos);
}

TEST(EachSays, needs_as_many_messages) {
    EXPECT_TRUE(each_says({"1 face", "2 edges"}, {{"1", "face"}, {"edges"}}));
    EXPECT_TRUE(each_says({"1 face"}, {{"1", "face"}}));
    EXPECT_TRUE(each_says({}, {}));
    EXPECT_FALSE(each_says({"1 face"}, {{"face"}, {"edges"}}));
    EXPECT_FALSE(each_says({"1 face", "2 edges"}, {{"face"}}));
    EXPECT_FALSE(each_says({"1 face", "2 edges"}, {{"face"}, {"vertex"}}));
}

} // namespace polydec::test::in_says
