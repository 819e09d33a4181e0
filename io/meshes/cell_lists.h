// SPDX-License-Identifier: MIT
#pragma once

#include "io/source_file.h"
#include "meshes/polygons.h"

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// The cells of a file with mixed dimensions, such as volumes and their boundaries.
class CellLists {
public:
    static constexpr int most_dimensions = 4;

    /// Appends a cell of dimension 0 to 3: a point, line, polygon or solid, with its shape given by
    /// the number of corners (see cell_shape). The tag is the number of its physical group, 0 for
    /// none.
    void add(int dimension, std::span<const Index> corners, Index tag);

    /// Adds another group to the last cell of this dimension.
    void add_tag(int dimension, Index tag) {
        auto& [cells, more] = lists_[dimension];
        more.emplace_back(cells.size() - 1, tag);
    }

    /// Group numbers from a file as the tags of so many cells; all 0, with a warning, unless there
    /// is a 32-bit integer for each: others name no groups.
    std::vector<Index> tags_from(const std::vector<double>& numbers, std::size_t cells);

    /// Records that the last cell has additional nodes besides its corners, which are omitted.
    void leave_out_nodes(std::size_t count) { curved_ += count > 0 ? 1 : 0; }

    /// The mesh of the cells of largest dimension on these points; no cells if all are points.
    /// Polygons and solids are split, and their tags follow. If no cell has a tag, the mesh has
    /// none. Tagged cells of one dimension less become facet tags, once per group. Warnings count
    /// omitted nodes and groups, second groups of the mesh's own cells, and other cells of lower
    /// dimension.
    /// Throws InvalidInput, naming the file, if there are too many cells.
    Mesh mesh(Points points, const SourceFile& file) &&;

private:
    struct List {
        PolygonMesh cells;                         ///< still without points
        std::vector<std::pair<Index, Index>> more; ///< cells and their additional groups
    };

    std::vector<std::string> warnings_of_lesser(int dimension, Eigen::Index vertices) const;

    std::array<List, most_dimensions> lists_;
    std::size_t curved_ = 0;
    std::vector<std::string> warnings_; ///< about groups
};

/// The warning about groups of the mesh's own cells besides their first.
std::string second_groups_warning(std::size_t count);

/// The warning about cells read by their corners only.
std::string higher_order_warning(std::size_t cells);

} // namespace polydec
