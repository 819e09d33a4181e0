// SPDX-License-Identifier: MIT
#include "io/meshes/vtu_file.h"

#include "io/scanner.h"
#include "system/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

namespace polydec {

namespace {

/// Some writers put blanks in front of a number.
double count_in(const XmlTag& tag, std::string_view key, std::string_view missing) {
    const auto text = tag.attribute(key, missing);
    const auto begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    std::uint64_t count = 0;
    std::from_chars(text.data() + begin, text.data() + text.size(), count);
    return static_cast<double>(count);
}

} // namespace

VtuFile::VtuFile(const SourceFile& file) : file_(file), reader_(file) {
    XmlTag tag;
    while (!has_appended_ && reader_.next(tag)) {
        keep_text(tag);
        if (tag.opens)
            read_tag(std::move(tag));
    }
    if (!has_grid_)
        reader_.fail("the file has no element VTKFile; expected XML of VTK; check the format");
}

void VtuFile::read_tag(XmlTag tag) {
    if (tag.name == "VTKFile")
        read_file_tag(tag);
    else if (tag.name == "Piece")
        read_piece(tag);
    else if (tag.name == "AppendedData")
        read_appended(tag);
    else if (tag.name == "DataArray")
        keep_array(std::move(tag));
}

void VtuFile::read_file_tag(const XmlTag& tag) {
    const auto type = tag.attribute("type");
    if (type != "UnstructuredGrid")
        reader_.fail(fmt::format("a file of the type {}; expected UnstructuredGrid; convert it, "
                                 "for instance with ParaView",
                                 quote_word(type)));
    encoding_ = vtu_encoding(tag, reader_);
    has_grid_ = true;
}

void VtuFile::read_piece(const XmlTag& tag) {
    piece_is_empty_ = tag.attribute("NumberOfCells") == "0";
    points_ = count_in(tag, "NumberOfPoints", "0");
    cells_ = count_in(tag, "NumberOfCells", "0");
    pieces_ += piece_is_empty_ ? 0 : 1;
}

void VtuFile::read_appended(const XmlTag& tag) {
    const auto encoding = tag.attribute("encoding", "base64");
    const auto mark = reader_.rest().find('_');
    if ((encoding != "raw" && encoding != "base64") || mark == std::string_view::npos)
        reader_.fail(fmt::format("AppendedData in the encoding {}; expected raw or base64, and a _ "
                                 "before the data; export it again",
                                 quote_word(encoding)));
    encoding_.appended_is_raw = encoding == "raw";
    encoding_.appended = reader_.rest().substr(mark + 1);
    has_appended_ = true;
}

void VtuFile::keep_array(XmlTag tag) {
    const auto& path = reader_.path();
    const std::size_t own = tag.closes ? 0 : 1; // the element itself, if it is still open
    const std::string outer(path.size() > own ? path[path.size() - own - 1] : "");
    const auto name = tag.attribute("Name");
    const bool is_of_cells = name == "connectivity" || name == "offsets" || name == "types";
    const bool is_needed = outer == "Points" || (outer == "Cells" && is_of_cells);
    if (piece_is_empty_)
        return;
    const int piece = std::max(0, pieces_ - 1);
    if (is_needed && find(outer, outer == "Points" ? "" : name, piece) != nullptr)
        reader_.fail(fmt::format("the array {} occurs twice; expected it once; export it again",
                                 quote_word(name)));
    const bool has_text = !tag.closes;
    const auto line = tag.line;
    const bool is_of_points = outer == "Points" || outer == "PointData";
    const bool has_lists =
        outer == "Cells" && name != "offsets" && name != "types" && name != "faceoffsets";
    std::optional<double> numbers;
    if (!has_lists)
        numbers = (is_of_points ? points_ : cells_) *
                  count_in(tag, "NumberOfComponents", outer == "Points" ? "3" : "1");
    arrays_.push_back({outer, VtuText{std::move(tag), {}, line, numbers}, piece});
    is_array_open_ = has_text;
    array_depth_ = reader_.path().size();
}

/// The text of an array stands in front of its end, or of what it holds besides.
void VtuFile::keep_text(const XmlTag& tag) {
    if (!is_array_open_)
        return;
    const auto depth = reader_.path().size() + (tag.opens ? 0 : 1) - (tag.closes ? 0 : 1);
    const bool is_blank = reader_.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (depth == array_depth_ && !is_blank) {
        arrays_.back().array.text = reader_.text();
        arrays_.back().array.text_line = reader_.text_line();
    }
    if (tag.name == "DataArray" && tag.closes)
        is_array_open_ = false;
}

const VtuText* VtuFile::find(std::string_view section, std::string_view name, int piece) const {
    for (const auto& [outer, array, own_piece] : arrays_)
        if (own_piece == piece && outer == section && (name.empty() || array.name() == name))
            return &array;
    return nullptr;
}

void VtuFile::check(int piece) const {
    double bytes = 0;
    for (const auto& [outer, array, own_piece] : arrays_)
        if (own_piece == piece && (outer == "Points" || outer == "Cells"))
            bytes += check_vtu_array(array, encoding_, file_);
    check_memory(bytes, fmt::format("{}: points and cells of a piece", file_.name));
}

std::vector<double> VtuFile::values(const VtuText& array) const {
    return vtu_values(array, encoding_, file_);
}

std::vector<double> VtuFile::lists(const VtuText& array, const std::vector<double>& ends) const {
    VtuText ended = array;
    ended.numbers = ends.empty() ? 0.0 : std::max(0.0, *std::max_element(ends.begin(), ends.end()));
    return vtu_values(ended, encoding_, file_);
}

const VtuText& VtuFile::needed(const VtuText* array, const char* name) const {
    if (array == nullptr)
        reader_.fail(fmt::format("the grid has no array {}; expected Points and Cells with "
                                 "connectivity, offsets and types; export it again",
                                 name));
    return *array;
}

const VtuText& VtuFile::cells(const char* name, int piece) const {
    return needed(find("Cells", name, piece), name);
}

const VtuText& VtuFile::points(int piece) const {
    const auto* array = find("Points", "", piece);
    if (array != nullptr && array->tag.attribute("NumberOfComponents", "3") != "3")
        reader_.fail("the points do not have three components; expected three, the last may be 0; "
                     "export it again");
    return needed(array, "of points");
}

} // namespace polydec
