// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/meshes/vtk_cells.h"
#include "io/meshes/vtu_file.h"
#include "io/scanner.h"

namespace polydec {

Mesh read_vtu(const SourceFile& file) {
    const VtuFile vtu(file);
    VtkArrays arrays;
    arrays.points = vtu.values(vtu.points());
    const VtuText& corners = vtu.cells("connectivity");
    arrays.corners = vtu.values(corners);
    arrays.ends = vtu.values(vtu.cells("offsets"));
    arrays.types = vtu.values(vtu.cells("types"));
    for (const auto& [section, array] : vtu.arrays())
        if (section == "CellData" && is_tag_name(array.name()) && arrays.tags.empty())
            arrays.tags = vtu.values(array);

    Scanner place(file.name, corners.text);
    place.set_line(corners.tag.line);
    return vtk_mesh(arrays, place, file);
}

} // namespace polydec
