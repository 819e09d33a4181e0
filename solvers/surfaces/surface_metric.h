// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"
#include "system/memory.h"

#include <string>
#include <vector>

namespace polydec {

class LinearSolver;

/// The metric quantities that the heat equation on a surface needs, also where it branches. Lengths
/// are in a unit near the longest edge, so that nothing overflows or underflows in any input unit.
struct SurfaceMetric {
    Triangles surface;
    double unit = 1;                   ///< a power of 2
    Vector lengths = {};               ///< of edges
    Vector areas = {};                 ///< of triangles, above 0
    Vector cotangents = {};            ///< of half-edges: of the opposite angle
    Vector vertex_areas = {};          ///< a third of the area of the triangles around
    std::vector<Index> component = {}; ///< of vertices
    Vector mean_lengths = {};          ///< of the edges of each component
};

/// Throws InvalidInput, naming edge or triangle, unless the lengths form triangles with area.
SurfaceMetric surface_metric(const Triangles& surface, const Vector& lengths);

/// Throws InvalidInput unless it is from 1e-6 to 1e6.
void check_time_scale(double time_scale);

/// An engine's failure message, with the angle that probably caused it.
std::string explained(const SurfaceMetric& metric, const std::string& failure);

/// The result of a call; failures get an explanation.
template <class Call>
auto explaining_failure(const SurfaceMetric& metric, Call call) {
    try {
        return call();
    } catch (const OutOfMemory&) {
        throw; // no angle is its cause
    } catch (const SolverFailure& failure) {
        throw SolverFailure(explained(metric, failure.what()), failure.report(), failure.place());
    }
}

/// The cotangent Laplacian, positive semidefinite, with each component's block multiplied by its
/// factor.
SparseMatrix surface_laplacian(const SurfaceMetric& metric, const Vector& factors);

} // namespace polydec
