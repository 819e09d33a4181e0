// SPDX-License-Identifier: MIT
#pragma once

#include "io/source_file.h"
#include "meshes/length_mesh.h"
#include "meshes/mesh.h"
#include "meshes/polygons.h"

#include <cstddef>
#include <vector>

namespace polydec {

class Scanner;

/// `read_mesh`, after the file was read.
Mesh parse_mesh(const SourceFile& file);

/// `read_lengths`, after the file was read.
LengthMesh parse_lengths(const SourceFile& file);

/// One reader per format. They throw InvalidInput, with the line, where the file does not fit; that
/// there are vertices and cells at all is left to `parse_mesh`.
Mesh read_off(const SourceFile& file);
Mesh read_obj(const SourceFile& file);
Mesh read_ply(const SourceFile& file);
Mesh read_stl(const SourceFile& file);
Mesh read_nsc(const SourceFile& file);
Mesh read_medit(const SourceFile& file);
Mesh read_gmsh(const SourceFile& file);
Mesh read_vtk(const SourceFile& file);
Mesh read_vtu(const SourceFile& file);
Mesh read_pdm(const SourceFile& file);

/// `write_mesh` of what has been checked.
void write_pdm(const std::filesystem::path& path, const Mesh& mesh);

/// The lines of .nsc and .nsl that hold simplices of this dimension, numbered from 0.
Simplices read_simplices(Scanner& scanner, Index count, Index dimension, Index vertices);

/// TetGen's meshes are two files: reads the other one too, which must be beside this one.
Mesh read_tetgen(const SourceFile& file);

/// The same from a .node file and an .ele or .face file that were read.
Mesh parse_tetgen(const SourceFile& nodes, const SourceFile& cells);

/// Makes room for faces, mostly triangles, but not for more than `remaining` bytes can hold.
void reserve_faces(PolygonMesh& polygons, Index faces, std::size_t remaining);

/// Ends the face whose corners were appended last. Throws InvalidInput if they are too many.
void close_face(PolygonMesh& polygons, const SourceFile& file);

/// A number of cells or vertices that was found rather than promised, as an Index.
/// Throws InvalidInput, with the plural, where it does not fit.
Index checked_count(std::size_t count, const char* plural, const SourceFile& file);

/// The coordinates, three of each vertex, as points.
Points points_from(const std::vector<double>& coordinates);

} // namespace polydec
