// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/source_file.h"

namespace polydec {

/// The readers of Matrix Market files, after the file was read.
SparseMatrix parse_matrix_market(const SourceFile& file);
DenseMatrix parse_matrix_market_array(const SourceFile& file);

} // namespace polydec
