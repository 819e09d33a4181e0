// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "base/printable.h"
#include "io/pages/page.h"
#include "io/pages/page_template.h"
#include "io/pages/page_text.h"
#include "io/source_file.h"
#include "io/xml_text.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

namespace polydec {

namespace {

/// The text in HTML after the first `open`, up to the next character that ends a text or attribute;
/// empty if there is none.
std::string text_after(std::string_view page, std::string_view open) {
    const auto begin = page.find(open);
    if (begin == std::string_view::npos)
        return "";
    const std::string_view rest = page.substr(begin + open.size());
    return std::string(rest.substr(0, rest.find_first_of("<>\"'")));
}

/// The title of a page, in HTML. Throws if the text, named so, is no page of ours.
std::string title_of(std::string_view page, const std::string& name,
                     const std::filesystem::path& path = {}) {
    if (page.find("id=\"page-header\"") != std::string_view::npos)
        if (auto title = text_after(page, "<title>"); !title.empty())
            return title;
    const bool is_album = page.find("<section id=\"page-0\"") != std::string_view::npos;
    throw InvalidInput(
        fmt::format("{} {}", name,
                    is_album ? "is an album; expected a page; name the pages that the album holds"
                             : "was not written by polydec; write the page with write_page"),
        {.path = path});
}

} // namespace

std::string album_html(const std::string& title, const std::vector<std::string>& pages) {
    if (pages.empty())
        throw InvalidInput("an album needs pages: name at least one");
    std::string links, sections, chosen;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const std::string name = title_of(pages[i], fmt::format("page {} of an album", i));
        links += fmt::format("\n<a id=\"to-{0}\" href=\"#page-{0}\"><img alt=\"\" src=\"{2}\">"
                             "<span><strong>{1}</strong> {3}</span></a>",
                             i, name, text_after(pages[i], "<link rel=\"icon\" href=\""),
                             text_after(pages[i], "<meta name=\"description\" content=\""));
        chosen += fmt::format("body:has(#page-{0}:target) #to-{0} {{ font-weight: bold; }}\n", i);
        // the first one comes last, so that the choice of another can hide it
        sections.insert(0, fmt::format("\n<section id=\"page-{0}\"{1}><iframe title=\"{2}\" "
                                       "loading=\"lazy\" sandbox=\"allow-scripts\" srcdoc=\"{3}\">"
                                       "</iframe></section>",
                                       i, i == 0 ? " class=\"first\"" : "", name,
                                       xml_escaped(pages[i])));
    }
    return filled_page(page_template("album.html"),
                       {{"title", html_text(title)},
                        {"style", std::string(page_template("page.css"))},
                        {"chosen", std::move(chosen)},
                        {"links", std::move(links)},
                        {"pages", std::move(sections)}});
}

void write_album(const std::filesystem::path& path, const std::string& title,
                 const std::vector<std::filesystem::path>& pages) {
    std::vector<std::string> texts;
    for (const auto& page : pages) {
        texts.push_back(read_source_file(page).text);
        title_of(texts.back(), printable(page.string()), page);
    }
    AtomicFile file(path);
    file.write(album_html(title, texts));
    file.commit();
}

} // namespace polydec
