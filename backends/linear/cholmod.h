// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Registers the engine `cholmod`: SuiteSparse's CHOLMOD, for symmetric matrices. Positive definite
/// ones get a supernodal L L^T, all others a simplicial L D L^T, which counts negative eigenvalues.
/// Ordering: AMD for surfaces, METIS for solids. Programs that link polydec::cholmod with CMake
/// need not call this; repeated calls do nothing. Part of the separate target polydec::cholmod:
/// CHOLMOD's supernodal code is under the GPL, which applies to programs that link it. Throws
/// InvalidInput if the name is taken.
void register_cholmod();

} // namespace polydec
