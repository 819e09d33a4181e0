// SPDX-License-Identifier: MIT
#include "dec/metric/geometry.h"

#include "base/checks.h"

#include <utility>

namespace polydec {

Geometry::Geometry(const Pieces& pieces, const SimplexMetric& metric, const Centers& centers,
                   FlatSimplices flat)
    : Geometry(pieces, metric, dual_volumes(pieces, metric, centers, flat), centers) {}

Geometry::Geometry(const Pieces& pieces, const SimplexMetric& metric, const CellVolumes& volumes,
                   const Centers& centers, std::vector<bool> flat)
    : pieces_(pieces),
      metric_(metric),
      volumes_(volumes),
      centers_(centers),
      flat_(std::make_shared<const std::vector<bool>>(std::move(flat))) {
    if (const Points* points = metric.points())
        check_as_many("points of the vertices", points->rows(), pieces.size(0));
    else
        check_as_many("lengths of the edges", metric.lengths()->size(), pieces.size(1));
    check_fit(pieces, volumes);
    centers.check_fit(pieces);
    if (!flat_->empty())
        check_as_many("marks of flat simplices", std::ssize(*flat_),
                      pieces.size(pieces.dimension()));
}

} // namespace polydec
