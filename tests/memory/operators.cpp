// SPDX-License-Identifier: MIT
// What a mesh's operators take in memory, counted by the program's own malloc.
#include "benchmarks/memory.h"
#include "complex/simplicial_complex.h"
#include "dec/forms/laplacian.h"
#include "dec/forms/star.h"
#include "dec/metric/circumcentric_volumes.h"
#include "meshes/generate.h"

#include <gtest/gtest.h>

namespace polydec::test {
namespace {

/// Bytes for each simplex of top dimension.
struct Bytes {
    double result, peak;
};

template <class Work>
Bytes count(const Mesh& mesh, Work work) {
    const auto cells = static_cast<double>(mesh.simplices.rows());
    benchmarks::forget_peak();
    const double before = benchmarks::live_bytes();
    const auto result = work();
    return {(benchmarks::live_bytes() - before) / cells,
            (benchmarks::peak_bytes() - before) / cells};
}

struct Operators {
    SimplicialComplex complex;
    HodgeStars stars; // with the volumes
    SparseMatrix laplacian;
};

Operators operators(const Mesh& mesh) {
    SimplicialComplex complex(mesh.simplices);
    const HodgeStars stars = circumcentric_volumes(complex, mesh.points);
    return {complex, stars, symmetric_laplacian(complex, stars, 0)};
}

/// A tenth is left for the allocator and for meshes with another share of vertices.
bool is_within(const Bytes& bytes, double result, double peak) {
    return bytes.result <= 1.1 * result && bytes.peak <= 1.1 * peak;
}

class Memory : public testing::Test {
    void SetUp() override {
        if (!benchmarks::counts_memory())
            GTEST_SKIP() << "this program does not count what it allocates";
    }
};
using MemoryBroken = Memory;

TEST_F(Memory, of_a_complex_is_its_tables) {
    const Mesh triangles = icosphere(50), tets = kuhn(3, 16);
    const auto of = [](const Mesh& mesh) {
        return count(mesh, [&] { return SimplicialComplex(mesh.simplices); });
    };
    EXPECT_TRUE(is_within(of(triangles), 45, 100)) << of(triangles).result << of(triangles).peak;
    EXPECT_TRUE(is_within(of(tets), 100, 200)) << of(tets).result << of(tets).peak;
}

TEST_F(Memory, of_all_operators_keeps_to_the_target) {
    const Mesh triangles = icosphere(50), tets = kuhn(3, 16);
    const Bytes in_plane = count(triangles, [&] { return operators(triangles); });
    EXPECT_TRUE(is_within(in_plane, 130, 225)) << in_plane.result << ", " << in_plane.peak;
    const Bytes in_space = count(tets, [&] { return operators(tets); });
    EXPECT_TRUE(is_within(in_space, 190, 350)) << in_space.result << ", " << in_space.peak;
}

TEST_F(MemoryBroken, matrices_that_are_kept_are_beyond_the_target) {
    const Mesh mesh = icosphere(50);
    const Bytes bytes = count(mesh, [&] {
        const SimplicialComplex complex(mesh.simplices);
        complex.coboundary(0);
        complex.coboundary(1);
        return complex;
    });
    EXPECT_FALSE(is_within(bytes, 45, 100));
}

} // namespace
} // namespace polydec::test
