// SPDX-License-Identifier: MIT
#pragma once

#include "base/memory.h"
#include "complex/surfaces/glued_surface.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace polydec {

class LinearSolver;

/// What heat on a surface needs of its metric, also where it branches. Lengths are in a unit near
/// the longest edge, so that nothing here overflows or gets lost, whatever unit the user has.
struct SurfaceMetric {
    double unit;                  ///< a power of 2
    Vector lengths;               ///< of edges
    Vector areas;                 ///< of triangles, above 0
    Vector cotangents;            ///< of half-edges: of the angle opposite to each
    Vector vertex_areas;          ///< a third of the triangles around
    std::vector<Index> component; ///< of vertices
    Vector mean_lengths;          ///< of the edges of each component
};

/// Throws InvalidInput, naming edge or triangle, for lengths that are none of triangles with area.
SurfaceMetric surface_metric(const Triangles& surface, const Vector& lengths);

/// Throws InvalidInput unless it is from 1e-6 to 1e6.
void check_time_scale(double time_scale);

/// What an engine says of its failure, and the angle that is probably its cause.
std::string explained(const Triangles& surface, const SurfaceMetric& metric,
                      const std::string& failure);

/// The result of a call, whose failures are explained.
template <class Call>
auto explaining_failure(const Triangles& surface, const SurfaceMetric& metric, Call call) {
    try {
        return call();
    } catch (const OutOfMemory&) {
        throw; // no angle is its cause
    } catch (const SolverFailure& failure) {
        throw SolverFailure(explained(surface, metric, failure.what()), failure.report(),
                            failure.place());
    }
}

/// The cotangent Laplacian, positive semidefinite, with the part of each component multiplied by
/// its factor.
SparseMatrix surface_laplacian(const Triangles& surface, const SurfaceMetric& metric,
                               const Vector& factors);

} // namespace polydec
