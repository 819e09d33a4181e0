// SPDX-License-Identifier: MIT
// Results are the same to the last bit for any number of threads.
#include "tests/support/test.h"

#include <dlfcn.h>

namespace polydec::test::in_threads {

/// All that several threads work on, for one mesh.
struct Results {
    explicit Results(const Mesh& mesh)
        : K(mesh.simplices),
          volumes(circumcentric_volumes(K, mesh.points)),
          laplacian(symmetric_laplacian({K, volumes}, 1)),
          applied(polydec::laplacian({K, volumes}, 1) *
                  Vector(Vector::LinSpaced(K.size(1), -1, 1))),
          merging(merge_cospherical({K, mesh.points, volumes}).merging),
          merged(merged_volumes(merging, volumes)) {}

    SimplicialComplex K;
    CellVolumes volumes;
    SparseMatrix laplacian;
    Vector applied;
    Merging merging;
    CellVolumes merged;
};

/// A function of the OpenMP runtime that the library loaded, which may not be this compiler's.
template <class Function>
Function* of_openmp(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

Results with_threads(int threads, const Mesh& mesh) {
    const auto max_threads = of_openmp<int()>("omp_get_max_threads");
    const auto set_threads = of_openmp<void(int)>("omp_set_num_threads");
    if (!max_threads || !set_threads)
        throw std::runtime_error("no OpenMP runtime is loaded");
    const int before = max_threads();
    set_threads(threads);
    Results results(mesh);
    set_threads(before);
    return results;
}

bool same_bits(const Vector& a, const Vector& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) ==
               0;
}

template <class Matrix>
bool same_entries(const Matrix& A, const Matrix& B) {
    return A.rows() == B.rows() && A.cols() == B.cols() && A.nonZeros() == B.nonZeros() &&
           (A.nonZeros() == 0 || (A - B).norm() == 0);
}

void expect_same(const Results& a, const Results& b, int n) {
    for (int k = 0; k <= n; ++k) {
        EXPECT_EQ(a.K.simplices(k), b.K.simplices(k));
        EXPECT_TRUE(same_bits(a.volumes.primal(k), b.volumes.primal(k))) << k;
        EXPECT_TRUE(same_bits(a.volumes.dual(k), b.volumes.dual(k))) << k;
        EXPECT_TRUE(same_bits(a.merged.dual(k), b.merged.dual(k))) << k;
        EXPECT_TRUE(same_entries(SparseMatrix(a.K.coboundary(k).cast<double>()),
                                 SparseMatrix(b.K.coboundary(k).cast<double>())));
        EXPECT_EQ(a.K.coface_counts(k), b.K.coface_counts(k));
        EXPECT_EQ(a.merging.merged().size(k), b.merging.merged().size(k));
    }
    EXPECT_TRUE(same_entries(a.laplacian, b.laplacian));
    EXPECT_TRUE(same_bits(a.applied, b.applied));
}

TEST(threads, their_number_changes_no_bit) {
    // large enough to be divided everywhere
    for (const Mesh& mesh : {shuffled(perturbed(torus(240, 120), 1e-3, 3), 4).mesh,
                             shuffled(perturbed(kuhn(3, 16), 1e-2, 5), 6).mesh}) {
        const Results alone = with_threads(1, mesh);
        for (const int threads : {2, 3})
            expect_same(alone, with_threads(threads, mesh), alone.K.dimension());
    }
}

TEST(threads, another_mesh_has_other_bits) {
    const Results a = with_threads(1, perturbed(torus(24, 12), 1e-3, 3));
    const Results b = with_threads(1, perturbed(torus(24, 12), 1e-3, 4));
    EXPECT_FALSE(same_bits(a.volumes.dual(1), b.volumes.dual(1)));
    EXPECT_FALSE(same_bits(a.applied, b.applied));
}

} // namespace polydec::test::in_threads
