// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/meshes/vtk_cells.h"
#include "io/meshes/vtu_file.h"
#include "io/scanner.h"

namespace polydec {

Mesh read_vtu(const SourceFile& file) {
    const VtuFile vtu(file);
    VtkArrays arrays;
    arrays.points = vtu.points();
    const VtuText* corners = vtu.find("Cells", "connectivity");
    arrays.corners = vtu.values(corners, "connectivity");
    arrays.ends = vtu.values(vtu.find("Cells", "offsets"), "offsets");
    arrays.types = vtu.values(vtu.find("Cells", "types"), "types");
    for (const auto& [section, array] : vtu.arrays())
        if (section == "CellData" && is_tag_name(array.name()) && arrays.tags.empty())
            arrays.tags = vtu.values(&array, "of tags");

    Scanner place(file.name, corners->text);
    place.set_line(corners->tag.line);
    return vtk_mesh(arrays, place, file);
}

} // namespace polydec
