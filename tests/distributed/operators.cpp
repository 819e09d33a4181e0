// SPDX-License-Identifier: MIT
#include "distributed/operator_files.h"
#include "distributed/petsc.h"
#include "tests/distributed/common_folder.h"
#include "tests/distributed/compare.h"

#include <petscviewer.h>

namespace polydec::test::in_operators {

/// Largest difference of own rows from those of one process, in parts of its largest entry.
double difference(const Ranks& ranks, const DistributedCells& cells, int k, Mat matrix,
                  const SparseMatrix& whole) {
    const auto& own = cells.degree(k);
    const auto numbers = ranks.of_all(own.number); // in the order of rows
    double largest = 0, most = 0;
    for (Eigen::Index e = 0; e < whole.nonZeros(); ++e)
        largest = std::max(largest, std::abs(whole.valuePtr()[e]));
    for (std::size_t i = 0; i < own.first.size(); ++i) {
        const auto row = static_cast<PetscInt>(own.first_row + static_cast<GlobalIndex>(i));
        const auto cell = static_cast<Index>(own.number[i]);
        Vector expected = Vector(whole.row(cell).transpose());
        PetscInt count = 0;
        const PetscInt* columns = nullptr;
        const double* entries = nullptr;
        MatGetRow(matrix, row, &count, &columns, &entries);
        for (PetscInt e = 0; e < count; ++e)
            expected[static_cast<Index>(numbers[columns[e]])] -= entries[e];
        MatRestoreRow(matrix, row, &count, &columns, &entries);
        most = std::max(most, expected.cwiseAbs().maxCoeff());
    }
    return largest > 0 ? most / largest : most;
}

/// Both are refused, or differ by rounding.
void expect_equal(const Ranks& ranks, const DistributedCells& cells, int k, const std::string& what,
                  const std::function<OwnedMat()>& matrix,
                  const std::function<SparseMatrix()>& whole) {
    std::optional<SparseMatrix> expected;
    try {
        expected = whole();
    } catch (const InvalidInput&) {
        EXPECT_THROW(matrix(), InvalidInput) << what;
        return;
    }
    constexpr double rounding = 1e-14;
    EXPECT_LE(difference(ranks, cells, k, matrix().get(), *expected), rounding) << what;
}

constexpr Index most_cells = 4000; // each row is looked at with all its zeros

TEST(DistributedOperators, are_those_of_one_process_in_every_degree_on_both_sides) {
    const auto ranks = Ranks::all();
    const MergeOptions options{MergeCriterion::dual_length, tolerance};
    for (const auto& [name, mesh] : swept(ranks, most_cells)) {
        const Merged whole = make_merged(mesh, options);
        const LocalComplex local = distributed(ranks, mesh, some_ownerships(ranks, name).back());
        const auto volumes = circumcentric_volumes(local.complex, local.points);
        const auto cells =
            distributed_cells(ranks, local, merge_cospherical(ranks, local, volumes, options));
        const CellVolumes stars = merged_volumes(whole.merging(), whole.result.geometry.volumes());
        const int n = whole.n();
        for (int k = 0; k <= n; ++k) {
            const auto in = [&, of = name](const char* what) {
                return fmt::format("{} of degree {}, {}", what, k, of);
            };
            expect_equal(
                ranks, cells, k, in("Laplacian"),
                [&] { return laplacian(ranks, cells, Side::primal, k); },
                [&] {
                    return laplacian({whole.P(), stars}, k).matrix();
                });
            expect_equal(
                ranks, cells, n - k, in("dual Laplacian"),
                [&] { return laplacian(ranks, cells, Side::dual, k); },
                [&] {
                    return dual_laplacian({whole.P(), stars}, k).matrix();
                });
            expect_equal(
                ranks, cells, k, in("symmetric Laplacian"),
                [&] { return symmetric_laplacian(ranks, cells, k); },
                [&] {
                    return symmetric_laplacian({whole.P(), stars}, k).matrix();
                });
        }
    }
}

TEST(DistributedOperators, that_divide_by_zero_name_cells_of_all_ranks) {
    const auto ranks = Ranks::all();
    const Mesh mesh = grid(6, 5); // whose diagonals have no duals
    const MeshSlice slice = slice_of(ranks, mesh);
    const auto parts = discretize(ranks, slice, vertex_owners(ranks, slice, Ownership::random),
                                  {.criterion = MergeCriterion::none});
    const Discretization whole = circumcentric(mesh, {.criterion = MergeCriterion::none});
    const auto expected = refusal([&] { star(whole.volumes(), 1).inverse(); });
    EXPECT_SAYS(expected, "30 1-cells");
    EXPECT_EQ(refusal([&] { laplacian(ranks, parts.cells, Side::primal, 1); }), expected);
}

/// What a file holds, read by this rank alone.
OwnedMat loaded(const std::filesystem::path& path) {
    PetscViewer viewer = nullptr;
    Mat matrix = nullptr;
    PetscViewerBinaryOpen(PETSC_COMM_SELF, path.c_str(), FILE_MODE_READ, &viewer);
    MatCreate(PETSC_COMM_SELF, &matrix);
    MatSetType(matrix, MATSEQAIJ);
    MatLoad(matrix, viewer);
    PetscViewerDestroy(&viewer);
    return OwnedMat(matrix);
}

/// Largest difference of the entries of two matrices, rows in the same order.
double difference(Mat matrix, const SparseMatrix& whole) {
    DenseMatrix rest = whole;
    for (PetscInt row = 0; row < whole.rows(); ++row) {
        PetscInt count = 0;
        const PetscInt* columns = nullptr;
        const double* entries = nullptr;
        MatGetRow(matrix, row, &count, &columns, &entries);
        for (PetscInt e = 0; e < count; ++e)
            rest(row, columns[e]) -= entries[e];
        MatRestoreRow(matrix, row, &count, &columns, &entries);
    }
    return rest.size() > 0 ? rest.cwiseAbs().maxCoeff() : 0;
}

TEST(OperatorFiles, stand_in_the_order_of_numbers_for_any_number_of_ranks) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    for (const char* name : {"kuhn3", "uv8", "grid4"}) {
        const Mesh& given = mesh_named(name);
        const Discretization whole = circumcentric(given);
        const DistributedMesh mesh = discretized(ranks, given, Ownership::random);
        EXPECT_TRUE(write_operators(ranks, mesh, folder / name).empty());
        const auto file = [&](const std::string& of) { return folder / name / (of + ".petsc"); };
        for (int k = 0; k < whole.dimension(); ++k) {
            const SparseMatrix d = whole.complex().coboundary(k).cast<double>();
            EXPECT_EQ(difference(loaded(file(fmt::format("d_{}", k))).get(), d), 0) << name;
        }
        const SparseMatrix L = laplacian(whole, 0).matrix();
        EXPECT_LE(difference(loaded(file("laplacian_primal_0")).get(), L), 1e-12 * L.norm());
        const SparseMatrix twin = 2 * L;
        EXPECT_GT(difference(loaded(file("laplacian_primal_0")).get(), twin), 1e-12 * L.norm());
    }
    on_rank_0(ranks, [&] {
        std::filesystem::create_directory(folder / "other");
        std::ofstream(folder / "other" / "file.txt") << "not ours";
    });
    const DistributedMesh mesh = discretized(ranks, mesh_named("grid4"), Ownership::file);
    EXPECT_THROW(write_operators(ranks, mesh, folder / "other"), InvalidInput);
}

} // namespace polydec::test::in_operators
