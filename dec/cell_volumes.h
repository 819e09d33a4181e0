// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/simplex_metric.h"

#include <span>
#include <vector>

namespace polydec {

/// The metric of a complex: all that a Hodge star needs.
struct CellVolumes {
    std::vector<Vector> primal; ///< primal[k]: k-volumes |s|, 1 for vertices; length^k
    std::vector<Vector> dual;   ///< dual[k]: signed (n-k)-volumes |*s|, 1 for n-cells; length^(n-k)
};

/// Volumes of the simplices and signed volumes of their circumcentric duals, by the recursion
/// |*s| = 1/(n-k) sum over cofaces t of h(s,t) |*t| with h the signed distance between the
/// circumcenters. Needs no manifold and no Delaunay property; sum |s||*s| = C(n,k) |K| always.
/// Needs lengths of edges only. Source: Hirani, Kalyanaraman, VanderZee 2013, with the sign
/// taken from the coface, which makes it right for obtuse simplices too.
/// Throws InvalidInput, naming the vertices, for a simplex without volume, vertices without point,
/// or a simplex of least dimension that cannot have the lengths given (a triangle that violates the
/// triangle inequality, in higher dimension edges whose products are not positive definite).
CellVolumes circumcentric_volumes(const SimplicialComplex& complex, const SimplexMetric& metric);

/// Volumes of merged cells: |F| = sum |s| over the pieces, |*F| = (sum |s||*s|) / |F|. The pieces
/// stand in the diamonds of degrees 0..n.
CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input);
CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input);

} // namespace polydec
