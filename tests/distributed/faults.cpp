// SPDX-License-Identifier: MIT
#include "distributed/mesh_file.h"
#include "distributed/operator_files.h"
#include "distributed/petsc.h"
#include "distributed/poisson.h"
#include "distributed/shared_picture.h"
#include "distributed/spectrum.h"
#include "tests/distributed/binary_files.h"
#include "tests/distributed/common_folder.h"
#include "tests/distributed/compare.h"

#include <sys/resource.h>

namespace polydec::test::in_faults {

/// The whole way, from slices to an operator of merged cells.
void go_the_way(const Ranks& ranks, const Mesh& mesh) {
    const LocalComplex local = distributed(ranks, mesh, Ownership::morton);
    const auto volumes = ranks.together(
        "volumes", [&] { return circumcentric_volumes(local.complex, local.points); });
    const auto cells =
        distributed_cells(ranks, local, merge_cospherical(ranks, local, volumes, {}));
    laplacian(ranks, cells, Side::primal, 1);
}

/// Expects the same text with these words on all ranks, or no error if no words are given.
void expect_everywhere(const Ranks& ranks, const Words& words, const std::string& found) {
    const auto hash = static_cast<GlobalIndex>(std::hash<std::string>{}(found));
    const bool is_other = ranks.largest(hash) != hash;
    EXPECT_FALSE(ranks.any(is_other)) << found;
    if (words.empty())
        EXPECT_EQ(found, "accepted");
    else
        EXPECT_TRUE(says(found, words));
}

/// Lets every local work of some ranks fail in turn, or where these take long about so many.
void expect_faults_everywhere(const Ranks& ranks, const std::string& name,
                              const std::function<void()>& way, int most) {
    int works = 0;
    ranks.listen([&](std::string_view) { ++works; });
    way();
    const int step = is_full_sweep() ? 1 : std::max(1, works / most);
    std::vector<int> guilty_ones{0, ranks.size() - 1};
    if (is_full_sweep()) {
        guilty_ones.resize(static_cast<std::size_t>(ranks.size()));
        std::iota(guilty_ones.begin(), guilty_ones.end(), 0);
    }
    for (const int guilty : guilty_ones)
        for (int fatal = 1 + guilty % step; fatal <= works; fatal += step) {
            int work = 0;
            ranks.listen([&](std::string_view what) {
                if (++work == fatal && ranks.rank() == guilty)
                    throw IoError(fmt::format("{} of rank {}", what, guilty));
            });
            const auto text = message_of<Error>(way);
            EXPECT_NE(text.find(fmt::format("of rank {}", guilty)), std::string::npos)
                << name << ", work " << fatal << " of " << works << ": " << text;
        }
    ranks.listen({});
}

TEST(Faults, of_any_local_work_of_any_rank_are_the_same_error_everywhere) {
    const auto ranks = Ranks::all();
    const Mesh mesh = kuhn(3, 2);
    expect_faults_everywhere(
        ranks, "merging", [&] { go_the_way(ranks, mesh); }, 1000);
}

TEST(Faults, of_reading_and_writing_are_the_same_error_everywhere_and_leave_nothing_behind) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const Mesh given = grid(3, 3);
    const MeshSlice slice = slice_of(ranks, given);
    const DistributedMesh mesh = discretized(ranks, given, Ownership::morton);
    on_rank_0(ranks, [&] {
        const auto put = [&](const char* name, const std::string& text) {
            std::ofstream(folder / name, std::ios::binary) << text;
        };
        put("a.ply", binary_ply(given, {}));
        put("a.msh", binary_gmsh(given, {.is_scrambled = true, .has_more = true}));
        put("a.vtu", binary_vtu(given, {}));
        write_mesh(folder / "a.pdm", given);
        write_mesh(folder / "a.nsc", given);
        std::filesystem::create_directory(folder / "out");
    });
    for (const char* name : {"a.ply", "a.msh", "a.vtu", "a.pdm", "a.nsc"})
        expect_faults_everywhere(
            ranks, name, [&] { read_slice(ranks, folder / name); }, 1000);
    const auto fresh = [&](const char* name) {
        on_rank_0(ranks, [&] {
            std::filesystem::remove_all(folder / "out");
            std::filesystem::create_directory(folder / "out");
        });
        return folder / "out" / name;
    };
    const auto expect_nothing_half = [&](const char* name) {
        ranks.any(false); // all have come
        for (const auto& entry : std::filesystem::directory_iterator(folder / "out"))
            EXPECT_EQ(entry.path().filename().string().find(".tmp"), std::string::npos) << name;
        ranks.any(false); // all have looked
    };
    expect_faults_everywhere(
        ranks, "pdm", [&] { write_slice(ranks, fresh("b.pdm"), slice); }, 1000);
    expect_nothing_half("pdm");
    expect_faults_everywhere(
        ranks, "pvtu", [&] { write_pvtu(ranks, fresh("b.pvtu"), mesh, {}); }, 40);
    expect_nothing_half("pvtu");
    expect_faults_everywhere(
        ranks, "operators", [&] { write_operators(ranks, mesh, fresh("b")); }, 40);
    expect_nothing_half("operators");
}

TEST(Faults, of_solvers_are_the_same_error_everywhere) {
    const auto ranks = Ranks::all();
    const DistributedMesh mesh = discretized(ranks, grid(3, 3), Ownership::morton);
    const auto solve = [&] {
        const SharedPoissonSolver solver(ranks, mesh);
        const Vector ones = Vector::Ones(mesh.cells.degree(0).own());
        solver.solve(ones, ones, Vector::Ones(mesh.cells.degree(1).own()));
    };
    expect_faults_everywhere(ranks, "Poisson", solve, 20);
    expect_faults_everywhere(
        ranks, "spectrum", [&] { spectrum(ranks, mesh, Side::primal, 0, {.count = 3}); }, 20);
}

