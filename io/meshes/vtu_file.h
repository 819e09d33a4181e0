// SPDX-License-Identifier: MIT
#pragma once

#include "io/meshes/vtu_arrays.h"
#include "io/source_file.h"
#include "io/xml_reader.h"

#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// The arrays of a .vtu file, located but read only on request, without empty pieces. Throws
/// InvalidInput, with the line, for a malformed file. The file must outlive this object.
class VtuFile {
public:
    struct Array {
        std::string section; ///< Points, Cells, PointData, CellData or FieldData
        VtuText array;
        int piece = 0;
    };

    explicit VtuFile(const SourceFile& file);

    const std::vector<Array>& arrays() const { return arrays_; }

    /// Some writers divide a grid into pieces, which repeat the points between them.
    int pieces() const { return pieces_; }

    /// The first array of a section with this name, or any name; null if there is none.
    const VtuText* find(std::string_view section, std::string_view name = "", int piece = 0) const;

    /// The array of this name in the section Cells, and the points, three coordinates each.
    const VtuText& cells(const char* name, int piece = 0) const;
    const VtuText& points(int piece = 0) const;

    /// Checks the sizes of all point and cell arrays against their piece, file and memory, before
    /// reading. Throws like vtu_values.
    void check(int piece = 0) const;

    /// The numbers of an array with a fixed count per point, or per cell.
    std::vector<double> values(const VtuText& array) const;

    /// The lists of all cells, one after the other, with these ends.
    std::vector<double> lists(const VtuText& array, const std::vector<double>& ends) const;

    const VtuEncoding& encoding() const { return encoding_; }

    [[noreturn]] void fail(const std::string& text) const { reader_.fail(text); }

private:
    const VtuText& needed(const VtuText* array, const char* name) const;
    void read_tag(XmlTag tag);
    void read_file_tag(const XmlTag& tag);
    void read_piece(const XmlTag& tag);
    void read_appended(const XmlTag& tag);
    void keep_array(XmlTag tag);
    void keep_text(const XmlTag& tag);

    const SourceFile& file_;
    XmlReader reader_;
    VtuEncoding encoding_;
    std::vector<Array> arrays_;
    std::size_t array_depth_ = 0;
    bool is_array_open_ = false; ///< the last one
    bool has_grid_ = false;
    bool has_appended_ = false;
    bool piece_is_empty_ = false;
    int pieces_ = 0;
    double points_ = 0, cells_ = 0; ///< of the last piece
};

} // namespace polydec
