// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/length_mesh.h"

#include <filesystem>

namespace polydec {

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
