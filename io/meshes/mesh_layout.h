// SPDX-License-Identifier: MIT
#pragma once

#include "io/meshes/record_table.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Records of which number i has to be first + i * step, or else the layout is none.
struct Expectation {
    RecordTable table; ///< of one field
    double first = 0, step = 0;
};

/// Where the points and simplices of a binary file stand whose records have fixed widths, so that
/// any stretch of them can be read by itself. All of it is found without reading records.
struct MeshLayout {
    std::endian order = std::endian::little;
    RecordTable points;                     ///< three coordinates each
    RecordTable cells;                      ///< n + 1 vertices each
    std::optional<RecordTable> nodes = {};  ///< what cells call each point, if not 0, 1, 2 ..
    std::vector<RecordTable> others = {};   ///< cells that are not of the mesh: their vertices
    std::vector<Expectation> expected = {}; ///< what has to be so in the records
    std::vector<std::string> warnings = {};

    int dimension() const { return static_cast<int>(cells.fields.size()) - 1; }
};

/// The layout of a binary .ply of triangles, of a binary .msh or a .vtu with appended raw arrays,
/// both of simplices; nothing for other formats and for text. Throws InvalidInput where records
/// have no fixed width, cells are none of one kind, or the file is damaged: then read_mesh, which
/// reads it as a whole, knows what to make of it, or what to say.
std::optional<MeshLayout> mesh_layout(const PartialFile& file);

/// One for each format. They look at no more than the first MiB for a header.
constexpr std::int64_t longest_header = 1 << 20;
std::optional<MeshLayout> ply_layout(const PartialFile& file);
std::optional<MeshLayout> gmsh_layout(const PartialFile& file);
std::optional<MeshLayout> vtu_layout(const PartialFile& file);

/// For the readers of layouts: why there is none.
[[noreturn]] void refuse_layout(const PartialFile& file, const std::string& why);

} // namespace polydec
