// SPDX-License-Identifier: MIT
#include "solvers/surfaces/parallel_transport.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "shape/sources.h"
#include "solvers/surfaces/heat_step.h"
#include "solvers/surfaces/surface_metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

using Complex = std::complex<double>;

/// Entries of a complex matrix as 2 x 2 blocks of a real one.
class ComplexEntries {
public:
    void add(Index row, Index column, Complex value) {
        const double re = value.real(), im = value.imag();
        entries_.emplace_back(2 * row, 2 * column, re);
        entries_.emplace_back(2 * row, 2 * column + 1, -im);
        entries_.emplace_back(2 * row + 1, 2 * column, im);
        entries_.emplace_back(2 * row + 1, 2 * column + 1, re);
    }

    SparseMatrix matrix(Index size) const {
        SparseMatrix A(2 * size, 2 * size);
        A.setFromTriplets(entries_.begin(), entries_.end());
        return A;
    }

private:
    std::vector<Eigen::Triplet<double, Index>> entries_;
};

/// M + t L for vectors, L the connection Laplacian: edge weight times the squared difference of the
/// vector at the head and the vector transported there from the tail.
SparseMatrix vector_heat_matrix(const GluedSurface& surface, const SurfaceMetric& metric,
                                const TangentFrames& frames, const Vector& times) {
    ComplexEntries entries;
    for (Index v = 0; v < surface.vertices(); ++v)
        entries.add(v, v, metric.vertex_areas[v]);
    for (Index h = 0; h < 3 * surface.triangles(); ++h) {
        const Index i = surface.tail(h), j = surface.head(h);
        const double weight = times[metric.component[i]] * metric.cotangents[h] / 2;
        const Complex carried = frames.carried(h);
        entries.add(i, i, weight), entries.add(j, j, weight);
        entries.add(j, i, -weight * carried), entries.add(i, j, -weight * std::conj(carried));
    }
    return entries.matrix(surface.vertices());
}

/// Nonnegative weights make L semidefinite; negative ones, with curvature, may not.
Definiteness definiteness(const GluedSurface& surface, const SurfaceMetric& metric) {
    for (Index e = 0; e < surface.edges(); ++e) {
        const auto& [h, g] = surface.halfedges(e);
        const double weight = metric.cotangents[h] + (g < 0 ? 0 : metric.cotangents[g]);
        if (weight < -1e-12)
            return Definiteness::indefinite;
    }
    return Definiteness::positive;
}

/// The heat of one step: in the columns of functions, heat 1 from every source, and heat as large
/// as the vector there; and the vectors.
struct Heat {
    DenseMatrix functions;
    Vector vectors; // real and imaginary parts interleaved
};

void check_vectors(const GluedSurface& surface, std::span<const Index> sources,
                   const TangentVectors& vectors) {
    if (static_cast<std::size_t>(vectors.size()) != sources.size())
        throw InvalidInput(fmt::format("{} vectors are given for {} sources: expected one for each",
                                       vectors.size(), sources.size()));
    std::vector<bool> given(std::size_t(surface.vertices()), false);
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const Complex vector = vectors[static_cast<Eigen::Index>(s)];
        const Index name = surface.vertex_number(sources[s]);
        if (given[sources[s]])
            throw InvalidInput(
                fmt::format("vertex {} is a source twice: expected one vector for it", name),
                {.vertices = {name}});
        given[sources[s]] = true;
        if (!std::isfinite(std::abs(vector)))
            throw InvalidInput(fmt::format("the vector at vertex {} is ({}, {}): expected finite "
                                           "numbers",
                                           name, vector.real(), vector.imag()),
                               {.vertices = {name}});
    }
}

} // namespace

struct ParallelTransport::Parts {
    GluedSurface surface;
    SurfaceMetric metric;
    TangentFrames frames;
    std::string engine;
    HeatStep functions;
    std::unique_ptr<LinearSolver> vectors;

    Parts(const GluedSurface& surface_, const Vector& lengths, const TransportOptions& options)
        : surface(surface_),
          metric(surface_metric(surface, lengths)),
          frames(tangent_frames(surface, lengths)),
          engine(options.linear_solver),
          functions(metric, options.time_scale * metric.mean_lengths.cwiseAbs2(), engine),
          vectors(step_of_vectors(functions.times())) {}

    std::unique_ptr<LinearSolver> step_of_vectors(const Vector& times) const {
        auto solver = make_linear_solver(engine);
        solver->factorize(vector_heat_matrix(surface, metric, frames, times),
                          {.symmetry = Symmetry::symmetric,
                           .definiteness = definiteness(surface, metric),
                           .domain_dimension = 2,
                           .many_solves = true});
        return solver;
    }

    /// From vectors of norm at most 1 at the sources.
    Heat heat(std::span<const Index> sources, const TangentVectors& at_sources) const {
        DenseMatrix sizes = DenseMatrix::Zero(surface.vertices(), 2);
        Vector blocks = Vector::Zero(2 * Eigen::Index(surface.vertices()));
        for (std::size_t s = 0; s < sources.size(); ++s) {
            const Complex vector = at_sources[static_cast<Eigen::Index>(s)];
            sizes.row(sources[s]) << 1, std::abs(vector);
            blocks[2 * Eigen::Index(sources[s])] = vector.real();
            blocks[2 * Eigen::Index(sources[s]) + 1] = vector.imag();
        }
        HeatFlow flow = functions.from(metric, sizes);
        const bool as_long = flow.times == functions.times();
        return {std::move(flow.u),
                as_long ? vectors->solve(blocks) : step_of_vectors(flow.times)->solve(blocks)};
    }
};

ParallelTransport::ParallelTransport(const GluedSurface& surface, const Vector& lengths,
                                     const TransportOptions& options) {
    check_time_scale(options.time_scale);
    parts_ = std::make_shared<Parts>(surface, lengths, options);
}

const TangentFrames& ParallelTransport::frames() const& {
    return parts_->frames;
}

TangentVectors ParallelTransport::extend(std::span<const Index> sources,
                                         const TangentVectors& vectors) const {
    const Parts& parts = *parts_;
    check_sources(parts.surface, sources);
    check_vectors(parts.surface, sources, vectors);
    const Vector sizes = vectors.cwiseAbs();
    const double least = sizes.minCoeff(), largest = sizes.maxCoeff();
    TangentVectors result = TangentVectors::Zero(parts.surface.vertices());
    if (largest == 0)
        return result;

    const Heat heat =
        explaining_failure(parts.metric, [&] { return parts_->heat(sources, vectors / largest); });
    for (Eigen::Index v = 0; v < result.size(); ++v) {
        // far from Delaunay, heat can be negative: that of functions and of vectors alike
        const double all = heat.functions(v, 0);
        const Complex vector = Complex(heat.vectors[2 * v], heat.vectors[2 * v + 1]) / all;
        const double magnitude = std::clamp(heat.functions(v, 1) / all * largest, least, largest);
        if (const double size = std::abs(vector); size > 1e-12)
            result[v] = magnitude * (vector / size);
    }
    return result;
}

} // namespace polydec
