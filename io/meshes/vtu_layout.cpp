// SPDX-License-Identifier: MIT
#include "io/meshes/mesh_layout.h"
#include "io/meshes/vtk_cells.h"
#include "io/meshes/vtu_file.h"

#include <algorithm>

namespace polydec {

namespace {

/// The appended arrays of a file without compression: each has its number of bytes in front.
class AppendedArrays {
public:
    AppendedArrays(const PartialFile& file, const SourceFile& front, const VtuFile& vtu)
        : file_(file),
          front_(front),
          encoding_(vtu.encoding()),
          begin_(std::ssize(front.text) - std::ssize(encoding_.appended)) {}

    /// Rows of so many numbers.
    RecordTable table(const VtuText& array, int fields) const {
        const auto place = vtu_place(array, std::max<std::int64_t>(0, file_.size - begin_), front_);
        if (!place)
            refuse_layout(file_, "not all arrays are appended");
        RecordTable table = table_of(place->type, fields);
        const std::int64_t header = begin_ + static_cast<std::int64_t>(place->offset);
        const auto width = static_cast<std::int64_t>(encoding_.header_bytes);
        const auto bytes = number_of_bytes(header, width);
        const auto each = static_cast<double>(size_of(place->type));
        if (bytes > file_.size - header - width || bytes % table.reach() != 0 ||
            (array.numbers && static_cast<double>(bytes) != *array.numbers * each))
            refuse_layout(file_, "an array does not have the announced length");
        table.stretches = {{bytes / table.reach(), header + width, table.reach()}};
        return table;
    }

private:
    std::int64_t number_of_bytes(std::int64_t place, std::int64_t width) const {
        const std::string text = file_.read(place, std::min(file_.size, place + width));
        if (std::ssize(text) < width)
            refuse_layout(file_, "the file ends within an array");
        const double bytes = value_at(
            text.data(), width == 8 ? NumberType::uint64 : NumberType::uint32, encoding_.order);
        if (bytes > static_cast<double>(file_.size))
            refuse_layout(file_, "an array is longer than the file");
        return static_cast<std::int64_t>(bytes);
    }

    const PartialFile& file_;
    const SourceFile& front_;
    const VtuEncoding& encoding_;
    std::int64_t begin_;
};

/// The corners of simplices of one of VTK's types, or 0.
int corners_of(double type) {
    constexpr int line = 3, triangle = 5, tetrahedron = 10;
    return type == line ? 2 : type == triangle ? 3 : type == tetrahedron ? 4 : 0;
}

MeshLayout layout_of(const PartialFile& file, const SourceFile& front, const VtuFile& vtu) {
    if (vtu.pieces() > 1)
        refuse_layout(file, "it has several pieces");
    const AppendedArrays arrays(file, front, vtu);
    MeshLayout layout;
    layout.order = vtu.encoding().order;
    layout.points = arrays.table(vtu.points(), 3);
    const RecordTable types = arrays.table(vtu.cells("types"), 1);
    const RecordTable ends = arrays.table(vtu.cells("offsets"), 1);
    if (types.count() == 0)
        refuse_layout(file, "there are no cells");
    const double type = rows_of(types, file, layout.order, 0, 1)(0, 0);
    const int corners = corners_of(type);
    if (corners == 0)
        refuse_layout(file, "there are cells other than simplices");
    layout.cells = arrays.table(vtu.cells("connectivity"), corners);
    if (ends.count() != types.count() || layout.cells.count() != types.count())
        refuse_layout(file, "not all cells have the same number of corners");
    layout.expected = {{types, type, 0},
                       {ends, static_cast<double>(corners), static_cast<double>(corners)}};
    for (const auto& [section, array, piece] : vtu.arrays())
        if (section == "CellData" && is_tag_name(array.name())) {
            arrays.table(array, 1); // has to be there as a whole
            layout.has_tags = true;
        }
    return layout;
}

} // namespace

std::optional<MeshLayout> vtu_layout(const PartialFile& file) {
    const SourceFile front{file.name, file.read(0, std::min(file.size, longest_header))};
    const auto appended = front.text.find("<AppendedData");
    if (appended == std::string::npos)
        return std::nullopt;
    const VtuFile vtu(front);
    if (!vtu.encoding().appended_is_raw)
        return std::nullopt;
    if (vtu.encoding().is_compressed)
        refuse_layout(file, "its arrays are compressed");
    return layout_of(file, front, vtu);
}

} // namespace polydec
