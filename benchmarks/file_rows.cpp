// SPDX-License-Identifier: MIT
#include "benchmarks/chain.h"
#include "benchmarks/rows.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/laplacian.h"
#include "io/meshes/mesh_files.h"
#include "io/pictures/draw_cells.h"
#include "meshes/generate.h"
#include "solvers/sources/poisson.h"

#include <chrono>
#include <map>
#include <utility>

namespace polydec::benchmarks {

namespace {

/// The time of each stage, round by round.
class Stages {
public:
    /// Ends the stage before and begins one; with an empty name it begins none.
    void next(const std::string& name) {
        const auto now = std::chrono::steady_clock::now();
        if (!name_.empty())
            seconds_[name_].push_back(std::chrono::duration<double>(now - begin_).count());
        name_ = name;
        begin_ = now;
    }
    void report(benchmark::State& state) const {
        for (const auto& [name, seconds] : seconds_)
            state.counters["stage_" + name] = median(seconds);
    }

private:
    std::string name_;
    std::chrono::steady_clock::time_point begin_;
    std::map<std::string, std::vector<double>> seconds_;
};

/// From a file to the operators of the merged mesh, a solution of Poisson's problem, and a file.
SparseMatrix whole_way(const std::filesystem::path& from, const std::filesystem::path& to,
                       Stages& stages) {
    stages.next("1_read");
    Mesh mesh = read_mesh(from);
    const auto cells = discretize(std::move(mesh), {}, [&](std::string_view stage) {
        const bool first = stage == "complex", second = stage == "volumes";
        stages.next((first ? "2_" : second ? "3_" : "4_") + std::string(stage));
    });
    stages.next("5_operators");
    SparseMatrix laplacian = symmetric_laplacian(cells, 0);
    stages.next("6_poisson");
    const PoissonSolver solver({cells, Side::primal, 0, {}});
    const Vector u = solver.solve({Side::primal, 0, cells.points().col(0)}).form.values;
    stages.next("7_write");
    auto grid = draw_cells(cells, 0);
    add_cochain(grid, cells.complex(), 0, "u", u);
    write_vtu(to, grid);
    stages.next("");
    return laplacian;
}

void add_reading(const std::string& name, const SharedMesh& mesh, const Settings& settings) {
    const auto path = settings.folder / ("mesh." + name);
    add_row("read/" + name, settings.rounds, [=](benchmark::State& state) {
        write_mesh(path, mesh->get());
        const auto size = static_cast<double>(std::filesystem::file_size(path));
        measure(state, {mesh->amount().cells, size}, [&] { return read_mesh(path); });
        state.counters["file_B"] = size;
        state.counters["file_B_per_s"] = size / double{state.counters["min_s"]};
        std::filesystem::remove(path);
    });
}

void whole_row(benchmark::State& state, const LazyMesh& mesh, const Settings& settings) {
    const auto from = settings.folder / "whole.ply", to = settings.folder / "whole.vtu";
    write_mesh(from, mesh.get());
    Stages first, stages;
    bool is_first = true;
    measure(state, {mesh.amount().cells, static_cast<double>(std::filesystem::file_size(from))},
            [&] { return whole_way(from, to, std::exchange(is_first, false) ? first : stages); });
    stages.report(state);
}

} // namespace

void add_file_rows(const Settings& settings) {
    const int m = settings.side(1000);
    // files of about 100 MB each
    add_reading("obj", shared_mesh([=] { return torus(2 * m, m / 2); }), settings);
    const auto large = shared_mesh([=] { return torus(2 * m, m); });
    add_reading("ply", large, settings);
    add_row("whole/4M", std::min(settings.rounds, 3),
            [=](benchmark::State& state) { whole_row(state, *large, settings); });
}

} // namespace polydec::benchmarks
