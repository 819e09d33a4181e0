// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <filesystem>

namespace polydec {

/// Reads a mesh; the extension says the format, in any case of its letters: .off, .obj, .ply
/// (ascii, binary of both byte orders) and .stl (ascii, binary) give triangles in R^3, or in the
/// plane or R^N where points have two or N coordinates. .mesh (MEDIT, ascii), .msh (Gmsh 1, 2 to
/// 2.2, 4.0 and 4.1, text and binary), .vtk (legacy VTK, text and binary, structured grids too),
/// .vtu (VTK's XML UnstructuredGrid in every encoding, uncompressed or by zlib) and .node or .ele
/// (TetGen, Triangle; the other file beside it, or .face) give the cells of the largest dimension:
/// solids, or else triangles and polygons, or else edges; .nsc gives simplices of any dimension
/// (.nsl, lengths without points, is for read_lengths), and so does .pdm (see PdmLayout), in
/// binary. Physical groups, references and regions become the mesh's tags.
///
/// Vertices keep their numbers, counted from 0 in the order of the file; an STL file has none, so
/// that equal points become one vertex, numbered by first appearance. Polygons and solids are split
/// as `split_cells` does; of cells of second or higher order the corners are taken. Warnings tell
/// of both, and of cells of smaller dimension beside the mesh. Nothing else is repaired: double
/// cells, cells without volume and unused vertices are left for the checks of the complex.
///
/// Throws IoError if the file cannot be read, InvalidInput "path:line: what; expected; advice" if
/// it is malformed, has coordinates that are not finite, no vertices or no cells; a file of another
/// format says which one it is.
Mesh read_mesh(const std::filesystem::path& path);

} // namespace polydec
