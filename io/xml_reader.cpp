// SPDX-License-Identifier: MIT
#include "io/xml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace polydec {

namespace {

constexpr std::string_view spaces = " \t\r\n";

/// Text with its entities resolved; others than these five are left as they are.
std::string resolved(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string result;
    while (!text.empty()) {
        const auto found =
            std::find_if(entities.begin(), entities.end(), [text](const auto& entity) {
                return text.substr(0, entity.first.size()) == entity.first;
            });
        result += found == entities.end() ? text.front() : found->second;
        text.remove_prefix(found == entities.end() ? 1 : found->first.size());
    }
    return result;
}

} // namespace

std::string XmlTag::attribute(std::string_view key, std::string_view missing) const {
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [key](const auto& one) { return one.first == key; });
    return found == attributes.end() ? std::string(missing) : found->second;
}

bool XmlReader::next(XmlTag& tag) {
    go_to_tag();
    while (starts_with("<!--") || starts_with("<?")) {
        pass_over(starts_with("<?") ? "?>" : "-->");
        go_to_tag();
    }
    if (rest().empty()) {
        if (!path_.empty())
            fail(fmt::format("the file ends within the element {}; expected its end; export it "
                             "again, it seems cut off",
                             quote_word(path_.back())));
        return false;
    }
    tag = {};
    tag.line = scanner_.line();
    tag.closes = starts_with("</");
    tag.opens = !tag.closes;
    pass(tag.closes ? 2 : 1);
    tag.name = read_name();
    read_attributes(tag);
    keep_path(tag);
    return true;
}

void XmlReader::go_to_tag() {
    const auto end = std::min(rest().find('<'), rest().size());
    text_ = rest().substr(0, end);
    text_line_ = scanner_.line();
    pass(end);
}

void XmlReader::pass_over(std::string_view end) {
    const auto place = rest().find(end);
    if (place == std::string_view::npos)
        fail(fmt::format("the file ends within a comment or declaration; expected {}; export it "
                         "again, it seems cut off",
                         end));
    pass(place + end.size());
}

void XmlReader::skip_spaces() {
    pass(std::min(rest().find_first_not_of(spaces), rest().size()));
}

bool XmlReader::starts_with(std::string_view word) const {
    return rest().substr(0, word.size()) == word;
}

std::string_view XmlReader::read_name() {
    const auto size = std::min(rest().find_first_of(" \t\r\n=/<>\"'&!?"), rest().size());
    const auto name = rest().substr(0, size);
    if (name.empty())
        fail(fmt::format(
            "found {} in place of a name; expected a tag or attribute of XML; export it again",
            quote_word(rest().substr(0, 10))));
    pass(size);
    return name;
}

std::string XmlReader::read_value() {
    skip_spaces();
    if (!starts_with("="))
        fail("an attribute has no value; expected = and a value in quotes; export it again");
    pass(1);
    skip_spaces();
    const auto end = starts_with("\"") || starts_with("'") ? rest().find(rest().front(), 1)
                                                           : std::string_view::npos;
    if (end == std::string_view::npos)
        fail("the value of an attribute is not in quotes; expected two of them; export it again");
    auto value = resolved(rest().substr(1, end - 1));
    pass(end + 1);
    return value;
}

void XmlReader::read_attributes(XmlTag& tag) {
    for (skip_spaces(); !starts_with(">"); skip_spaces()) {
        if (starts_with("/>")) {
            tag.closes = true;
            pass(1);
            break;
        }
        if (rest().empty())
            fail("the file ends within a tag; expected >; export it again, it seems cut off");
        const auto key = read_name();
        tag.attributes.emplace_back(key, read_value());
    }
    pass(1);
}

void XmlReader::keep_path(const XmlTag& tag) {
    if (tag.opens)
        path_.push_back(tag.name);
    if (tag.closes) {
        if (path_.empty() || path_.back() != tag.name)
            fail(fmt::format("the element {} ends here; expected the end of {}; export it again",
                             quote_word(tag.name),
                             path_.empty() ? "no element" : quote_word(path_.back())));
        path_.pop_back();
    }
}

} // namespace polydec
