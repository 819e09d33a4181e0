// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <filesystem>

namespace polydec {

/// Writes the stored entries of a matrix as a Matrix Market coordinate file, row by row; explicit
/// zeros stay. Numbers read back exactly. The file appears whole or not at all.
/// Throws InvalidInput, naming the entry, at NaN or infinity; IoError if writing fails.
void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix);

/// The same for incidences, with the field `integer`.
void write_matrix_market(const std::filesystem::path& path, const IncidenceMatrix& matrix);

/// Writes a matrix, or a vector as one column, as a Matrix Market array. Throws likewise.
void write_matrix_market(const std::filesystem::path& path,
                         const Eigen::Ref<const DenseMatrix>& matrix);

/// Reads a Matrix Market coordinate file: real or integer; general, symmetric or skew-symmetric,
/// expanded to both triangles. Throws IoError if the file cannot be read; InvalidInput, naming the
/// line, if it is malformed, repeats an entry, or has NaN or infinity.
SparseMatrix read_matrix_market(const std::filesystem::path& path);

/// Reads a Matrix Market array file: real or integer, general. Throws like `read_matrix_market`.
DenseMatrix read_matrix_market_array(const std::filesystem::path& path);

} // namespace polydec
