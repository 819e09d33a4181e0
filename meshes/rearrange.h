// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// The mesh with every coordinate moved at random, independently and uniformly, by at most
/// `amplitude`. The same seed gives the same mesh on every machine.
/// Throws InvalidInput unless the amplitude is finite and not negative.
Mesh perturbed(Mesh mesh, double amplitude, std::uint64_t seed);

/// A mesh whose vertices and cells have been renumbered.
struct Renumbered {
    Mesh mesh;
    std::vector<Index> vertices; ///< vertices[i]: old number of vertex i
    std::vector<Index> cells;    ///< cells[i]: old number of cell i
};

/// The same mesh under random vertex and cell numbers; cells keep the order of their corners, so
/// their orientation, and their tags, and so do facets with tags. The same seed gives the same
/// numbers on every machine. Throws InvalidInput, naming the cell, if a vertex number is out of
/// range, or if there are tags, but not one for each cell; like check_facet_tags.
Renumbered shuffled(const Mesh& mesh, std::uint64_t seed);

/// The same mesh with vertices numbered along Morton's curve through their bounding cube (Morton
/// 1966), cells by their first vertex: neighbors in space are near in memory. Operators of a mesh
/// whose numbers are in disorder are built and applied several times faster. Values y at the new
/// vertices are x[vertices[i]] of those at the old.
/// Throws InvalidInput like shuffled, and if a coordinate is not finite, naming the vertex.
Renumbered along_morton_curve(const Mesh& mesh);

/// Where points of finite coordinates lie on the curve: the leading binary digits of all
/// coordinates, taken in turn. Equal points have equal keys.
std::vector<std::uint64_t> morton_keys(const Points& points);

/// Numbers of keys that ascend by as many leading bits as fit into a word beside a number. Groups
/// of equal ones end at `ends`; within them numbers ascend.
struct KeyGroups {
    std::vector<Index> order, ends;
};
KeyGroups groups_of(const std::vector<std::uint64_t>& keys);

/// Numbers of the keys in ascending order, equal keys in the order they have.
std::vector<Index> ascending_order(const std::vector<std::uint64_t>& keys);

} // namespace polydec
