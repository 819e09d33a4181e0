// SPDX-License-Identifier: MIT
#pragma once

#include "io/scanner.h"
#include "io/source_file.h"
#include "meshes/mesh.h"

#include <string_view>
#include <vector>

namespace polydec {

/// The arrays that describe a grid in VTK's files, old and XML, as they were read: whether they
/// are whole numbers that fit together is not known before `vtk_mesh`.
struct VtkArrays {
    std::vector<double> points;  ///< three coordinates each
    std::vector<double> corners; ///< of the cells, one after the other
    std::vector<double> ends;    ///< of each cell: where its corners end
    std::vector<double> types;   ///< of each cell
    std::vector<double> tags;    ///< of each cell, or empty; no tags unless all are whole numbers
};

/// The cells of the largest dimension, as a mesh; `place` is where the cells begin, for messages.
/// Strips become triangles, and polylines edges; of cells of higher order the corners are taken.
/// Throws InvalidInput, naming vertex or cell, if arrays do not fit together, coordinates are not
/// finite, or cells have another type than lines, polygons and solids with listed shapes.
Mesh vtk_mesh(const VtkArrays& arrays, const Scanner& place, const SourceFile& file);

/// Whether cell data of this name tells to which physical group or region a cell belongs.
bool is_tag_name(std::string_view name);

} // namespace polydec
