// SPDX-License-Identifier: MIT
#pragma once

#include "io/source_file.h"
#include "meshes/mesh.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace polydec {

/// The cells of a file that mixes dimensions, as boundaries and volumes are in one file.
class CellLists {
public:
    static constexpr int most_dimensions = 4;

    /// Appends a cell of dimension 0 to 3: a point, line, polygon or tetrahedron. The tag is the
    /// number of its physical group, 0 for none. Throws InvalidInput if the cells are too many.
    void add(int dimension, std::span<const Index> corners, Index tag, const SourceFile& file);

    /// The cells of the largest dimension that is there, on these points; none if all are points.
    /// Polygons are split, and their tags follow. Where no cell has a tag, the mesh has none. Of
    /// the cells of one dimension less it has those with a tag.
    Mesh mesh(Points points) &&;

private:
    struct List {
        std::vector<Index> corners;
        std::vector<Index> offsets{0};
        std::vector<Index> tags;
    };

    static TaggedSimplices tagged(const List& list, int corners);

    std::array<List, most_dimensions> lists_;
};

/// The number of a group that a file holds, if it is a whole one of 32 bits.
std::optional<Index> tag_from(double number);

/// No tags at all, if all are 0.
std::vector<Index> tags_or_none(std::vector<Index> tags);

} // namespace polydec
