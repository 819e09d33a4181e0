// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/length_mesh.h"
#include "meshes/mesh.h"
#include "meshes/polygons.h"

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

/// Writes a mesh in the format of the extension. .nsc holds every mesh, and so does .pdm (binary,
/// with the tags of cells; see PdmLayout). .mesh (MEDIT) holds edges, triangles and tetrahedra in
/// R^2 and R^3, with tags and tagged facets, but not of curves; .off, .obj, .ply and .stl (both
/// binary) hold triangles in R^2 (with z = 0) and R^3; .obj also edges. Numbers read back exactly,
/// except in STL, which has floats and no vertex numbers. Only MEDIT and .pdm keep tags. The file
/// appears whole or not at all.
///
/// Throws InvalidInput if the format cannot hold the mesh, such as two corners of a triangle with
/// the same floats in STL, for NaN or infinite coordinates, a vertex number out of range, a wrong
/// number of tags, or like check_facet_tags; IoError if writing fails.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Writes polygons as .off, .obj or .ply (binary) in R^N with N <= 3; missing coordinates become 0.
/// Throws like the other overload.
void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh);

/// Whether the extension is .nsl, in any case: the file holds lengths, no points.
bool is_length_file(const std::filesystem::path& path);

/// Reads simplices of any dimension and the lengths of their edges, in the text format .nsl:
///
///     n V S E        dimension, numbers of vertices, simplices and edges
///     v0 .. vn       S lines: a simplex by its n+1 vertices, numbered from 0; order orients it
///     a b length     E lines: every edge of the simplices exactly once, in any order
///
/// Comments begin with #. Does not check that simplices with these lengths exist; see
/// circumcentric_volumes.
/// Throws IoError if the file cannot be read, InvalidInput "path:line: what; expected; advice" if
/// it is malformed, a length is not a finite number above 0, an edge is repeated or belongs to no
/// simplex, or, naming it, an edge is missing.
LengthMesh read_lengths(const std::filesystem::path& path);

/// Writes .nsl; numbers read back exactly. The file appears whole or not at all.
/// Throws InvalidInput for another extension, like check of a LengthMesh, and for lengths that are
/// not finite numbers above 0; IoError if writing fails.
void write_lengths(const std::filesystem::path& path, const LengthMesh& mesh);

} // namespace polydec
