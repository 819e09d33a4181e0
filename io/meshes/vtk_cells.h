// SPDX-License-Identifier: MIT
#pragma once

#include "io/scanner.h"
#include "io/source_file.h"
#include "meshes/mesh.h"

#include <string_view>
#include <vector>

namespace polydec {

/// The arrays that describe a grid in VTK's files, legacy and XML, as they were read. `vtk_mesh`
/// checks that they are integers and consistent.
struct VtkArrays {
    std::vector<double> points;  ///< three coordinates each
    std::vector<double> corners; ///< of the cells, one after the other
    std::vector<double> ends;    ///< for each cell, the end of its corners
    std::vector<double> types;   ///< one per cell
    std::vector<double> tags;    ///< one per cell, or empty; left out unless all are integers
};

/// The cells of the largest dimension, as a mesh; `place` is the start of the cells, for messages.
/// Strips become triangles, and polylines edges; higher-order cells are read by their corners.
/// Throws InvalidInput, naming the cell, if arrays are inconsistent or cells are not lines,
/// polygons or solids with listed shapes.
Mesh vtk_mesh(const VtkArrays& arrays, const Scanner& place, const SourceFile& file);

/// Throws InvalidInput, naming the vertex, unless all coordinates from this one on are finite;
/// `place` is the start of the points.
void check_points(const std::vector<double>& points, std::size_t begin, const Scanner& place);

/// Whether cell data of this name hold the physical group or region of each cell.
bool is_tag_name(std::string_view name);

} // namespace polydec
