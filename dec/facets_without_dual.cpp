// SPDX-License-Identifier: MIT
#include "dec/facets_without_dual.h"

#include "dec/merging/facet_defects.h"

#include <algorithm>
#include <limits>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

/// What the duals of the pieces are compared with.
FacetDefects defects_of_pieces(const Discretization& mesh) {
    if (mesh.intrinsic)
        return facet_defects(mesh.intrinsic->surface(), mesh.intrinsic->triangle_volumes,
                             mesh.options.tolerance);
    return facet_defects(mesh.input(), mesh.metric(), mesh.input_volumes,
                         {MergeCriterion::dual_length, mesh.options.tolerance});
}

} // namespace

std::vector<bool> boundary_facets_without_dual(const Discretization& discretization) {
    const int n = discretization.dimension();
    const auto& complex = discretization.complex();
    const auto& volumes = discretization.volumes;
    const auto& facets = discretization.intrinsic ? discretization.intrinsic->merging.diamonds[1]
                                                  : discretization.merging.diamond(n - 1);
    const auto pieces = defects_of_pieces(discretization);
    std::vector<bool> marks(static_cast<std::size_t>(complex.size(n - 1)), false);
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        if (complex.coface_counts(n - 1)[f] != 1)
            continue;
        double scale = 0, height = std::numeric_limits<double>::infinity();
        for (Row piece(facets, f); piece; ++piece) {
            scale = std::max(scale, pieces.scale[piece.col()]);
            height = std::min(height, pieces.height[piece.col()]);
        }
        marks[f] = is_degenerate(volumes.dual(n - 1)[f], volumes.terms(n - 1)[f], scale, height,
                                 discretization.options.tolerance);
    }
    return marks;
}

} // namespace polydec
