// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace polydec {

/// A block by its dimension and the number of its first piece.
struct BlockName {
    std::int64_t dimension, first;
    auto operator<=>(const BlockName&) const = default;
};

/// A k-simplex in the interior of a block, with one of its faces in there.
struct OpenIncidence {
    BlockName block;
    int k;
    std::int64_t simplex, face;
    int sign;
};

/// Up to this number of simplices of at least two dimensions less in its interior, a block with
/// consistent signs and the Euler number of a ball has the homology of a ball. Such a block of
/// dimension d has one class in degree d. Every other class has degree d-1, and changes the Euler
/// number: one simplex of degree d-2 is no class, because a simplex of degree d-1 has it as a face
/// once. With more, classes of neighboring degrees may cancel. Where faces may repeat, one is more.
constexpr Index most_below_interfaces = 1;

/// The blocks, ascending, whose homology relative to their boundary is not (0, .., 0, 1) as of a
/// ball, over the integers modulo a prime (see betti_numbers). Each block is given by all its
/// incidences, in any order.
std::vector<BlockName> without_homology_of_balls(std::vector<OpenIncidence> incidences);

} // namespace polydec
