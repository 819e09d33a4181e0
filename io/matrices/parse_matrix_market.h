// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/source_file.h"

namespace polydec {

/// Parse Matrix Market files that are already in memory.
SparseMatrix parse_matrix_market(const SourceFile& file);
DenseMatrix parse_matrix_market_array(const SourceFile& file);

} // namespace polydec
