// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/metric/cell_volumes.h"

#include <span>

namespace polydec {

/// Volumes of merged cells: |F| = sum |s| over the pieces, |*F| = (sum |s||*s|) / |F|. The pieces
/// stand in the diamonds of degrees 0..n.
CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input);
CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input);

} // namespace polydec
