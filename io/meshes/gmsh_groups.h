// SPDX-License-Identifier: MIT
#pragma once

#include "io/meshes/cell_lists.h"
#include "io/meshes/gmsh_source.h"
#include "meshes/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace polydec {

/// The physical groups of each entity of the model, i.e. of its points, curves, surfaces and
/// volumes. In version 4, cells inherit the group of their entity.
class GmshGroups {
public:
    /// Reads the section Entities, or PartitionedEntities, of version 4.
    void read(GmshSource& source, bool is_partitioned);

    /// The groups of the entity; {0} if it has none.
    std::span<const Index> tags_of(std::size_t dimension, std::int64_t entity) const;

private:
    void read_entity(GmshSource& source, std::size_t dimension, bool is_partitioned);

    std::array<NumberTable, CellLists::most_dimensions> lists_; ///< by dimension, of the lists
    std::vector<std::vector<Index>> tags_{{0}};
};

/// Reads the section PhysicalNames up to its end; it is text even in binary files: dimension
/// (absent in the oldest files), number, and name in quotes. Throws InvalidInput.
std::vector<GroupName> read_gmsh_names(Scanner& scanner, const GmshFormat& format);

/// The number of a physical group as a tag. A negative sign reverses the group's cells; it does not
/// make another group. Throws InvalidInput for a number that is too large.
Index group_tag(std::int64_t number, const GmshSource& source);

} // namespace polydec
