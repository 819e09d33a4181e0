// SPDX-License-Identifier: MIT
#include "solvers/poisson.h"

#include "base/errors.h"
#include "dec/advice.h"
#include "dec/fields/cell_centers.h"
#include "dec/forms/gram.h"
#include "dec/forms/laplacian.h"
#include "dec/material_stars.h"
#include "meshes/unit_of_length.h"
#include "solvers/dual_fluxes.h"
#include "solvers/mixed_poisson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

Definiteness by_sign(const Vector& weights) {
    return (weights.array() >= 0).all() ? Definiteness::semidefinite : Definiteness::indefinite;
}

/// Without entries that cancel, which are no connections.
SparseMatrix connections(SparseMatrix gram) {
    gram.prune(0.0);
    return gram;
}

void check_values(const DenseMatrix& values, const Points& sites, const char* what) {
    if (values.rows() != sites.rows())
        throw InvalidInput(
            fmt::format("{}: {} values for {} places", what, values.rows(), sites.rows()));
    for (Index j = 0; j < values.cols(); ++j)
        for (Index i = 0; i < values.rows(); ++i)
            if (!std::isfinite(values(i, j)))
                throw InvalidInput(fmt::format("{}: value {} is {}", what, i, values(i, j)));
}

/// What fixed unknowns take away from the right-hand sides of the others.
SparseMatrix load_of_fixed(const ConstrainedSystem& system) {
    SparseMatrix result = system.A;
    result.prune([&](Eigen::Index row, Eigen::Index column, double) {
        return system.fixed[column] && !system.fixed[row];
    });
    return result;
}

/// 1 for each facet that a natural condition concerns, 0 for the others.
Vector natural_facets(const CellComplex& complex, const CellMarks& essential) {
    const int n = complex.dimension();
    Vector result = Vector::Zero(complex.size(n - 1));
    for (Index f = 0; f < result.size(); ++f)
        if (complex.coface_counts(n - 1)[f] == 1 && !essential[n - 1][f])
            result[f] = 1;
    return result;
}

/// The mesh with the star of flows that belongs to a conductivity.
Discretization with_conductivity(const Discretization& mesh, Side side, int flows,
                                 const CellData& conductivity) {
    if (mesh.chosen_stars().kind == StarKind::own && !mesh.stars()[flows].is_diagonal())
        throw InvalidInput(fmt::format("conductivities are given beside a star of {}-cells of your "
                                       "own that is a matrix, of which the cells' parts are not "
                                       "known: make the star of them (material_star)",
                                       flows),
                           {.degree = flows});
    const Vector kappa = conductivity.on(mesh, "conductivity", Range::positive);
    return with_material(
        mesh, flows,
        CellData::on_cells(side == Side::primal ? kappa : Vector(kappa.cwiseInverse())));
}

/// What connects the unknowns, and what is known of it.
struct Stiffness {
    SparseMatrix matrix;
    Definiteness definiteness;
};

/// star_1; 0 where that is no more than rounding, because such an edge connects nothing.
Vector edge_weights(const HodgeStar& star) {
    Vector weights = star.diagonal();
    for (const Index edge : star.zeros())
        weights[edge] = 0;
    return weights;
}

Stiffness by_weights(const CellComplex& complex, const Vector& weights) {
    return {connections(gram_of_columns(complex.incidences(0), weights)), by_sign(weights)};
}

/// d_0^T star_1 d_0.
Stiffness stiffness(const CellComplex& complex, const HodgeStars& stars) {
    if (stars[1].is_diagonal())
        return by_weights(complex, edge_weights(stars[1]));
    SparseMatrix A = symmetric_laplacian({complex, stars}, 0).matrix();
    A.prune(0.0);
    return {std::move(A), Definiteness::semidefinite};
}

PoissonOptions in_unit_of(const Cells& cells, PoissonOptions options) {
    for (double& coefficient : options.boundary.coefficients)
        coefficient *= cells.unit();
    return options;
}

} // namespace

/// The equations, and where their data are.
struct PoissonSolver::Problem {
    Side side = Side::primal;
    ConstrainedSystem system; // given with its type: g++ 12 destroys what stands in bare braces
                              // within others twice where a later member throws
    SparseMatrix mass = {};
    Vector facet_weights = {};
    SparseMatrix boundary_load = {}, boundary_fix = {}, flux_load = {};
    Points sites = {}, flux_sites = {};
    std::string engine = {};
    std::unique_ptr<MixedPoisson> mixed = nullptr; // in place of the system and of loads
    Vector robin = {};
    std::vector<std::string> warnings = {};
    double unit = 1;

