// SPDX-License-Identifier: MIT
#include "distributed/poisson.h"

#include "tests/distributed/compare.h"

namespace polydec::test::in_poisson {

constexpr Index most_cells = 20000;
constexpr const char* cases[] = {"dirichlet", "neumann", "mixed"};

BoundaryConditions conditions(const std::string& which, const Points& sites) {
    if (which == "dirichlet")
        return {};
    if (which == "neumann")
        return {BoundaryCondition::natural};
    return essential_where(sites, [&](const Vector& site) { return site[0] < 0.4; });
}

/// Some function of a place that no symmetry makes vanish.
Vector data(const Points& sites, double phase) {
    Vector result(sites.rows());
    for (Index i = 0; i < sites.rows(); ++i)
        result[i] = std::cos(phase + sites.row(i).sum()) + 0.3 * sites(i, 0);
    return result;
}

/// The solution for a size times such data.
Solution solved(const Ranks& ranks, const DistributedMesh& mesh, Side side,
                const SharedPoissonSolver& solver, double size = 1) {
    const int n = mesh.dimension();
    const Points sites = cell_centers(ranks, mesh, side == Side::primal ? 0 : n),
                 facets = cell_centers(ranks, mesh, n - 1);
    return solver.solve(size * data(sites, 0),
                        size * data(side == Side::primal ? sites : facets, 1),
                        size * data(facets, 2));
}

/// Largest difference from the solution of one process, in parts of its largest value.
double difference(const Ranks& ranks, const DistributedCells::Degree& cells, const Vector& own,
                  const Vector& whole) {
    double most = 0;
    for (std::size_t i = 0; i < cells.number.size(); ++i)
        most = std::max(most, std::abs(own[static_cast<Index>(i)] -
                                       whole[static_cast<Index>(cells.number[i])]));
    const double size = whole.size() > 0 ? whole.cwiseAbs().maxCoeff() : 0;
    return ranks.largest(size > 0 ? most / size : most);
}

/// What one process makes of a problem; none if it refuses it.
std::optional<PoissonSolution> of_one_process(const Discretization& mesh, Side side,
                                              const BoundaryConditions& conditions) {
    try {
        return PoissonSolver({mesh, side, 0, conditions})
            .solve({side, 0, data(sites(mesh, side), 0)},
                   {.values = data(boundary_sites(mesh, side), 1),
                    .derivative_flow = outward_flow(mesh, side, data(facet_sites(mesh), 2))});
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Whether one process solves it too, and not only refuses it likewise.
bool expect_equal(const Ranks& ranks, const Discretization& whole, const DistributedMesh& mesh,
                  Side side, const std::string& which, const std::string& in) {
    const int n = whole.dimension();
    const auto expected = of_one_process(whole, side, conditions(which, facet_sites(whole)));
    const auto solve = [&] {
        const SharedPoissonSolver solver(
            ranks, mesh,
            {.side = side, .boundary = conditions(which, cell_centers(ranks, mesh, n - 1))});
        return solved(ranks, mesh, side, solver);
    };
    if (!expected) {
        EXPECT_THROW(solve(), Error) << in;
        return false;
    }
    const auto found = solve();
    // no solution is known better than its residual shows: 4e-8 on triangles 1e-7 as high as long
    const double close =
        std::max(1e-9, 100 * std::max(found.report.residual, expected->report.residual));
    const int k = side == Side::primal ? 0 : n;
    EXPECT_LE(difference(ranks, mesh.cells.degree(k), found.values, expected->form.values), close)
        << in << " with " << found.report.engine << ", residual " << found.report.residual;
    EXPECT_EQ(found.compatibility.free_components, expected->compatibility.free_components) << in;
    EXPECT_NEAR(found.compatibility.worst, expected->compatibility.worst, 1e-12) << in;

    Vector twin = found.values; // that is off in one place, on one rank
    if (ranks.rank() == 0 && twin.size() > 0)
        twin[0] += 1e-7 * (1 + expected->form.values.cwiseAbs().maxCoeff());
    if (ranks.largest(ranks.rank() == 0 ? std::ssize(mesh.cells.degree(k).number) : 0) > 0) {
        EXPECT_GT(difference(ranks, mesh.cells.degree(k), twin, expected->form.values), close)
            << in;
    }
    return true;
}

TEST(DistributedPoisson, has_the_solution_of_one_process_with_all_conditions_on_both_sides) {
    const auto ranks = Ranks::all();
    std::size_t solved = 0;
    for (const auto& [name, given] : swept(ranks, most_cells)) {
        const Discretization whole = circumcentric(given);
        const DistributedMesh mesh = discretized(ranks, given, some_ownerships(ranks, name).back());
        for (const Side side : {Side::primal, Side::dual})
            for (const std::string which : cases)
                solved +=
                    expect_equal(ranks, whole, mesh, side, which,
                                 fmt::format("{}, {} side, {}", name, polydec::name(side), which));
    }
    EXPECT_GT(solved, 4 * meshes().size());
}

/// Else it is noise, which pictures show in all colors. Where a vertex has a negative dual the
/// means have other weights than the source.
TEST(DistributedPoisson, a_constant_source_on_a_closed_mesh_has_the_solution_0) {
    const auto ranks = Ranks::all();
    std::size_t solved = 0;
    for (const auto& [name, given] : swept(ranks, most_cells)) {
        const Discretization whole = circumcentric(given);
        if (!boundary_facets(whole.complex()).empty() || !(whole.volumes().dual(0).minCoeff() > 0))
            continue;
        const DistributedMesh mesh = discretized(ranks, given, some_ownerships(ranks, name).back());
        std::optional<SharedPoissonSolver> solver;
        try {
            solver.emplace(ranks, mesh, SharedPoissonOptions{});
        } catch (const Error&) { // the mesh has no such star
            continue;
        }
        const auto found = solver->solve(Vector::Ones(mesh.cells.degree(0).own()));
        EXPECT_TRUE(found.values.isZero(0)) << name;
        ++solved;
    }
    EXPECT_GT(solved, 3U);
}

TEST(DistributedPoisson, solutions_are_as_large_as_the_data) {
    const auto ranks = Ranks::all();
    const DistributedMesh mesh = discretized(ranks, meshes().front().mesh, Ownership::morton);
    for (const Side side : {Side::primal, Side::dual}) {
        const SharedPoissonSolver solver(ranks, mesh, {.side = side});
        const Vector usual = solved(ranks, mesh, side, solver).values;
        for (const int exponent : {-1000, -600, 600, 1000}) {
            const double size = std::ldexp(1.0, exponent);
            const Vector values = solved(ranks, mesh, side, solver, size).values / size;
            EXPECT_LE(ranks.largest((values - usual).cwiseAbs().sum()),
                      1e-9 * ranks.largest(usual.cwiseAbs().sum()))
                << polydec::name(side) << ", 2^" << exponent;
        }
    }
}

TEST(DistributedPoisson, every_engine_gives_the_same_and_options_that_nobody_reads_are_refused) {
    const auto ranks = Ranks::all();
    const Mesh& given = meshes().front().mesh;
    const DistributedMesh mesh = discretized(ranks, given, Ownership::morton);
    std::optional<Vector> first;
    for (const char* engine : {"petsc.cg-hypre", "petsc.cg-gamg", "petsc.mumps"}) {
        const SharedPoissonSolver solver(ranks, mesh, {.engine = {engine}});
        const auto found = solved(ranks, mesh, Side::primal, solver);
        EXPECT_EQ(found.report.engine, engine);
        if (!first)
            first = found.values;
        EXPECT_TRUE(found.values.isApprox(*first, 1e-9) || found.values.size() == 0) << engine;
    }
    const auto with = [&](const SharedEngine& engine) {
        return SharedPoissonSolver(ranks, mesh, {.engine = engine});
    };
    EXPECT_THROW(with({"petsc.cg-gamg", "-ksp_tpye fcg"}), InvalidInput);
    EXPECT_THROW(with({"petsc.cg-gamg", "ksp_type fcg"}), InvalidInput);
    EXPECT_THROW(with({"cholmod"}), InvalidInput);
    EXPECT_NO_THROW(with({"petsc.cg-gamg", "-ksp_type fcg"}));
}

} // namespace polydec::test::in_poisson
