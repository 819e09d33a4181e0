// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace polydec::test {

/// The words a message must contain: its place, numbers and one or two key words.
using Words = std::vector<std::string>;

/// Position of the first occurrence of a word at or after `from`; npos if there is none. A match
/// starts at the start of a word: "finite" is not found in "infinite", but "tag" is in "tags".
/// Numbers match as a whole: 4, 0.4 and -4 are not found in -0.42.
inline std::size_t find_word(std::string_view text, std::string_view word, std::size_t from = 0) {
    const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const auto is_part = [](char c) {
        return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
    };
    const auto begins = [&](std::size_t at) {
        const char before = at == 0 ? ' ' : text[at - 1];
        if (is_digit(word.front()) && (before == '-' || before == '+' || before == '.'))
            return false;
        return !is_part(before) || !(is_part(word.front()) || word.front() == '-');
    };
    const auto ends = [&](std::size_t at) {
        if (at == text.size() || !is_digit(word.back()))
            return true;
        return !is_part(text[at]) &&
               !(text[at] == '.' && at + 1 < text.size() && is_digit(text[at + 1]));
    };
    for (auto at = text.find(word, from); at != std::string_view::npos;
         at = text.find(word, at + 1))
        if (begins(at) && ends(at + word.size()))
            return at;
    return std::string_view::npos;
}

/// Succeeds if the message contains these words in this order; otherwise prints the message.
inline ::testing::AssertionResult says(const std::string& message, const Words& words) {
    if (words.empty())
        return ::testing::AssertionFailure() << "no words are given for: " << message;
    std::size_t from = 0;
    for (const auto& word : words) {
        const auto at = word.empty() ? std::string::npos : find_word(message, word, from);
        if (at == std::string::npos)
            return ::testing::AssertionFailure() << "\"" << word << "\" expected in: " << message;
        from = at + word.size();
    }
    return ::testing::AssertionSuccess() << message;
}

/// Expects a message to contain these words in this order.
#define EXPECT_SAYS(message, ...)                                                                  \
    EXPECT_TRUE(::polydec::test::says(message, ::polydec::test::Words{__VA_ARGS__}))

/// Succeeds if each message contains its own list of words, and there are as many of both.
inline ::testing::AssertionResult each_says(const std::vector<std::string>& messages,
                                            const std::vector<Words>& words) {
    auto failure = ::testing::AssertionFailure() << messages.size() << " messages:";
    for (const auto& message : messages)
        failure << "\n" << message;
    if (messages.size() != words.size())
        return failure << "\nexpected " << words.size();
    for (std::size_t i = 0; i < words.size(); ++i)
        if (const auto found = says(messages[i], words[i]); !found)
            return found;
    return ::testing::AssertionSuccess() << messages.size() << " messages";
}

/// Expects each message to contain its own list of words, and as many messages as lists.
#define EXPECT_EACH_SAYS(messages, ...)                                                            \
    EXPECT_TRUE(::polydec::test::each_says(messages, {__VA_ARGS__}))

} // namespace polydec::test
