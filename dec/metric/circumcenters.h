// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_metric.h"

namespace polydec {

/// Circumradii of all k-simplices in the given table (rows of vertex numbers). These functions
/// throw InvalidInput, naming the vertices, for a simplex without volume and for a vertex without
/// point.
Vector circumradii(const Points& points, const Simplices& simplices);

/// Circumradii of all k-simplices of the complex.
Vector circumradii(const Pieces& complex, const SimplexMetric& metric, int k);

/// Circumcenters of all k-simplices in the given table: one row of N coordinates each. Throws like
/// circumradii.
Points circumcenters(const Points& points, const Simplices& simplices);

} // namespace polydec
