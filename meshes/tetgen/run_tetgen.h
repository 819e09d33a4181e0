// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/tetgen/tetgen_input.h"
#include "meshes/tetgen/tetgen_output.h"
#include "meshes/tetrahedralize.h"

namespace polydec {

/// TetGen's result for a surface. TetGen is under the AGPL, and crashes on much invalid input. So
/// it is not linked but runs as a program, with limits of time and memory, in a temporary folder
/// that is removed afterwards, also after Ctrl-C (held_signals.h). Throws like tetrahedralize, for
/// a valid surface.
TetgenOutput run_tetgen(const TetgenInput& input, const MesherOptions& options);

} // namespace polydec
