// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/number_type.h"
#include "io/partial_file.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Records of a binary file with the same fields, in stretches of constant stride.
struct RecordTable {
    struct Field {
        std::int64_t offset = 0; ///< in the record
        NumberType type = NumberType::float64;
    };
    struct Stretch {
        std::int64_t count = 0;  ///< of records
        std::int64_t begin = 0;  ///< byte of the file
        std::int64_t stride = 0; ///< bytes from one record to the next
    };

    std::vector<Field> fields;
    std::vector<Stretch> stretches = {};

    std::int64_t count() const;

    /// The last byte of its fields within a record, plus one.
    std::int64_t reach() const;
};

/// Contiguous fields of one type.
RecordTable table_of(NumberType type, int fields);

/// The records in [begin, end), one per row. Reads a few MiB at a time. Throws IoError, naming the
/// file, if it has become shorter.
DenseMatrix rows_of(const RecordTable& table, const PartialFile& file, std::endian order,
                    std::int64_t begin, std::int64_t end);

/// Records that must have number i equal to first + i * step; otherwise there is no layout.
struct Expectation {
    RecordTable table; ///< of one field
    double first = 0, step = 0;
};

/// The places of points and simplices in a binary file with fixed-width records, so that any range
/// can be read on its own. Found without reading records.
struct MeshLayout {
    std::endian order = std::endian::little;
    RecordTable points;                     ///< three coordinates each
    RecordTable cells;                      ///< n + 1 vertices each
    std::optional<RecordTable> nodes = {};  ///< the cells' number of each point, if not 0, 1, 2 ..
    std::vector<RecordTable> others = {};   ///< the vertices of cells outside the mesh
    std::vector<Expectation> expected = {}; ///< conditions on the records
    std::vector<std::string> warnings = {};
    bool has_tags = false; ///< whether cells have groups, which have no layout

    int dimension() const { return static_cast<int>(cells.fields.size()) - 1; }
};

/// The layout of a binary .ply of triangles, or of a binary .msh or a .vtu with appended raw
/// arrays, both of simplices; none for other formats and for text. Throws InvalidInput if records
/// have no fixed width, cells are of several kinds, or the file is damaged: read_mesh, which reads
/// the whole file, can then read it or report the error.
std::optional<MeshLayout> mesh_layout(const PartialFile& file);

/// One for each format. They search at most the first MiB for a header.
constexpr std::int64_t longest_header = 1 << 20;
std::optional<MeshLayout> ply_layout(const PartialFile& file);
std::optional<MeshLayout> gmsh_layout(const PartialFile& file);
std::optional<MeshLayout> vtu_layout(const PartialFile& file);

/// For layout readers: throws with the reason why there is no layout.
[[noreturn]] void refuse_layout(const PartialFile& file, const std::string& why);

} // namespace polydec
