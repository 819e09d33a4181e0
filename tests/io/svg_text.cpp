// SPDX-License-Identifier: MIT
// g++ 12 takes the states of std::regex for uninitialized where sanitizers look on
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "tests/io/svg_text.h"

#include <regex>

namespace polydec::test {

std::string flaw(const std::string& text) {
    std::vector<std::string> open;
    const std::regex tag(R"re(<(/?)([a-z]+)((?: [A-Za-z-]+="[^"<>]*")*)(/?)>)re");
    std::size_t at = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
        const auto between = text.substr(at, it->position() - at);
        if (between.find_first_of("<>") != std::string::npos)
            return "a stray bracket: " + between;
        at = it->position() + it->length();
        if ((*it)[1].length() == 0 && (*it)[4].length() == 0)
            open.push_back((*it)[2]);
        else if ((*it)[1].length() > 0) {
            if (open.empty() || open.back() != (*it)[2])
                return fmt::format("</{}> closes nothing", (*it)[2].str());
            open.pop_back();
        }
    }
    if (!open.empty())
        return fmt::format("<{}> is not closed", open.back());
    if (text.substr(at) != "\n")
        return "something behind the end: " + text.substr(at);
    return std::regex_search(text, std::regex("&(?!(amp|lt|gt|quot);)")) ? "a bare &" : "";
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
        ++found;
    return found;
}

std::vector<double> numbers_behind(const std::string& text, const std::string& mark,
                                   const std::string& attribute) {
    const auto begin = text.find(" " + attribute + "=\"", text.find(mark)) + attribute.size() + 3;
    std::string list = text.substr(begin, text.find('"', begin) - begin);
    std::replace(list.begin(), list.end(), ',', ' ');
    std::istringstream stream(list);
    return {std::istream_iterator<double>(stream), {}};
}

} // namespace polydec::test
