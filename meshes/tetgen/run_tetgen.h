// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/tetgen/tetgen_input.h"
#include "meshes/tetgen/tetgen_output.h"
#include "meshes/tetrahedralize.h"

namespace polydec {

/// What TetGen makes of a surface. It is under the AGPL, and ends its process in a crash on much of
/// what it cannot do, so it is not linked but run as a program, with limits of time and memory, in
/// a temporary folder that is gone afterwards, also after Ctrl-C (held_signals.h). Throws as
/// tetrahedralize says, of a surface that is fine.
TetgenOutput run_tetgen(const TetgenInput& input, const MesherOptions& options);

} // namespace polydec
