// SPDX-License-Identifier: MIT
#pragma once

#include "io/source_file.h"
#include "meshes/mesh.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// The cells of a file that mixes dimensions, as boundaries and volumes are in one file.
class CellLists {
public:
    static constexpr int most_dimensions = 4;

    /// Appends a cell of dimension 0 to 3, whose number of corners tells its shape (see
    /// cell_shape): a point, line, polygon or solid. The tag is the number of its physical group, 0
    /// for none. Throws InvalidInput if the cells are too many.
    void add(int dimension, std::span<const Index> corners, Index tag, const SourceFile& file);

    /// Of the cell of this dimension added last: another group that it is in.
    void add_tag(int dimension, Index tag);

    /// Remembers that the cell added last has so many nodes besides its corners, left out here.
    void leave_out_nodes(std::size_t count) { curved_ += count > 0 ? 1 : 0; }

    /// The cells of the largest dimension that is there, on these points; none if all are points.
    /// Polygons and solids are split, and their tags follow. Where no cell has a tag, the mesh has
    /// none. Of the cells of one dimension less it has those with a tag, once for each group.
    /// Warnings count nodes that were left out, second groups of its own cells, and cells that
    /// lie beside those of the mesh.
    Mesh mesh(Points points) &&;

private:
    struct List {
        std::vector<Index> corners;
        std::vector<Index> offsets{0};
        std::vector<Index> tags;
        std::vector<std::pair<Index, Index>> more; ///< cells and other groups that they are in
    };

    List& list(int dimension) { return lists_[static_cast<std::size_t>(dimension)]; }
    std::vector<std::string> warnings_of_lesser(int dimension, Eigen::Index vertices);

    std::array<List, most_dimensions> lists_;
    std::size_t curved_ = 0;
};

/// The number of a group that a file holds, if it is a whole one of 32 bits.
std::optional<Index> tag_from(double number);

/// The warning about groups of the mesh's own cells besides their first.
std::string second_groups_warning(std::size_t count);

/// The warning about cells of which the corners alone are read.
std::string higher_order_warning(std::size_t cells);

/// No tags at all, if all are 0.
std::vector<Index> tags_or_none(std::vector<Index> tags);

} // namespace polydec
