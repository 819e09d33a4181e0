// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "complex/pieces.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/centers.h"
#include "dec/metric/simplex_metric.h"

#include <vector>

namespace polydec {

/// Treatment of n-simplices without volume.
enum class FlatSimplices {
    refused,
    passed_over, ///< they contribute to no dual; their volume is indistinguishable from zero
};

/// Simplices and their geometry: the metric, the centers that span the duals, and the volumes of
/// both. Merging, the lift, products and stars use it. A handle: copies cost nothing.
class Geometry {
public:
    /// Measures the simplices. Throws like dual_volumes.
    Geometry(const Pieces& pieces, const SimplexMetric& metric, const Centers& centers = {},
             FlatSimplices flat = FlatSimplices::refused);

    /// Of known volumes. `flat` marks n-simplices too flat to determine a field from their corners
    /// (see flat_simplices) that belong to a cell with other simplices; empty if there are none.
    /// Throws InvalidInput, naming the quantity, unless volumes, centers and marks match the
    /// simplices.
    Geometry(const Pieces& pieces, const SimplexMetric& metric, const CellVolumes& volumes,
             const Centers& centers = {}, std::vector<bool> flat = {});

    const Pieces& pieces() const& { return pieces_; }
    Pieces pieces() && { return pieces(); }
    const SimplexMetric& metric() const& { return metric_; }
    SimplexMetric metric() && { return metric(); }
    const CellVolumes& volumes() const& { return volumes_; }
    CellVolumes volumes() && { return volumes(); }
    const Centers& centers() const& { return centers_; }
    Centers centers() && { return centers(); }

    /// The marks of all n-simplices (may be empty), and the mark of one.
    const std::vector<bool>& flat() const& { return *flat_; }
    std::vector<bool> flat() && { return flat(); }
    bool is_flat(Index t) const { return !flat_->empty() && (*flat_)[t]; }

    /// The same with other marks.
    Geometry with_flat(std::vector<bool> flat) const {
        return {pieces_, metric_, volumes_, centers_, std::move(flat)};
    }

private:
    Pieces pieces_;
    SimplexMetric metric_;
    CellVolumes volumes_;
    Centers centers_;
    Shared<const std::vector<bool>> flat_;
};

/// Volumes of the simplices and signed volumes of their circumcentric duals, by the recursion |*s|
/// = 1/(n-k) sum over cofaces t of h(s,t) |*t|, h the signed distance between the circumcenters.
/// Needs no manifold and no Delaunay property; sum |s||*s| = C(n,k) |K| always. Needs only lengths
/// of edges. Source: Hirani, Kalyanaraman, VanderZee 2013, with the sign taken from the coface,
/// which is correct for obtuse simplices too. Throws InvalidInput, naming the vertices, for a
/// simplex without volume, for vertices without point, and for a simplex of least dimension that
/// cannot have the given lengths (a triangle that violates the triangle inequality; in higher
/// dimensions, edges whose Gram matrix is not positive definite).
CellVolumes circumcentric_volumes(const Pieces& complex, const SimplexMetric& metric);

/// The same with duals between other centers. Throws likewise, and for centers of other simplices.
/// If the centers know the heights in n-simplices, these simplices may also be flat.
CellVolumes dual_volumes(const Pieces& complex, const SimplexMetric& metric, const Centers& centers,
                         FlatSimplices flat = FlatSimplices::refused);

} // namespace polydec
