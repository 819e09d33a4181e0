// SPDX-License-Identifier: MIT
#include "tools/picture.h"

#include "io/source_file.h"

#include <string_view>
#include <utility>
#include <vector>

namespace polydec::tools {

namespace {

std::string& kept_command() {
    static std::string text;
    return text;
}

/// As a shell would take it for one word.
std::string quoted(std::string_view word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456"
                                       "789_-+=./:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos)
        return std::string(word);
    std::string result = "'";
    for (const char c : word)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

} // namespace

void set_command_text(int argc, const char* const* argv) {
    auto& text = kept_command();
    text = "polydec";
    for (int i = 1; i < argc; ++i)
        text += " " + quoted(argv[i]);
}

const std::string& command_text() {
    return kept_command();
}

bool is_page(const std::filesystem::path& out) {
    return lower_extension(out) == ".html";
}

void write_picture(const std::filesystem::path& out, Page page, const Log& log) {
    if (!is_page(out))
        return write_vtu(out, page.grid);
    page.text.command = command_text();
    append(page.text.warnings, log.warnings);
    write_page(out, page);
}

void write_picture(const std::filesystem::path& out, const Discretization& mesh,
                   const std::vector<NamedForm>& forms, PageText text, const Log& log) {
    Page page = draw_page(mesh, forms);
    std::swap(page.text, text);
    append(page.text.facts, text.facts);
    write_picture(out, std::move(page), log);
}

} // namespace polydec::tools
