// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// The mesh with every coordinate perturbed at random, independently and uniformly, by at most
/// `amplitude`. The same seed gives the same mesh on every machine. Throws InvalidInput unless the
/// amplitude is finite and not negative.
Mesh perturbed(Mesh mesh, double amplitude, std::uint64_t seed);

/// A mesh with renumbered vertices and cells.
struct Renumbered {
    Mesh mesh;
    std::vector<Index> vertices; ///< vertices[i]: old number of vertex i
    std::vector<Index> cells;    ///< cells[i]: old number of cell i
};

/// The same mesh with random vertex and cell numbers. Cells keep the order of their corners, and so
/// their orientation; cells and facets keep their tags. The same seed gives the same numbers on
/// every machine. Throws InvalidInput, naming the cell, if a vertex number is out of range; if
/// there are tags, but not one per cell; and like check_facet_tags.
Renumbered shuffled(const Mesh& mesh, std::uint64_t seed);

/// The same mesh with vertices numbered along the Morton curve through their bounding cube (Morton
/// 1966), and cells by their first vertex: neighbors in space are near in memory. A mesh with
/// disordered numbers gains a factor of several in building and applying operators. Values x at the
/// old vertices become y[i] = x[vertices[i]] at the new ones. Throws InvalidInput like shuffled,
/// and, naming the vertex, if a coordinate is not finite.
Renumbered along_morton_curve(const Mesh& mesh);

/// Positions of points on the Morton curve: the leading binary digits of all coordinates,
/// interleaved. Coordinates must be finite. Equal points have equal keys.
std::vector<std::uint64_t> morton_keys(const Points& points);

/// Indices of keys, sorted by as many leading bits as fit into a word beside an index. Groups of
/// equal keys end at `ends`; within a group, indices ascend.
struct KeyGroups {
    std::vector<Index> order, ends;
};
KeyGroups groups_of(const std::vector<std::uint64_t>& keys);

/// Indices of the keys in ascending order; a stable sort.
std::vector<Index> ascending_order(const std::vector<std::uint64_t>& keys);

} // namespace polydec