/// A limit of one rank alone, until it goes.
class LimitOfOne {
public:
    LimitOfOne(bool is_meant, __rlimit_resource kind, rlim_t bytes)
        : is_meant_(is_meant), kind_(kind) {
        ::getrlimit(kind_, &before_);
        const rlimit less{bytes, before_.rlim_max};
        if (is_meant_)
            ::setrlimit(kind_, &less);
    }
    ~LimitOfOne() {
        if (is_meant_)
            ::setrlimit(kind_, &before_);
    }
    LimitOfOne(const LimitOfOne&) = delete;
    LimitOfOne& operator=(const LimitOfOne&) = delete;

private:
    bool is_meant_;
    __rlimit_resource kind_;
    rlimit before_{};
};

TEST(Faults, of_a_rank_that_cannot_write_more_are_told_everywhere_and_leave_no_file) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const Mesh given = grid(60, 60);
    const MeshSlice slice = slice_of(ranks, given);
    const DistributedMesh mesh = discretized(ranks, given, Ownership::morton);
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int guilty : {0, ranks.size() - 1}) {
        std::string picture, sliced;
        {
            const LimitOfOne limit(ranks.rank() == guilty, RLIMIT_FSIZE, 2000);
            sliced = message_of<Error>([&] { write_slice(ranks, folder / "a.pdm", slice); });
            picture = message_of<Error>([&] { write_pvtu(ranks, folder / "a.pvtu", mesh, {}); });
        }
        ranks.any(false);
        // a file of one block is all of rank 0
        EXPECT_EQ(sliced.find("a.pdm") != std::string::npos, guilty == 0) << sliced;
        EXPECT_NE(picture.find("a"), std::string::npos);
        EXPECT_EQ(std::filesystem::exists(folder / "a.pdm"), guilty != 0);
        EXPECT_FALSE(std::filesystem::exists(folder / "a.pvtu"));
        EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    }
}

/// What making a factor of MUMPS with these options ends with.
std::string error_of_mumps(const Ranks& ranks, const DistributedMesh& mesh,
                           const std::string& options) {
    return message_of<Error>([&] {
        SharedPoissonSolver(
            ranks, mesh,
            {.side = Side::dual, .engine = {.name = "petsc.mumps", .options = options}});
    });
}

Words lack_of_memory(int error_of_mumps) {
    return {"petsc.mumps", std::to_string(error_of_mumps), "memory", "ranks"};
}

TEST(Faults, of_a_factor_with_too_little_room_are_mended_by_more) {
    const auto ranks = Ranks::all();
    const DistributedMesh mesh = discretized(ranks, grid(120, 120), Ownership::morton);
    if (error_of_mumps(ranks, mesh, "") != "accepted")
        return; // PETSc has no MUMPS
    expect_everywhere(ranks, {}, error_of_mumps(ranks, mesh, "-mat_mumps_icntl_14 -90"));
}

TEST(Faults, of_a_factor_without_memory_are_the_same_error_everywhere) {
    const auto ranks = Ranks::all();
    const DistributedMesh mesh = discretized(ranks, grid(120, 120), Ownership::morton);
    if (error_of_mumps(ranks, mesh, "") != "accepted")
        return; // PETSc has no MUMPS
    expect_everywhere(ranks, lack_of_memory(-19),
                      error_of_mumps(ranks, mesh, "-mat_mumps_icntl_23 1")); // MB
#ifndef __SANITIZE_ADDRESS__ // which ends a program that asks for so much
    constexpr rlim_t terabyte = rlim_t{1} << 40;
    const LimitOfOne limit(ranks.rank() == ranks.size() - 1, RLIMIT_AS, terabyte);
    expect_everywhere(ranks, lack_of_memory(-13),
                      error_of_mumps(ranks, mesh, "-mat_mumps_icntl_14 2000000000")); // percent
#endif
}

TEST(Faults, memory_that_does_not_suffice_is_told_everywhere) {
    const auto ranks = Ranks::all();
    expect_everywhere(ranks, {"memory", "ranks"}, message_of<Error>([&] {
                          ranks.together("memory", [&] {
                              if (ranks.rank() == ranks.size() - 1)
                                  throw std::bad_alloc();
                          });
                      }));
}

TEST(Faults, of_the_mesh_are_named_by_the_numbers_of_the_file) {
    const auto ranks = Ranks::all();
    const auto refused = [&](const Mesh& mesh) {
        return message_of<Error>([&] { distributed(ranks, mesh, Ownership::random); });
    };
    Mesh mesh = grid(4, 4);
    const Simplices cells = mesh.simplices;
    const Index vertices = static_cast<Index>(mesh.points.rows());
    mesh.simplices(17, 1) = 99;
    expect_everywhere(ranks, {"cell 17", "vertex 99", "0", std::to_string(vertices - 1)},
                      refused(mesh));
    mesh.simplices = cells;
    mesh.simplices.row(30) = cells.row(2).reverse();
    expect_everywhere(ranks, {"cells 2", "30", "vertices 2, 7, 8"}, refused(mesh));
    mesh.simplices = cells;
    mesh.simplices(30, 0) = mesh.simplices(30, 1);
    EXPECT_SAYS(refused(mesh), "cell 30", "corner");
    mesh.simplices = cells;
    mesh.points(21, 1) = std::nan("");
    expect_everywhere(ranks, {"vertex 21", "coordinate", "finite"}, refused(mesh));
}

} // namespace polydec::test::in_faults