    static Problem primal(const Cells& cells, const PoissonOptions& options) {
        const CellComplex& complex = cells.complex();
        const HodgeStars& stars = cells.stars();
        auto [matrix, definiteness] = stiffness(complex, stars);
        const int n = complex.dimension();
        const Index size = complex.size(0);
        const auto essential = essential_cells(complex, options.boundary, Side::primal, 0);
        const Vector natural = natural_facets(complex, essential);
        const Vector shares_of_domain = stars[0] * Vector::Ones(size).eval();
        SparseMatrix flux_load(size, natural.size());
        if (!natural.isZero(0))
            flux_load = cells.shares_of_vertices() * natural.asDiagonal();
        const Vector robin = robin_coefficients(complex, options.boundary);
        std::vector<bool> tied(size, false);
        if (!robin.isZero(0)) {
            const SparseMatrix weights = cells.boundary_star(0, robin);
            const Vector of_vertices = weights.diagonal();
            for (Index v = 0; v < size; ++v)
                tied[v] = of_vertices[v] > 0;
            matrix += weights;
        }
        SparseMatrix fix(size, size);
        fix.setIdentity();
        return {Side::primal,
                ConstrainedSystem{std::move(matrix), essential[0], std::move(tied),
                                  shares_of_domain.cwiseAbs(), definiteness, n},
                stars[0].matrix(),
                {},
                SparseMatrix(size, size),
                std::move(fix),
                std::move(flux_load),
                {},
                {},
                options.linear_solver};
    }

    static Problem dual(const Cells& cells, const PoissonOptions& options) {
        const CellComplex& complex = cells.complex();
        const HodgeStars& stars = cells.stars();
        const int n = complex.dimension();
        const auto essential = essential_cells(complex, options.boundary);
        const CellVolumes& volumes = stars.volumes();
        if (!stars[n - 1].is_diagonal())
            return mixed_dual(cells, options, essential[n - 1]);
        const Vector robin = robin_coefficients(complex, options.boundary);
        auto fluxes = dual_fluxes(cells, essential, robin);
        const Vector areas =
            (robin.array() > 0)
                .select(0, natural_facets(complex, essential).cwiseProduct(volumes.primal(n - 1)));
        return {
            Side::dual,
            ConstrainedSystem{connections(gram_of_rows(complex.incidences(n - 1), fluxes.weights)),
                              std::move(fluxes.fixed), std::move(fluxes.tied), volumes.primal(n),
                              by_sign(fluxes.weights), n},
            SparseMatrix(volumes.primal(n).asDiagonal()),
            fluxes.weights,
            std::move(fluxes.load),
            std::move(fluxes.fix),
            SparseMatrix(complex.boundary(n).transpose().cast<double>().cwiseAbs() *
                         areas.asDiagonal()) +
                fluxes.robin_load,
            {},
            {},
            options.linear_solver};
    }

    /// With fluxes as unknowns; flux_load are the areas through which they flow.
    static Problem mixed_dual(const Cells& cells, const PoissonOptions& options,
                              const std::vector<bool>& essential) {
        const CellComplex& complex = cells.complex();
        const HodgeStars& stars = cells.stars();
        const int n = complex.dimension();
        check_two_sided(cells);
        stars[n].require_diagonal();
        const CellVolumes& volumes = stars.volumes();
        const Vector robin = robin_coefficients(complex, options.boundary);
        std::vector<bool> open = essential;
        for (Index f = 0; f < robin.size(); ++f)
            open[f] = open[f] || robin[f] > 0;
        auto mixed =
            std::make_unique<MixedPoisson>(complex, stars, open, robin, options.linear_solver);
        return {.side = Side::dual,
                .system = ConstrainedSystem{.domain_dimension = n},
                .mass = SparseMatrix(volumes.primal(n).asDiagonal()),
                .flux_load = SparseMatrix(volumes.primal(n - 1).asDiagonal()),
                .mixed = std::move(mixed),
                .robin = robin};
    }

    /// Of options in the unit of the cells.
    static Problem on(const Cells& cells, const PoissonOptions& options) {
        Problem problem =
            options.side == Side::primal ? primal(cells, options) : dual(cells, options);
        problem.unit = cells.unit();
        problem.sites.resize(problem.mass.rows(), 0);
        problem.flux_sites.resize(cells.complex().size(cells.dimension() - 1), 0);
        return problem;
    }

    /// With places and warnings.
    static Problem of(const Discretization& mesh, const PoissonOptions& options) {
        const int flows = options.side == Side::primal ? 1 : mesh.dimension() - 1;
        if (!options.conductivity.is_empty()) {
            PoissonOptions others = options;
            others.conductivity = {};
            return of(with_conductivity(mesh, options.side, flows, options.conductivity), others);
        }
        Problem problem = on(mesh, options);
        problem.sites = options.side == Side::primal ? cell_centers(mesh, 0) : dual_sites(mesh);
        problem.flux_sites = facet_sites(mesh);
        constexpr const char* spoiled = "the solution may be far off there";
        problem.warnings =
            options.side == Side::primal
                ? warning_of_negative_duals(mesh, 0, spoiled)
                : warning_of_negative_duals(mesh, mesh.dimension() - 1,
                                            fmt::format("{}; compare with Side::primal", spoiled));
        return problem;
    }
};

PoissonSolver::PoissonSolver(const Discretization& mesh, const PoissonOptions& options)
    : PoissonSolver(Problem::of(mesh, in_unit_of(mesh, options))) {}

