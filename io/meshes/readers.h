// SPDX-License-Identifier: MIT
#pragma once

#include "io/source_file.h"
#include "meshes/length_mesh.h"
#include "meshes/mesh.h"
#include "meshes/polygons.h"

#include <cstddef>
#include <string>
#include <vector>

namespace polydec {

class Scanner;

/// `read_mesh` for a file in memory.
Mesh parse_mesh(const SourceFile& file);

/// `read_lengths` for a file in memory.
LengthMesh parse_lengths(const SourceFile& file);

/// One reader per format. They throw InvalidInput, with the line, for malformed files; `parse_mesh`
/// checks that there are vertices and cells.
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

/// Describes a file whose first bytes show another format than its extension, with advice, such as
/// "a pointer of Git LFS; run git lfs pull"; empty otherwise.
std::string foreign_format(const SourceFile& file);

/// `write_mesh` of a checked mesh.
void write_pdm(const std::filesystem::path& path, const Mesh& mesh);

/// Reads lines of .nsc and .nsl with simplices of this dimension, numbered from 0.
Simplices read_simplices(Scanner& scanner, Index count, Index dimension, Index vertices);

/// TetGen's meshes are several files: also reads those beside this one, .node and at least one of
/// .ele, .face and .edge.
Mesh read_tetgen(const SourceFile& file);

/// The same from a .node file and .ele, .face and .edge files in memory.
Mesh parse_tetgen(const SourceFile& nodes, const std::vector<SourceFile>& files);

/// Throws InvalidInput unless the file ends behind so many records, announced in its first line.
void end_records(Scanner& scanner, Index count, const char* plural);

/// Reserves memory for faces, mostly triangles, but for no more than `remaining` bytes can hold.
void reserve_faces(PolygonMesh& polygons, Index faces, std::size_t remaining);

/// Ends the face that was appended last. Throws InvalidInput if there are too many corners.
void close_face(PolygonMesh& polygons, const SourceFile& file);

/// A curve: an edge from each corner of an open polygon to the next one.
Mesh segments_of(const PolygonMesh& lines);

/// A counted number of cells or vertices as an Index. Throws InvalidInput, with the plural, if it
/// does not fit.
Index checked_count(std::size_t count, const char* plural, const SourceFile& file);

/// The coordinates, three per vertex, as points.
Points points_from(const std::vector<double>& coordinates);

} // namespace polydec
