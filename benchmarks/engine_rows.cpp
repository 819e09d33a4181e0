// SPDX-License-Identifier: MIT
#include "backends/registry.h"
#include "benchmarks/backends/bare_engines.h"
#include "benchmarks/chain.h"
#include "benchmarks/rows.h"
#include "dec/boundary_conditions.h"
#include "dec/laplacian.h"
#include "dec/star.h"
#include "meshes/generate.h"
#include "solvers/poisson.h"
#include "solvers/spectrum.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace polydec::benchmarks {

namespace {

/// The matrix of Delta u = f with u = 0 on the boundary, and a right-hand side.
struct Dirichlet {
    RelativeComplex inside;
    SparseMatrix A;
    Vector b;

    explicit Dirichlet(const Discretization& cells)
        : inside(relative_complex(cells.complex(), essential_cells(cells.complex(), {}))) {
        const auto volumes = relative_volumes(inside, cells.volumes);
        A = symmetric_laplacian(inside.complex, volumes, 0);
        b = star(volumes, 0);
    }
    Amount amount() const { return {static_cast<double>(A.rows()), polydec::benchmarks::bytes(A)}; }
};

Vector solve_by_engine(const std::string& name, const Dirichlet& problem, int dimension) {
    const auto solver = make_linear_solver(name);
    // The matrix is shared with the engine, as the solvers of the library do.
    const std::shared_ptr<const SparseMatrix> A(&problem.A, [](const SparseMatrix*) {});
    solver->factorize(A, {.symmetry = Symmetry::symmetric,
                          .definiteness = Definiteness::positive,
                          .domain_dimension = dimension});
    return solver->solve(problem.b);
}

Vector solve_by_library(const std::string& name, const Discretization& cells) {
    PoissonSolver solver(cells, {.linear_solver = name});
    return solver.solve(Vector::Ones(solver.sites().rows()),
                        Vector::Zero(solver.boundary_sites().rows()));
}

using BareSolve = Vector (*)(const SparseMatrix&, const Vector&);

/// What the library's engine costs over the bare one, on the same matrix.
void engine_row(benchmark::State& state, const std::string& name, BareSolve bare, int rows) {
    const Dirichlet problem(discretize(well_centered(rows)));
    compare(
        state, problem.amount(), [&] { return solve_by_engine(name, problem, 2); },
        [&] { return bare(problem.A, problem.b); });
}

/// The whole problem, assembly included, beside the bare engine on the matrix.
void poisson_2d_row(benchmark::State& state, int rows) {
    const auto cells = discretize(well_centered(rows));
    const Dirichlet problem(cells);
    compare(
        state, problem.amount(),
        [&] { return problem.inside.restrict(0, solve_by_library("cholmod", cells)); },
        [&] { return solve_by_bare_cholmod(problem.A, problem.b); });
}

void poisson_3d_row(benchmark::State& state, const std::string& engine, const Settings& settings) {
    const int side = settings.side(101);
    const auto cells = discretize(kuhn(3, side));
    const Amount amount{std::pow(side - 1.0, 3), bytes(cells.volumes)};
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

void spectrum_row(benchmark::State& state, const Settings& settings) {
    const auto cells = discretize(icosphere(settings.side(128)));
    const Index count = settings.smoke ? 10 : 50;
    const SparseMatrix A = symmetric_laplacian(cells.complex(), cells.volumes, 0);
    const Vector M = star(cells.volumes, 0);
    Vector ours, theirs;
    compare(
        state, {static_cast<double>(A.rows()), bytes(A)},
        [&] { return ours = spectrum(cells, {.count = count}).eigenvalues; },
        [&] {
            theirs = eigenvalues_by_bare_spectra(A, M, count);
            return Uncertified{theirs};
        });
    state.counters["rival_missing"] = missing(ours, theirs);
}

} // namespace

void add_engine_rows(const Settings& settings) {
    const int rounds = std::min(settings.rounds, 3);
    // 500 k and 50 k unknowns
    const int large = settings.side(380), small = settings.side(120);
    if (has_bare_cholmod() && has_linear_solver("cholmod")) {
        add_row("engine/cholmod", settings.rounds, [=](benchmark::State& state) {
            engine_row(state, "cholmod", solve_by_bare_cholmod, large);
        });
        add_row("poisson2d/cholmod", settings.rounds,
                [=](benchmark::State& state) { poisson_2d_row(state, large); });
        add_row("spectrum/50", rounds,
                [=](benchmark::State& state) { spectrum_row(state, settings); });
    }
    add_row("engine/eigen.ldlt", settings.rounds, [=](benchmark::State& state) {
        engine_row(state, "eigen.ldlt", solve_by_bare_ldlt, small);
    });

    // `auto`, which takes eigen.cg where nothing better is there, and what is made for solids.
    for (const auto& engine : engines()) {
        const bool is_petsc = engine.name.starts_with("petsc");
        if (engine.kind == EngineKind::linear && engine.available &&
            (is_petsc || engine.name == "auto"))
            add_row("poisson3d/" + engine.name, rounds,
                    [=](benchmark::State& state) { poisson_3d_row(state, engine.name, settings); });
    }
}

} // namespace polydec::benchmarks
