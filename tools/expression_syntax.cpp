// SPDX-License-Identifier: MIT
#include "tools/expression_syntax.h"

#include <fmt/format.h>

#include <vector>

namespace polydec::tools {

namespace {

constexpr std::size_t longest = 10000, deepest = 200;
constexpr std::string_view characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
    "_ \t.,+-*/^()<>=!&|?:";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_word(char c) {
    return characters.substr(0, characters.find(' ')).find(c) != std::string_view::npos;
}

/// What stands between a parenthesis and its partner.
struct Level {
    bool is_argument_list = false;
    bool has_compared = false; ///< since the last operator that joins truths
};

class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    std::string run() {
        while (at_ < text_.size() && flaw_.empty())
            step();
        return flaw_;
    }

private:
    char before() const {
        const auto last = text_.substr(0, at_).find_last_not_of(" \t");
        return last == std::string_view::npos ? '\0' : text_[last];
    }

    bool takes(std::string_view token) {
        if (text_.substr(at_, token.size()) != token)
            return false;
        at_ += token.size();
        return true;
    }

    bool takes_any(std::initializer_list<std::string_view> tokens) {
        for (const auto token : tokens)
            if (takes(token))
                return true;
        return false;
    }

    void refuse(std::string_view what) {
        flaw_ = fmt::format("{} (at position {})", what, at_ + 1);
    }

    void step() {
        if (takes_any({"&&", "||", "?", ":"}))
            levels_.back().has_compared = false;
        else if (takes_any({"==", "!=", "<=", ">=", "<", ">"}))
            compare();
        else if (text_[at_] == '=')
            refuse("= assigns; write == to compare");
        else if (text_[at_] == ',')
            separate();
        else if (text_[at_] == '(')
            open();
        else if (text_[at_] == ')')
            close();
        else
            ++at_;
    }

    void compare() {
        if (levels_.back().has_compared)
            refuse("a comparison cannot be compared again: write a < x && x < b");
        levels_.back().has_compared = true;
    }

    void separate() {
        const bool digits = at_ > 0 && is_digit(text_[at_ - 1]) && at_ + 1 < text_.size() &&
                            is_digit(text_[at_ + 1]);
        if (!levels_.back().is_argument_list)
            refuse("a comma only separates arguments of functions; write decimals with a point");
        else if (digits)
            refuse("is this a decimal comma? Write a point, or a blank between two arguments");
        levels_.back().has_compared = false;
        ++at_;
    }

    void open() {
        levels_.push_back({is_word(before())});
        if (levels_.size() > deepest)
            refuse(fmt::format("more than {} nested parentheses", deepest));
        ++at_;
    }

    void close() {
        // one too many is the parser's to tell
        if (levels_.size() > 1)
            levels_.pop_back();
        ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<Level> levels_{1};
    std::string flaw_;
};

} // namespace

std::string misread_syntax(std::string_view text) {
    if (text.size() > longest)
        return fmt::format("it has {} characters; expected at most {}", text.size(), longest);
    const auto stranger = text.find_first_not_of(characters);
    if (stranger != std::string_view::npos)
        return fmt::format("the character at position {} cannot occur in an expression",
                           stranger + 1);
    return Reader(text).run();
}

} // namespace polydec::tools
