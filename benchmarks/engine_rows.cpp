// SPDX-License-Identifier: MIT
#include "backends/registry.h"
#include "benchmarks/backends/bare_engines.h"
#include "benchmarks/chain.h"
#include "benchmarks/rows.h"
#include "dec/boundary/boundary_conditions.h"
#include "dec/forms/laplacian.h"
#include "dec/stars/star.h"
#include "meshes/generate.h"
#include "solvers/sources/poisson.h"
#include "solvers/spectra/spectrum.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace polydec::benchmarks {

namespace {

/// The matrix of Delta u = f with u = 0 on the boundary, and a right-hand side.
struct Dirichlet {
    RelativeComplex inside;
    SparseMatrix A;
    Vector b;

    explicit Dirichlet(const Discretization& cells)
        : inside(relative_complex(cells.complex(), essential_cells(cells.complex(), {}))) {
        const auto volumes = relative_volumes(inside, cells.volumes());
        A = symmetric_laplacian({inside.complex, volumes}, 0);
        b = star(volumes, 0).diagonal();
    }
    Amount amount() const { return {static_cast<double>(A.rows()), polydec::benchmarks::bytes(A)}; }
};

std::unique_ptr<LinearSolver> factorized(const std::string& name, const Dirichlet& problem,
                                         int dimension) {
    auto solver = make_linear_solver(name);
    // The matrix is shared with the engine, as the solvers of the library do.
    const std::shared_ptr<const SparseMatrix> A(&problem.A, [](const SparseMatrix*) {});
    solver->factorize(A, {.symmetry = Symmetry::symmetric,
                          .definiteness = Definiteness::positive,
                          .domain_dimension = dimension});
    return solver;
}

Vector solve_by_engine(const std::string& name, const Dirichlet& problem, int dimension) {
    return factorized(name, problem, dimension)->solve(problem.b);
}

Vector solve_by_library(const std::string& name, const Discretization& cells) {
    const PoissonSolver solver({cells, Side::primal, 0, {}}, name);
    return solver.solve({Side::primal, 0, Vector::Ones(cells.complex().size(0))}).form.values;
}

using BareSolve = Vector (*)(const SparseMatrix&, const Vector&);

/// What the library's engine costs over the bare one, on the same matrix.
void engine_row(benchmark::State& state, const std::string& name, BareSolve bare, Mesh mesh) {
    const auto dimension = static_cast<int>(mesh.simplices.cols()) - 1;
    const Dirichlet problem(discretize(std::move(mesh)));
    compare(
        state, problem.amount(), [&] { return solve_by_engine(name, problem, dimension); },
        [&] { return bare(problem.A, problem.b); });
}

/// Several right-hand sides at once beside one after the other, with the factorization there.
/// Times are those of one of them.
void several_row(benchmark::State& state, const std::string& name, int rows) {
    constexpr int count = 8;
    const Dirichlet problem(discretize(well_centered(rows)));
    const DenseMatrix B = DenseMatrix::Random(problem.A.rows(), count);
    const auto solver = factorized(name, problem, 2);
    compare(
        state, problem.amount(), [&] { return solver->solve(B); },
        [&] {
            DenseMatrix X(B.rows(), B.cols());
            for (int j = 0; j < count; ++j)
                X.col(j) = solver->solve(B.col(j));
            return X;
        });
    for (const char* counter : {"min_s", "median_s", "rival_min_s", "rival_median_s", "bound_s"})
        state.counters[counter].value /= count;
}

/// The whole problem, assembly included, beside the bare engine on the matrix.
void poisson_row(benchmark::State& state, const std::string& name, BareSolve bare, Mesh mesh) {
    const auto cells = discretize(std::move(mesh));
    const Dirichlet problem(cells);
    compare(
        state, problem.amount(),
        [&] { return problem.inside.restrict(0, solve_by_library(name, cells)); },
        [&] { return bare(problem.A, problem.b); });
}

void solid_row(benchmark::State& state, const std::string& engine, const Settings& settings) {
    const int side = settings.side(101);
    const auto cells = discretize(kuhn(3, side));
    const Amount amount{std::pow(side - 1.0, 3), bytes(cells.volumes())};
    measure(state, amount, [&] { return solve_by_library(engine, cells); });
}

/// Eigenvalues of which copies may be missing, so that they need not be ours.
struct Uncertified {
    Vector values;
};

double difference(const Vector&, const Uncertified&) {
    return 0;
}

/// How many of the complete eigenvalues the others lack, both ascending.
double missing(const Vector& complete, const Vector& others) {
    const double same = 1e-6 * complete.cwiseAbs().maxCoeff();
    Eigen::Index next = 0;
    for (const double value : complete)
        if (next < others.size() && std::abs(others[next] - value) <= same)
            ++next;
    return static_cast<double>(complete.size() - next);
}

void spectrum_row(benchmark::State& state, const Settings& settings, Mesh mesh) {
    const auto cells = discretize(std::move(mesh));
    const Index count = settings.smoke ? 10 : 50;
    const SparseMatrix A = symmetric_laplacian({cells.complex(), cells.volumes()}, 0);
    const Vector M = cells.stars()[0].diagonal();
    Vector ours, theirs;
    compare(
        state, {static_cast<double>(A.rows()), bytes(A)},
        [&] {
            return ours = spectrum({cells, Side::primal, 0}, {.count = count}).eigenvalues;
        },
        [&] {
            theirs = eigenvalues_by_bare_spectra(A, M, count);
            return Uncertified{theirs};
        });
    state.counters["rival_missing"] = missing(ours, theirs);
}

void add_solid_rows(const Settings& settings) {
    const int rounds = std::min(settings.rounds, 3);
    const bool has_hypre = has_bare_hypre() && has_linear_solver("petsc.cg-hypre");
    // 238 k and 1 M unknowns
    const int small = settings.side(63), large = settings.side(101);
    if (has_hypre) {
        add_row("engine/petsc.cg-hypre", settings.rounds, [=](benchmark::State& state) {
            engine_row(state, "petsc.cg-hypre", solve_by_bare_hypre, kuhn(3, small));
        });
        add_row("poisson3d/petsc.cg-hypre", rounds, [=](benchmark::State& state) {
            poisson_row(state, "petsc.cg-hypre", solve_by_bare_hypre, kuhn(3, large));
        });
    }

    // `auto`, which takes eigen.cg where nothing better is there, and what is made for solids.
    for (const auto& engine : engines()) {
        const bool is_petsc =
            engine.name.starts_with("petsc") && !(has_hypre && engine.name == "petsc.cg-hypre");
        if (engine.kind == EngineKind::linear && engine.available &&
            (is_petsc || engine.name == "auto"))
            add_row("poisson3d/" + engine.name, rounds,
                    [=](benchmark::State& state) { solid_row(state, engine.name, settings); });
    }
}

} // namespace

