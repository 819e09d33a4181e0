// SPDX-License-Identifier: MIT
#pragma once

#include "io/source_file.h"

#include <string>

namespace polydec {

/// Describes a file whose first bytes show another format than its extension, with advice, such as
/// "a pointer of Git LFS; run git lfs pull"; empty otherwise.
std::string foreign_format(const SourceFile& file);

} // namespace polydec