PoissonSolver::PoissonSolver(const Cells& cells, const PoissonOptions& options)
    : PoissonSolver(Problem::on(cells, in_unit_of(cells, options))) {
    if (!options.conductivity.is_empty())
        throw InvalidInput("conductivities are given for cells of one's own: how their duals are "
                           "divided among them is not known; give a mesh");
}

PoissonSolver::PoissonSolver(Problem problem)
    : side_(problem.side),
      degree_(problem.side == Side::primal ? 0 : problem.system.domain_dimension),
      sites_(std::move(problem.sites)),
      flux_sites_(std::move(problem.flux_sites)),
      mass_(std::move(problem.mass)),
      facet_weights_(std::move(problem.facet_weights)),
      boundary_load_(std::move(problem.boundary_load)),
      boundary_fix_(std::move(problem.boundary_fix)),
      fixed_load_(load_of_fixed(problem.system)),
      flux_load_(std::move(problem.flux_load)),
      robin_(std::move(problem.robin)),
      warnings_(std::move(problem.warnings)),
      unit_(problem.unit),
      mixed_(std::move(problem.mixed)) {
    if (!mixed_)
        solver_ = std::make_unique<ConstrainedSolver>(std::move(problem.system), problem.engine);
}

PoissonSolver::PoissonSolver(PoissonSolver&&) noexcept = default;
PoissonSolver::~PoissonSolver() = default;

void PoissonSolver::check(const DenseMatrix& f, const DenseMatrix& boundary_values,
                          const DenseMatrix& normal_derivatives) const {
    if (f.cols() != boundary_values.cols() || f.cols() != normal_derivatives.cols())
        throw InvalidInput(fmt::format("{} right-hand sides, boundary data for {} and normal "
                                       "derivatives for {} problems are given: expected as many",
                                       f.cols(), boundary_values.cols(),
                                       normal_derivatives.cols()));
    check_values(f, sites_, "right-hand side");
    check_values(boundary_values, boundary_sites(), "boundary data");
    check_values(normal_derivatives, flux_sites_, "normal derivatives");
}

Solution<Vector> PoissonSolver::solve(const Vector& f, const Vector& boundary_values) const {
    return solve(f, boundary_values, Vector::Zero(flux_sites_.rows()));
}

Solution<Vector> PoissonSolver::solve(const Vector& f, const Vector& boundary_values,
                                      const Vector& normal_derivatives) const {
    auto [u, report, compatibility, warnings] = solve_all(f, boundary_values, normal_derivatives);
    return {std::move(u), std::move(report), compatibility, std::move(warnings)};
}

Solution<DenseMatrix> PoissonSolver::solve_all(const DenseMatrix& f,
                                               const DenseMatrix& boundary_values) const {
    return solve_all(f, boundary_values,
                     DenseMatrix::Zero(flux_sites_.rows(), boundary_values.cols()));
}

Solution<DenseMatrix> PoissonSolver::solve_all(const DenseMatrix& f,
                                               const DenseMatrix& boundary_values,
                                               const DenseMatrix& normal_derivatives) const {
    check(f, boundary_values, normal_derivatives);
    if (unit_ == 1)
        return solve_in_unit(f, boundary_values, normal_derivatives);
    // derivatives of second and first order become those of the mesh's unit
    return solve_in_unit(in_unit(f, 2, "right-hand side"), boundary_values,
                         in_unit(normal_derivatives, 1, "normal derivatives"));
}

DenseMatrix PoissonSolver::in_unit(DenseMatrix values, int order, const char* what) const {
    for (auto column : values.colwise())
        column = in_input_units(Vector(column), unit_, order, what);
    return values;
}

Solution<DenseMatrix> PoissonSolver::solve_in_unit(const DenseMatrix& f,
                                                   const DenseMatrix& boundary_values,
                                                   const DenseMatrix& normal_derivatives) const {
    if (mixed_) {
        const DenseMatrix sources = mass_ * f, outflow = -(flux_load_ * normal_derivatives);
        DenseMatrix values = boundary_values;     // which data of Robin's condition over its
        for (Index i = 0; i < robin_.size(); ++i) // coefficient stand for
            if (robin_[i] > 0)
                values.row(i) = normal_derivatives.row(i) / robin_[i];
        auto all = by_columns(f, [&](Index j) {
            auto flow = mixed_->solve(sources.col(j), values.col(j), outflow.col(j));
            return Solution<Vector>{std::move(flow.values), std::move(flow.report),
                                    flow.compatibility};
        });
        all.warnings.insert(all.warnings.end(), warnings_.begin(), warnings_.end());
        return all;
    }
    const DenseMatrix load = boundary_load_ * boundary_values + flux_load_ * normal_derivatives;
    const DenseMatrix right_side = mass_ * f + load;
    const DenseMatrix fixed = boundary_fix_ * boundary_values;
    constexpr auto what = "the right-hand side of the system";
    check_loads(what, right_side, degree_);
    check_loads(what, right_side - fixed_load_ * fixed, degree_);
    auto all = solver_->solve_all(right_side, fixed);
    all.warnings.insert(all.warnings.end(), warnings_.begin(), warnings_.end());
    return all;
}

} // namespace polydec
