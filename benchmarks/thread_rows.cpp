// SPDX-License-Identifier: MIT
#include "benchmarks/chain.h"
#include "benchmarks/rows.h"
#include "benchmarks/threads.h"
#include "dec/forms/laplacian.h"
#include "dec/metric/geometry.h"
#include "meshes/generate.h"

#include <cstring>

namespace polydec::benchmarks {

namespace {

template <typename Number>
bool same_bits(const Number* a, const Number* b, Eigen::Index size) {
    return size == 0 || std::memcmp(a, b, static_cast<std::size_t>(size) * sizeof(Number)) == 0;
}

template <typename Number, int Rows, int Columns, int Options>
bool same_bits(const Eigen::Matrix<Number, Rows, Columns, Options>& A,
               const Eigen::Matrix<Number, Rows, Columns, Options>& B) {
    return A.rows() == B.rows() && A.cols() == B.cols() && same_bits(A.data(), B.data(), A.size());
}

template <typename Number>
bool same_bits(const Eigen::SparseMatrix<Number, Eigen::RowMajor, Index>& A,
               const Eigen::SparseMatrix<Number, Eigen::RowMajor, Index>& B) {
    return A.rows() == B.rows() && A.cols() == B.cols() && A.nonZeros() == B.nonZeros() &&
           same_bits(A.outerIndexPtr(), B.outerIndexPtr(), A.rows() + 1) &&
           same_bits(A.innerIndexPtr(), B.innerIndexPtr(), A.nonZeros()) &&
           same_bits(A.valuePtr(), B.valuePtr(), A.nonZeros());
}

bool same_bits(const SimplicialComplex& a, const SimplicialComplex& b) {
    const int n = a.dimension();
    bool same = n == b.dimension();
    for (int k = 0; same && k <= n; ++k)
        same = same_bits(a.simplices(k), b.simplices(k)) &&
               same_bits(a.coboundary(k), b.coboundary(k)) &&
               a.coface_counts(k) == b.coface_counts(k);
    for (Index s = 0; same && s < a.size(n); ++s)
        same = a.input_row(s) == b.input_row(s) && a.orientation(s) == b.orientation(s);
    return same;
}

bool same_bits(const CellVolumes& a, const CellVolumes& b) {
    bool same = a.dimension() == b.dimension();
    for (int k = 0; same && k <= a.dimension(); ++k)
        same = same_bits(a.primal(k), b.primal(k)) && same_bits(a.dual(k), b.dual(k));
    return same;
}

bool same_bits(const Chain& a, const Chain& b) {
    return same_bits(a.complex, b.complex) && same_bits(a.stars.volumes(), b.stars.volumes()) &&
           same_bits(a.laplacian, b.laplacian);
}

/// What a number of threads has computed.
template <typename Result>
struct Computed {
    Result result;

    /// None at all, or the row becomes an error.
    friend double difference(const Computed& ours, const Computed& theirs) {
        return same_bits(ours.result, theirs.result) ? 0 : 1;
    }
    friend double bytes(const Computed& computed) { return benchmarks::bytes(computed.result); }
};

/// The work on two threads beside the same on one.
template <typename Work>
void compare_threads(benchmark::State& state, const Amount& amount, Work work) {
    const auto on = [&](int threads) {
        const Threads set(threads);
        return Computed<decltype(work())>{work()};
    };
    compare(
        state, amount, [&] { return on(2); }, [&] { return on(1); });
}

void chain_row(benchmark::State& state, const LazyMesh& mesh) {
    compare_threads(state, mesh.amount(), [&] { return chain(mesh.get()); });
}

void complex_row(benchmark::State& state, const LazyMesh& mesh) {
    const Simplices& cells = mesh.get().simplices;
    compare_threads(state, {mesh.amount().cells, bytes(cells)},
                    [&] { return SimplicialComplex(cells); });
}

void volumes_row(benchmark::State& state, const LazyMesh& mesh) {
    const Points& points = mesh.get().points;
    const SimplicialComplex complex(mesh.get().simplices);
    compare_threads(state, {mesh.amount().cells, bytes(points) + bytes(complex)},
                    [&] { return circumcentric_volumes(complex, points); });
}

void laplacian_row(benchmark::State& state, const LazyMesh& mesh) {
    const SimplicialComplex complex(mesh.get().simplices);
    const CellVolumes volumes = circumcentric_volumes(complex, mesh.get().points);
    compare_threads(state, {mesh.amount().cells, bytes(complex.coboundary(0))}, [&] {
        return symmetric_laplacian({complex, volumes}, 0).matrix();
    });
}

using MeshRow = void (*)(benchmark::State&, const LazyMesh&);

void add(const std::string& name, const SharedMesh& mesh, const Settings& settings, MeshRow row) {
    add_row("threads/" + name, settings.rounds,
            [=](benchmark::State& state) { row(state, *mesh); });
}

void add_stages(const std::string& name, const SharedMesh& mesh, const Settings& settings) {
    add(name, mesh, settings, chain_row);
    add(name + "/complex", mesh, settings, complex_row);
    add(name + "/volumes", mesh, settings, volumes_row);
    add(name + "/laplacian", mesh, settings, laplacian_row);
}

} // namespace

void add_thread_rows(const Settings& settings) {
    if (!has_threads())
        return;
    const int f = settings.side(224), cells = settings.side(64);
    add_stages("sphere", shared_mesh([=] { return icosphere(f); }), settings);
    add_stages("tets", shared_mesh([=] { return kuhn(3, cells); }), settings);
}

} // namespace polydec::benchmarks
