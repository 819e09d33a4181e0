// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <filesystem>

namespace polydec {

/// Reads a mesh in the format of the extension, in any case. .off, .obj, .ply (ascii, binary of
/// both byte orders) and .stl (ascii, binary) give triangles in R^3, or in the plane or R^N if
/// points have two or N coordinates. .mesh (MEDIT, ascii), .msh (Gmsh 1, 2 to 2.2, 4.0 and 4.1,
/// text and binary), .vtk (legacy VTK, text and binary, structured grids too), .vtu (VTK's XML
/// UnstructuredGrid in every encoding, uncompressed or by zlib) and .node or .ele (TetGen,
/// Triangle; with the other file beside it, or .face) give the cells of the largest dimension:
/// solids, or else triangles and polygons, or else edges. .nsc and .pdm (binary, see PdmLayout)
/// give simplices of any dimension; for .nsl, lengths without points, use read_lengths. Physical
/// groups, references and regions become the mesh's tags.
///
/// Vertices keep their numbers, counted from 0 in the order of the file. STL files have none: equal
/// points become one vertex, numbered by first appearance. Polygons and solids are split as in
/// `split_cells`; higher-order cells are read by their corners. Warnings report both, and cells of
/// lower dimension outside the mesh. Nothing else is repaired: duplicate cells, cells without
/// volume and unused vertices are left to the checks of the complex.
///
/// Throws IoError if the file cannot be read, InvalidInput "path:line: what; expected; advice" if
/// it is malformed, has coordinates that are not finite, no vertices or no cells. For a file of
/// another format the message names that format.
Mesh read_mesh(const std::filesystem::path& path);

/// The axis, 0 to 2, that points up in files with this extension, by the convention of most
/// programs that write them: y for .obj, .ply and .off, z for all others and without extension.
int up_axis(const std::filesystem::path& path);

} // namespace polydec
