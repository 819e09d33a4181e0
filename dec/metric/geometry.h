// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/centers.h"
#include "dec/metric/simplex_metric.h"

#include <memory>
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

    const Pieces& pieces() const { return pieces_; }
    const SimplexMetric& metric() const { return metric_; }
    const CellVolumes& volumes() const { return volumes_; }
    const Centers& centers() const { return centers_; }

    /// The marks of all n-simplices (may be empty), and the mark of one.
    const std::vector<bool>& flat() const { return *flat_; }
    bool is_flat(Index t) const { return !flat_->empty() && (*flat_)[t]; }

    /// The same simplices with duals between other centers. Throws like dual_volumes.
    Geometry with_centers(const Centers& centers) const;

    /// The same with other marks.
    Geometry with_flat(std::vector<bool> flat) const {
        return {pieces_, metric_, volumes_, centers_, std::move(flat)};
    }

private:
    Pieces pieces_;
    SimplexMetric metric_;
    CellVolumes volumes_;
    Centers centers_;
    std::shared_ptr<const std::vector<bool>> flat_;
};

} // namespace polydec
