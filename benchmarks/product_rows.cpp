// SPDX-License-Identifier: MIT
#include "benchmarks/chain.h"
#include "benchmarks/rows.h"
#include "dec/forms/cochain.h"
#include "dec/forms/laplacian.h"
#include "dec/metric/geometry.h"
#include "dec/stars/star.h"
#include "meshes/generate.h"
#include "meshes/rearrange.h"

#include <tuple>

namespace polydec::benchmarks {

namespace {

/// d of a form by the library, which has no matrix, beside Eigen's product with one.
void derivative_row(benchmark::State& state, const LazyMesh& mesh, int k) {
    const SimplicialComplex complex(mesh.get().simplices);
    const SparseMatrix D = derivative(complex, k);
    const Cochain form{Side::primal, k, Vector::LinSpaced(complex.size(k), -1.0, 1.0)};
    compare(
        state, {mesh.amount().cells, bytes(D) + bytes(form)}, [&] { return d(complex, form); },
        [&] { return Vector(D * form.values); });
}

/// The Laplacian of 0-forms beside d^T star d as Eigen multiplies it.
void triple_product_row(benchmark::State& state, const LazyMesh& mesh) {
    const SimplicialComplex complex(mesh.get().simplices);
    const CellVolumes volumes = circumcentric_volumes(complex, mesh.get().points);
    const SparseMatrix D = derivative(complex, 0);
    const Vector weights = star(volumes, 1).diagonal();
    compare(
        state, {mesh.amount().cells, bytes(complex.coboundary(0)) + 2 * bytes(weights)},
        [&] {
            return symmetric_laplacian({complex, volumes}, 0).matrix();
        },
        [&] {
            const SparseMatrix T = D.transpose();
            return SparseMatrix(T * (weights.asDiagonal() * D));
        });
}

/// A vector under the numbers that a renumbered mesh has.
struct RenumberedVector {
    Vector values;
    const std::vector<Index>& old_numbers;

    friend double difference(const RenumberedVector& ours, const Vector& theirs) {
        return (ours.values - theirs(ours.old_numbers)).norm() / theirs.norm();
    }
    friend double bytes(const RenumberedVector& vector) { return benchmarks::bytes(vector.values); }
};

SparseMatrix laplacian_of_functions(const Mesh& mesh) {
    const SimplicialComplex complex(mesh.simplices);
    return symmetric_laplacian({complex, circumcentric_volumes(complex, mesh.points)}, 0);
}

/// Laplacian times vector on a renumbered mesh beside the same on the mesh in disorder.
void renumbered_product_row(benchmark::State& state, const LazyMesh& mesh) {
    const Renumbered renumbered = along_morton_curve(mesh.get());
    const SparseMatrix L = laplacian_of_functions(renumbered.mesh);
    const SparseMatrix L_in_disorder = laplacian_of_functions(mesh.get());
    const Vector x_in_disorder = Vector::LinSpaced(L.rows(), -1.0, 1.0);
    const Vector x = x_in_disorder(renumbered.vertices);
    compare(
        state, {mesh.amount().cells, bytes(L) + bytes(x)},
        [&] {
            return RenumberedVector{L * x, renumbered.vertices};
        },
        [&] { return Vector(L_in_disorder * x_in_disorder); });
}

} // namespace

void add_product_rows(const Settings& settings) {
    const int f = settings.side(224), cells = settings.side(64);
    const auto sphere = shared_mesh([=] { return icosphere(f); });
    const auto tets = shared_mesh([=] { return kuhn(3, cells); });
    const int many = settings.smoke ? 1 : 10 * settings.rounds;
    for (const auto& [name, mesh, n] : {std::tuple{"sphere", sphere, 2}, {"tets", tets, 3}}) {
        const std::string head = std::string("product/") + name;
        for (int k = 0; k < n; ++k)
            add_row(head + "/d" + std::to_string(k), many,
                    [=, m = mesh](benchmark::State& state) { derivative_row(state, *m, k); });
        add_row(head + "/laplacian", settings.rounds,
                [=, m = mesh](benchmark::State& state) { triple_product_row(state, *m); });
    }

    const auto in_disorder = shared_mesh([=] { return shuffled(icosphere(f), 1).mesh; });
    add_row("product/sphere_shuffled/renumbered", many,
            [=](benchmark::State& state) { renumbered_product_row(state, *in_disorder); });
}

} // namespace polydec::benchmarks
