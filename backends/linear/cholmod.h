// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Makes the engine `cholmod` known: SuiteSparse's CHOLMOD, for symmetric matrices. Positive
/// definite ones get a supernodal L L^T, all others a simplicial L D L^T, which counts negative
/// eigenvalues. Ordering: AMD for surfaces, METIS for solids. Programs that link polydec::cholmod
/// with CMake have it without calling this, which does nothing then, as when called again.
/// Part of the separate target polydec::cholmod: CHOLMOD's supernodal code is under the GPL, which
/// a program that links it has to respect. Throws InvalidInput if another engine has taken the
/// name.
void register_cholmod();

} // namespace polydec
