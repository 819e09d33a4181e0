// SPDX-License-Identifier: MIT
#include "io/meshes/mesh_layout.h"

#include "io/source_file.h"

namespace polydec {

namespace {

void check_places(const PartialFile& file, const RecordTable& table) {
    for (const auto& run : table.runs)
        if (run.begin + (run.count - 1) * run.stride + table.reach() > file.size)
            refuse_layout(file, "the file ends within its records");
}

std::optional<MeshLayout> layout_of(const PartialFile& file) {
    const auto extension = lower_extension(file.name);
    if (extension == ".ply")
        return ply_layout(file);
    if (extension == ".msh")
        return gmsh_layout(file);
    if (extension == ".vtu")
        return vtu_layout(file);
    return std::nullopt;
}

} // namespace

std::optional<MeshLayout> mesh_layout(const PartialFile& file) {
    auto layout = layout_of(file);
    if (!layout)
        return layout;
    if (layout->points.count() == 0 || layout->cells.count() == 0)
        refuse_layout(file, "there are no vertices, or no cells");
    check_places(file, layout->points);
    check_places(file, layout->cells);
    if (layout->nodes)
        check_places(file, *layout->nodes);
    for (const auto& table : layout->others)
        check_places(file, table);
    for (const auto& expectation : layout->expected)
        check_places(file, expectation.table);
    return layout;
}

void refuse_layout(const PartialFile& file, const std::string& why) {
    refuse_contents(file.name, why);
}

} // namespace polydec