void add_engine_rows(const Settings& settings) {
    const int rounds = std::min(settings.rounds, 3);
    // 500 k and 50 k unknowns
    const int large = settings.side(380), small = settings.side(120);
    if (has_bare_cholmod() && has_linear_solver("cholmod")) {
        add_row("engine/cholmod", settings.rounds, [=](benchmark::State& state) {
            engine_row(state, "cholmod", solve_by_bare_cholmod, well_centered(large));
        });
        add_row("engine/cholmod_8", settings.rounds,
                [=](benchmark::State& state) { several_row(state, "cholmod", large); });
        add_row("poisson2d/cholmod", settings.rounds, [=](benchmark::State& state) {
            poisson_row(state, "cholmod", solve_by_bare_cholmod, well_centered(large));
        });
        add_row("spectrum/50", rounds, [=](benchmark::State& state) {
            spectrum_row(state, settings, icosphere(settings.side(128)));
        });
        add_row("spectrum/torus", rounds, [=](benchmark::State& state) {
            spectrum_row(state, settings, torus(settings.side(280), settings.side(140)));
        });
        add_row("spectrum/tets", rounds, [=](benchmark::State& state) {
            spectrum_row(state, settings, kuhn(3, settings.side(29)));
        });
    }
    add_row("engine/eigen.ldlt", settings.rounds, [=](benchmark::State& state) {
        engine_row(state, "eigen.ldlt", solve_by_bare_ldlt, well_centered(small));
    });
    add_solid_rows(settings);
}

} // namespace polydec::benchmarks
