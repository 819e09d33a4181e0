// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>
#include <span>

namespace polydec::test {

/// A small mesh that a list of bytes describes; every list describes one, and the same one
/// everywhere. n = 1..5 and up to two coordinates more: books and trees of simplices, soups on few
/// vertices, one- and two-sided rings, grids of cubes; with corners in general position, on a
/// grid (so that many are cospherical), within 1e-14 to 0.1 of one, flattened by up to 1e-6 along
/// an axis; at scales from 1e-150 to 1e150. Zeros make it simpler, so that a counterexample
/// shrinks. It may be unusable: cells may lack volume or be there twice.
Mesh hostile_mesh(std::span<const std::uint8_t> bytes);

} // namespace polydec::test
