// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "dec/discretization/discretization.h"
#include "dec/merging/merge.h"
#include "dec/metric/cell_volumes.h"
#include "meshes/mesh.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace polydec::test {

/// A mesh with its complex K, the merged complex P, and the volumes of both.
struct Merged {
    Points points;
    SimplicialComplex complex;
    CellVolumes input_volumes;
    CosphericalMerging result;
    CellVolumes volumes;

    const Merging& merging() const { return result.merging; }
    Geometry geometry() const { return {complex, points, input_volumes}; } ///< of K
    const SimplicialComplex& K() const { return complex; }
    const CellComplex& P() const { return result.merging.merged(); }
    int n() const { return K().dimension(); }
};

/// Relative dual length below which the tests merge, as the golden numbers do.
constexpr double tolerance = 1e-8;

Merged make_merged(const Mesh& mesh,
                   const MergeOptions& options = {MergeCriterion::dual_length, tolerance});

/// The merged mesh of the family, made once.
const Merged& merged(const std::string& name);

/// A complex with its metric, under the name by which a failed law tells of it.
struct Metric {
    const char* name;
    const CellComplex& complex;
    const CellVolumes& volumes;
};

/// K and P.
std::vector<Metric> both(const Merged& merged);

/// Whether three n-cells or more meet at a facet, where dual 0-forms have no differences.
inline bool branches(const CellComplex& complex) {
    const auto& cofaces = complex.coface_counts(complex.dimension() - 1);
    return std::any_of(cofaces.begin(), cofaces.end(), [](Index cells) { return cells > 2; });
}

/// The mesh with circumcentric stars, where they are positive and where they are not.
template <class AnyMesh>
Discretization circumcentric(AnyMesh mesh, DiscretizeOptions options = {}) {
    options.star = StarKind::circumcentric;
    return discretize(std::move(mesh), options);
}

} // namespace polydec::test
