// SPDX-License-Identifier: MIT
#pragma once

#include "backends/mesher.h"

/// The mesher `tetgen`. TetGen is under the AGPL, and ends its process in a crash on much of what
/// it cannot do, so it is not linked but run as a program, with limits of time and memory, in a
/// temporary folder that is gone afterwards, also after Ctrl-C (held_signals.h).
namespace polydec::builtin {

/// Whether the program is on PATH now.
bool has_tetgen();

/// What tetrahedralize says, of a checked input.
MesherOutput run_tetgen(const MesherInput& input, const MesherOptions& options);

} // namespace polydec::builtin
