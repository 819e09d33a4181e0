// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/meshes/vtk_cells.h"
#include "io/meshes/vtu_arrays.h"
#include "io/scanner.h"
#include "io/xml_reader.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace polydec {

namespace {

class VtuReader {
public:
    explicit VtuReader(const SourceFile& file) : file_(file), reader_(file) {}

    Mesh read() {
        XmlTag tag;
        while (!has_appended_ && reader_.next(tag)) {
            keep_text(tag);
            if (tag.opens)
                read_tag(std::move(tag));
        }
        if (!has_grid_)
            reader_.fail("the file has no element VTKFile; expected XML of VTK; check the format");
        return mesh();
    }

private:
    /// The arrays of the grid, where they were found.
    struct Places {
        std::optional<VtuText> points, corners, ends, types, tags;
    };

    void read_tag(XmlTag tag) {
        const auto outer = outer_element(tag);
        if (tag.name == "VTKFile")
            read_file_tag(tag);
        else if (tag.name == "Piece")
            read_piece(tag);
        else if (tag.name == "AppendedData")
            read_appended(tag);
        else if (tag.name == "DataArray")
            keep_array(std::move(tag), outer);
    }

    /// The element around the one that this tag opened, and may have closed.
    std::string_view outer_element(const XmlTag& tag) const {
        const auto& path = reader_.path();
        const std::size_t own = tag.closes ? 0 : 1;
        return path.size() > own ? path[path.size() - own - 1] : std::string_view();
    }

    void read_file_tag(const XmlTag& tag) {
        const auto type = tag.attribute("type");
        if (type != "UnstructuredGrid") {
            reader_.fail(
                fmt::format("a file of the type {}; expected UnstructuredGrid; convert it, "
                            "for instance with ParaView",
                            quote_word(type)));
        }
        encoding_ = vtu_encoding(tag, reader_);
        has_grid_ = true;
    }

    /// Neighboring pieces repeat the points between them, so that they would come apart.
    void read_piece(const XmlTag& tag) {
        piece_is_empty_ = tag.attribute("NumberOfCells") == "0";
        pieces_ += piece_is_empty_ ? 0 : 1;
        if (pieces_ > 1) {
            reader_.fail("a second piece of the grid; expected one; merge them into one, for "
                         "instance with ParaView's filters Merge Blocks and Clean to Grid");
        }
    }

    void read_appended(const XmlTag& tag) {
        const auto encoding = tag.attribute("encoding", "base64");
        const auto mark = reader_.rest().find('_');
        if ((encoding != "raw" && encoding != "base64") || mark == std::string_view::npos) {
            reader_.fail(fmt::format("AppendedData in the encoding {}; expected raw or base64, and "
                                     "a _ in front of the data; export it again",
                                     quote_word(encoding)));
        }
        encoding_.appended_is_raw = encoding == "raw";
        encoding_.appended = reader_.rest().substr(mark + 1);
        has_appended_ = true;
    }

    void keep_array(XmlTag tag, std::string_view outer) {
        const auto name = tag.attribute("Name");
        std::optional<VtuText>* place = nullptr;
        if (piece_is_empty_)
            return;
        if (outer == "Points") {
            place = &places_.points;
        } else if (outer == "Cells") {
            place = name == "connectivity" ? &places_.corners
                    : name == "offsets"    ? &places_.ends
                    : name == "types"      ? &places_.types
                                           : nullptr;
        } else if (outer == "CellData" && is_tag_name(name) && !places_.tags) {
            place = &places_.tags;
        }
        if (place != nullptr && place->has_value()) {
            reader_.fail(fmt::format("the array {} is there a second time; expected one; export "
                                     "it again",
                                     quote_word(name)));
        }
        if (place != nullptr) {
            const bool has_text = !tag.closes;
            const auto line = tag.line;
            place->emplace(VtuText{std::move(tag), {}, line});
            open_array_ = has_text ? &**place : nullptr;
            array_depth_ = reader_.path().size();
        }
    }

    /// The text of an array stands in front of its end, or of what it holds besides.
    void keep_text(const XmlTag& tag) {
        if (open_array_ == nullptr)
            return;
        const auto depth = reader_.path().size() + (tag.opens ? 0 : 1) - (tag.closes ? 0 : 1);
        const bool is_blank = reader_.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
        if (depth == array_depth_ && !is_blank) {
            open_array_->text = reader_.text();
            open_array_->text_line = reader_.text_line();
        }
        if (tag.name == "DataArray" && tag.closes)
            open_array_ = nullptr;
    }

    std::vector<double> values(const std::optional<VtuText>& array, const char* name) const {
        if (!array) {
            reader_.fail(fmt::format("the grid has no array {}; expected Points and Cells with "
                                     "connectivity, offsets and types; export it again",
                                     name));
        }
        return vtu_values(*array, encoding_, file_);
    }

    Mesh mesh() const {
        VtkArrays arrays;
        if (places_.points && places_.points->tag.attribute("NumberOfComponents", "3") != "3") {
            reader_.fail("the points have not three components; expected three, the last may be "
                         "0; export it again");
        }
        arrays.points = values(places_.points, "of points");
        arrays.corners = values(places_.corners, "connectivity");
        arrays.ends = values(places_.ends, "offsets");
        arrays.types = values(places_.types, "types");
        arrays.tags = places_.tags ? values(places_.tags, "of tags") : std::vector<double>();

        Scanner place(file_.name, places_.corners->text);
        place.set_line(places_.corners->tag.line);
        return vtk_mesh(arrays, place, file_);
    }

    const SourceFile& file_;
    XmlReader reader_;
    VtuEncoding encoding_;
    Places places_;
    VtuText* open_array_ = nullptr;
    std::size_t array_depth_ = 0;
    bool has_grid_ = false;
    bool has_appended_ = false;
    bool piece_is_empty_ = false;
    int pieces_ = 0;
};

} // namespace

Mesh read_vtu(const SourceFile& file) {
    return VtuReader(file).read();
}

} // namespace polydec
