// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// The names of meshes of a dimension, 2 or 3, that are made here as bad as those that are found:
/// "made/torus" ..; with and without boundary, holes and branches, all shaken until many duals are
/// negative. Where there are test data, also these files, such as "cad/joint.obj".
std::vector<std::string> samples(int dimension, const std::vector<std::string>& files = {});

/// The mesh of a name of either kind. Throws std::runtime_error if there is none.
Mesh mesh_of(const std::string& name);

/// The name without folder and extension, of characters that names of tests may have.
std::string test_name(const std::string& name);

} // namespace polydec::test
