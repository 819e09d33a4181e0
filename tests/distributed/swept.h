// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"
#include "tests/support/test.h"

namespace polydec::test {

/// Whether all of everything is asked for, by POLYDEC_TEST_SWEEP, and not what takes seconds.
bool is_full_sweep();

/// The family of meshes, and where there are test data those found there, tidied: small ones by
/// turns, so that different numbers of ranks have different ones; in a full sweep all of them with
/// at most so many cells.
std::vector<NamedMesh> swept(const Ranks& ranks, Index most_cells = 200000);

} // namespace polydec::test
