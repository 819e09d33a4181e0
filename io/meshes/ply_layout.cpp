// SPDX-License-Identifier: MIT
#include "io/meshes/mesh_layout.h"
#include "io/meshes/ply_header.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// Where each property begins in a record, and behind them its end. Lists have this length.
std::vector<std::int64_t> offsets_of(const PlyElement& element, int length) {
    std::vector<std::int64_t> offsets{0};
    for (const auto& property : element.properties) {
        const auto each = static_cast<std::int64_t>(size_of(property.type));
        const auto front = static_cast<std::int64_t>(size_of(property.length_type));
        offsets.push_back(offsets.back() + (property.is_list ? front + length * each : each));
    }
    return offsets;
}

RecordTable points_of(const PartialFile& file, const PlyElement& element, std::int64_t begin) {
    const auto offsets = offsets_of(element, 0);
    RecordTable table;
    for (const char* axis : {"x", "y", "z"}) {
        const auto place = element.find(axis);
        if (place == element.properties.size())
            refuse_layout(file, "vertices lack coordinates");
        table.fields.push_back({offsets[place], element.properties[place].type});
    }
    table.stretches = {{element.count, begin, offsets.back()}};
    return table;
}

/// The corners of triangles; and that there are three of each is expected.
void add_faces(MeshLayout& layout, const PlyElement& element, std::int64_t begin) {
    constexpr int corners = 3;
    const auto offsets = offsets_of(element, corners);
    const auto& list = element.properties[element.corners()];
    const std::int64_t length = offsets[element.corners()];
    const std::int64_t first = length + static_cast<std::int64_t>(size_of(list.length_type));
    layout.cells = table_of(list.type, corners);
    for (auto& field : layout.cells.fields)
        field.offset += first;
    layout.cells.stretches = {{element.count, begin, offsets.back()}};
    layout.expected.push_back({{{{length, list.length_type}}, layout.cells.stretches}, corners, 0});
}

void check_lists(const PartialFile& file, const PlyElement& element) {
    const auto lists = std::count_if(element.properties.begin(), element.properties.end(),
                                     [](const PlyProperty& property) { return property.is_list; });
    const auto list = element.corners();
    const bool has_corners = element.name == "face" && list < element.properties.size() &&
                             element.properties[list].is_list;
    if (lists != (has_corners ? 1 : 0) || (element.name == "face" && !has_corners))
        refuse_layout(file, fmt::format("the records of {} have no fixed width", element.name));
}

} // namespace

std::optional<MeshLayout> ply_layout(const PartialFile& file) {
    const SourceFile front{file.name, file.read(0, std::min(file.size, longest_header))};
    const auto header =
        read_ply_header(front, static_cast<std::size_t>(file.size) - front.text.size());
    if (!header.order)
        return std::nullopt;
    MeshLayout layout;
    layout.order = *header.order;
    auto place = static_cast<std::int64_t>(header.body_begin);
    for (const auto& element : header.elements) {
        check_lists(file, element);
        if (element.name == "vertex")
            layout.points = points_of(file, element, place);
        else if (element.name == "face")
            add_faces(layout, element, place);
        place += element.count * offsets_of(element, 3).back();
    }
    if (place > file.size)
        refuse_layout(file, "not all faces are triangles, or the file is cut off");
    if (place < file.size)
        layout.warnings.push_back(
            fmt::format("left out {} bytes after the last element", file.size - place));
    return layout;
}

} // namespace polydec
