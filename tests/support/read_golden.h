// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <string>

namespace polydec::test {

/// Where the files of the tests are, with the golden meshes and numbers in "golden".
std::string test_file(const std::string& name);

/// A golden mesh, "name.nsc" or "name.off" of triangles. The tests' own reader, so that an error of
/// the library's readers does not hide in every golden number.
Mesh read_golden(const std::string& name);

} // namespace polydec::test
