// SPDX-License-Identifier: MIT
#pragma once

#include "io/source_file.h"

#include <string>

namespace polydec {

/// What a file is by the way it begins, and what to do with it, if that is another format than its
/// extension stands for, such as "a pointer of Git LFS; run git lfs pull"; else an empty text.
std::string foreign_format(const SourceFile& file);

} // namespace polydec
