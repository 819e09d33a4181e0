// SPDX-License-Identifier: MIT
#include "benchmarks/chain.h"
#include "benchmarks/rows.h"
#include "complex/homology.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "dec/forms/laplacian.h"
#include "dec/merging/merge.h"
#include "dec/metric/geometry.h"
#include "dec/metric/simplex_metric.h"
#include "dec/stars/star.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "dec/surfaces/passage.h"
#include "meshes/generate.h"
#include "meshes/rearrange.h"

namespace polydec::benchmarks {

namespace {

void complex_row(benchmark::State& state, const LazyMesh& mesh) {
    const Mesh& input = mesh.get();
    measure(state, {mesh.amount().cells, bytes(input.simplices)},
            [&] { return SimplicialComplex(input.simplices); });
}

void volumes_row(benchmark::State& state, const LazyMesh& mesh) {
    const Mesh& input = mesh.get();
    const SimplicialComplex complex(input.simplices);
    measure(state, {mesh.amount().cells, bytes(input.points) + bytes(complex)},
            [&] { return circumcentric_volumes(complex, input.points); });
}

void derivatives_row(benchmark::State& state, const LazyMesh& mesh) {
    const SimplicialComplex complex(mesh.get().simplices);
    double bytes_in = 0;
    for (int k = 0; k < complex.dimension(); ++k)
        bytes_in += bytes(complex.coboundary(k));
    measure(state, {mesh.amount().cells, bytes_in}, [&] {
        std::vector<SparseMatrix> result;
        for (int k = 0; k < complex.dimension(); ++k)
            result.push_back(derivative(complex, k));
        return result;
    });
}

void stars_row(benchmark::State& state, const LazyMesh& mesh) {
    const SimplicialComplex complex(mesh.get().simplices);
    const CellVolumes volumes = circumcentric_volumes(complex, mesh.get().points);
    measure(state, {mesh.amount().cells, bytes(volumes)}, [&] {
        std::vector<Vector> result;
        for (int k = 0; k <= complex.dimension(); ++k)
            result.push_back(star(volumes, k).diagonal());
        return result;
    });
}

void laplacian_row(benchmark::State& state, const LazyMesh& mesh) {
    const SimplicialComplex complex(mesh.get().simplices);
    const CellVolumes volumes = circumcentric_volumes(complex, mesh.get().points);
    const double bytes_in =
        bytes(complex.coboundary(0)) + bytes(volumes.primal(1)) + bytes(volumes.dual(1));
    measure(state, {mesh.amount().cells, bytes_in}, [&] {
        return symmetric_laplacian({complex, volumes}, 0).matrix();
    });
}

void chain_row(benchmark::State& state, const LazyMesh& mesh) {
    const Mesh& input = mesh.get();
    measure(state, mesh.amount(), [&] { return chain(input); });
}

/// A mesh in disorder is renumbered first, then as above.
void renumbered_row(benchmark::State& state, const LazyMesh& mesh) {
    const Mesh& input = mesh.get();
    measure(state, mesh.amount(), [&] { return chain(along_morton_curve(input).mesh); });
}

/// On top of complex and volumes, which are there; merging takes the complex for its own.
void merging_row(benchmark::State& state, const LazyMesh& mesh) {
    const Mesh& input = mesh.get();
    const SimplicialComplex complex(input.simplices);
    const CellVolumes volumes = circumcentric_volumes(complex, input.points);
    const double bytes_in = bytes(input.points) + bytes(complex) + bytes(volumes);
    measure_prepared(
        state, {mesh.amount().cells, bytes_in}, [&] { return complex; },
        [&](SimplicialComplex copy) {
            return merge_cospherical({copy, input.points, volumes});
        });
}

/// As users call it, from points and simplices: also checks, warnings and the choice of stars.
void discretize_row(benchmark::State& state, const LazyMesh& mesh) {
    const Mesh& input = mesh.get();
    measure(state, mesh.amount(), [&] { return discretize(input); });
}

/// Intrinsic flips, volumes and merging, on top of complex and lengths, which are there.
void flips_row(benchmark::State& state, const LazyMesh& mesh) {
    const Mesh& input = mesh.get();
    const SimplicialComplex complex(input.simplices);
    const Vector lengths = edge_lengths(complex, input.points);
    measure(state, {mesh.amount().cells, bytes(complex) + bytes(lengths)}, [&] {
        const Passage passage(complex, intrinsic_delaunay(GluedSurface(complex), lengths),
                              complex.size(0));
        const SimplexMetric metric(passage.pieces(), passage.flips().lengths);
        const auto volumes = circumcentric_volumes(passage.pieces(), metric);
        return merge_cospherical({passage.pieces(), metric, volumes}).merging.merged();
    });
}

void betti_row(benchmark::State& state, const LazyMesh& mesh) {
    const SimplicialComplex complex(mesh.get().simplices);
    measure(state, {mesh.amount().cells, bytes(static_cast<const CellComplex&>(complex))},
            [&] { return betti_numbers(complex); });
}

using MeshRow = void (*)(benchmark::State&, const LazyMesh&);

void add(const std::string& name, const SharedMesh& mesh, const Settings& settings, MeshRow row) {
    add_row(name, settings.rounds, [=](benchmark::State& state) { row(state, *mesh); });
}

void add_stages(const std::string& name, const SharedMesh& mesh, const Settings& settings) {
    add(name + "/chain", mesh, settings, chain_row);
    add(name + "/complex", mesh, settings, complex_row);
    add(name + "/volumes", mesh, settings, volumes_row);
    add(name + "/derivatives", mesh, settings, derivatives_row);
    add(name + "/stars", mesh, settings, stars_row);
    add(name + "/laplacian", mesh, settings, laplacian_row);
    add(name + "/merging", mesh, settings, merging_row);
    add(name + "/discretize", mesh, settings, discretize_row);
    add(name + "/betti", mesh, settings, betti_row);
}

} // namespace

void add_operator_rows(const Settings& settings) {
    const int f = settings.judged_side(224);
    add_stages("sphere", shared_mesh([=] { return icosphere(f); }), settings);
    const auto in_disorder = shared_mesh([=] { return shuffled(icosphere(f), 1).mesh; });
    add("sphere_shuffled/chain", in_disorder, settings, chain_row);
    add("sphere_shuffled/renumbered", in_disorder, settings, renumbered_row);
    add("sphere_4M/chain", shared_mesh([=] { return icosphere(2 * f); }), settings, chain_row);

    // so that 10 % of the edges have a negative dual
    const auto rough = shared_mesh([=] { return perturbed(icosphere(f), 0.62 / f, 1); });
    add("sphere_rough/complex", rough, settings, complex_row);
    add("sphere_rough/flips", rough, settings, flips_row);

    const int around = settings.judged_side(1000), across = settings.judged_side(500);
    add_stages("torus", shared_mesh([=] { return torus(around, across); }), settings);

    const int cells = settings.judged_side(64);
    add_stages("tets", shared_mesh([=] { return kuhn(3, cells); }), settings);
    const int few = settings.side(12);
    add("pentatopes/chain", shared_mesh([=] { return kuhn(4, few); }), settings, chain_row);
}

} // namespace polydec::benchmarks
