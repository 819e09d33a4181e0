// SPDX-License-Identifier: MIT
#include "distributed/poisson.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"
#include "complex/relative.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/simplex_metric.h"
#include "dec/stars/star.h"
#include "distributed/petsc_calls.h"
#include "distributed/piece_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

namespace {

/// Own (n-1)-cells, and what is known at those on the boundary.
struct OwnFacets {
    OwnFacets(const DistributedMesh& mesh, const BoundaryConditions& conditions)
        : cells(mesh.cells.degree(mesh.dimension() - 1)),
          essential(Vector::Zero(std::ssize(cells.first))),
          natural(essential) {
        const auto& counts = mesh.local.complex.coface_counts(mesh.dimension() - 1);
        if (!conditions.facets.empty() && conditions.facets.size() != cells.first.size())
            throw InvalidInput(fmt::format("{} boundary conditions are given: expected one for "
                                           "each of the {} own {}-cells, or one for all",
                                           conditions.facets.size(), cells.first.size(),
                                           mesh.dimension() - 1));
        for (const Index piece : cells.first)
            coface_counts.push_back(counts[piece]);
        for (Index f = 0; f < essential.size(); ++f)
            if (coface_counts[f] == 1 && conditions.at(f) == BoundaryCondition::robin)
                throw InvalidInput(
                    "a facet has a Robin condition, which the Poisson problem over several ranks "
                    "does not support: use PoissonSolver in one process");
            else if (coface_counts[f] == 1)
                (conditions.at(f) == BoundaryCondition::essential ? essential : natural)[f] = 1;
    }

    const DistributedCells::Degree& cells;
    std::vector<Index> coface_counts;
    Vector essential, natural; // 1 or 0
};

Vector at_pieces(const Ranks& ranks, const DistributedCells::Degree& cells, const Vector& values) {
    return spread_to_pieces(ranks, cells, Points(values)).col(0);
}

Definiteness by_sign(const Ranks& ranks, const Vector& weights) {
    return ranks.any((weights.array() < 0).any()) ? Definiteness::indefinite
                                                  : Definiteness::semidefinite;
}

/// star_1; 0 where that is no more than rounding, because such an edge connects nothing.
Vector edge_weights(const CellVolumes& volumes) {
    const HodgeStar star(volumes, 1);
    Vector weights = star.diagonal();
    for (const Index edge : star.zeros())
        weights[edge] = 0;
    return weights;
}

/// Throws where dual 0-forms are no functions, or what flows through a facet is not defined.
void check_fluxes(const DistributedMesh& mesh, const OwnFacets& facets) {
    check_not_branching(mesh);
    const auto& cells = facets.cells;
    const auto zeros = HodgeStar(mesh.cells.volumes, mesh.dimension() - 1).zeros();
    for (Index f = 0; f < facets.essential.size(); ++f) {
        double sum = 0;
        for (Index e = cells.begins[f]; e < cells.begins[f + 1]; ++e)
            sum += cells.signs[e];
        if (facets.coface_counts[f] == 2 && sum != 0)
            throw InvalidInput(fmt::format("the mesh is non-orientable, so dual 0-forms change "
                                           "sign around it, at {}: use primal 0-forms",
                                           facet_name(mesh, f)));
        if (facets.coface_counts[f] == 2 && std::binary_search(zeros.begin(), zeros.end(), f))
            throw InvalidInput(fmt::format("the dual of {} has no length, so the flux through it "
                                           "is not defined: merge cospherical cells",
                                           facet_name(mesh, f)));
    }
}

} // namespace

Points cell_centers(const Ranks& ranks, const DistributedMesh& mesh, int k) {
    check_number("cells of degree", k, 0, mesh.dimension());
    const LocalComplex& local = mesh.local;
    const auto N = mesh.places.cols();
    Points weighted(local.complex.size(k), N + 1);
    ranks.together("centers", [&] {
        const Vector& volumes = mesh.merged.of_pieces.primal(k);
        weighted.leftCols(N) =
            volumes.asDiagonal() *
            combinations(local.complex, k,
                         center_coordinates(local.complex, local.points, mesh.merged.centers, k),
                         mesh.places);
        weighted.col(N) = volumes;
    });
    const Points sums = add_pieces(ranks, local, mesh.cells.degree(k), k, weighted);
    return sums.col(N).cwiseInverse().asDiagonal() * sums.leftCols(N);
}

struct SharedPoissonSolver::Problem {
    Problem(const Ranks& ranks, const DistributedMesh& mesh, const SharedPoissonOptions& options) {
        check_stars(ranks, mesh);
        const OwnFacets facets =
            ranks.together("conditions", [&] { return OwnFacets(mesh, options.boundary); });
        own_facets = facets.essential.size();
        options.side == Side::primal ? set_primal(ranks, mesh, facets)
                                     : set_dual(ranks, mesh, facets);
        own_values = options.side == Side::primal ? mass.size() : own_facets;
    }

    void set_primal(const Ranks& ranks, const DistributedMesh& mesh, const OwnFacets& facets);
    void set_dual(const Ranks& ranks, const DistributedMesh& mesh, const OwnFacets& facets);

    Eigen::Index own_facets = 0, own_values = 0; // the latter: at the boundary
    SharedSystem system = {};
    Vector mass = {}; // of own unknowns
    /// Boundary data to right-hand side, and boundary values to fixed unknowns.
    std::function<Vector(const Vector& boundary_values, const Vector& flows)> load = {};
    std::function<Vector(const Vector& boundary_values)> fixed = {};
};

void SharedPoissonSolver::Problem::set_primal(const Ranks& ranks, const DistributedMesh& mesh,
                                              const OwnFacets& facets) {
    const int n = mesh.dimension();
    const auto& vertices = mesh.cells.degree(0);
    const Vector weights =
        ranks.together("weights", [&] { return edge_weights(mesh.cells.volumes); });

    Points marks(facets.essential.size(), 2);
    marks << facets.essential, facets.natural;
    const Points at = spread_to_pieces(ranks, facets.cells, marks);
    HeldUnknowns held{std::vector<bool>(vertices.first.size(), false),
                      std::vector<bool>(vertices.first.size(), false)};
    for (Index f = 0; f < at.rows(); ++f)
        for (const Index v : mesh.local.complex.simplices(n - 1).row(f))
            if (at(f, 0) > 0 && mesh.local.owns(ranks, 0, v))
                held.fixed[vertices.of_simplex[v]] = true;

    // what own vertices get of the pieces of facets
    SparseMatrix shares(std::ssize(vertices.first), at.rows());
    if (ranks.any((at.col(1).array() > 0).any()))
        shares = ranks.together("shares of facets", [&] {
            const SparseMatrix all =
                dual_parts({mesh.local.complex, mesh.local.points, mesh.merged.of_pieces},
                           mesh.merged.centers, 0, n - 1);
            const SparseMatrix own = inclusion(vertices.first, mesh.local.complex.size(0));
            return SparseMatrix(SparseMatrix(own.transpose()) * SparseMatrix(all.transpose()));
        });
    load = [ranks, shares, natural = facets.natural,
            &cells = facets.cells](const Vector&, const Vector& flows) -> Vector {
        return shares * at_pieces(ranks, cells, natural.cwiseProduct(flows));
    };
    fixed = [](const Vector& boundary_values) { return boundary_values; };
    mass = HodgeStar(mesh.cells.volumes, 0).diagonal();
    system = {gram_of_columns(ranks, mesh.cells, 0, weights), std::move(held), mass,
              by_sign(ranks, weights)};
}

void SharedPoissonSolver::Problem::set_dual(const Ranks& ranks, const DistributedMesh& mesh,
                                            const OwnFacets& facets) {
    const int n = mesh.dimension();
    ranks.together("fluxes", [&] { check_fluxes(mesh, facets); });
    const CellVolumes& volumes = mesh.cells.volumes;
    const auto size = static_cast<Index>(facets.essential.size());
    const auto missing = marks_at(HodgeStar(volumes, n - 1).zeros(), size);

    // of a facet on the boundary, the derivative has its one coface with this sign
    Vector signs = Vector::Zero(size), weights = signs, fixing = signs;
    for (Index f = 0; f < size; ++f) {
        const bool interior = facets.coface_counts[f] == 2;
        if (facets.coface_counts[f] == 1)
            signs[f] = facets.cells.signs[facets.cells.begins[f]];
        if (!interior && facets.essential[f] == 0)
            continue; // what flows through the natural boundary is given
        if (missing[f])
            fixing[f] = signs[f];
        else if (!interior || facets.cells.begins[f] < facets.cells.begins[f + 1])
            weights[f] = volumes.primal(n - 1)[f] / volumes.dual(n - 1)[f];
    }
    const std::shared_ptr<_p_Mat> to_cells(coboundary(ranks, mesh.cells, n - 1).release(),
                                           PetscDestroy());
    const Vector conducting = signs.cwiseProduct(weights),
                 outflow = signs.cwiseProduct(facets.natural).cwiseProduct(volumes.primal(n - 1));
    const Vector fixed_by = product(ranks, to_cells.get(), fixing);
    const Vector tied_by =
        product(ranks, to_cells.get(), signs.array() * (conducting.array() != 0).cast<double>());
    HeldUnknowns held;
    for (Index c = 0; c < fixed_by.size(); ++c) {
        held.fixed.push_back(fixed_by[c] > 0);
        held.tied.push_back(tied_by[c] > 0);
    }
    load = [=](const Vector& values, const Vector& flows) -> Vector {
        return product(ranks, to_cells.get(),
                       conducting.cwiseProduct(values) + outflow.cwiseProduct(flows));
    };
    fixed = [=](const Vector& values) -> Vector {
        return product(ranks, to_cells.get(), fixing.cwiseProduct(values))
            .cwiseQuotient(fixed_by.cwiseMax(1));
    };
    mass = volumes.primal(n);
    system = {gram_of_rows(ranks, mesh.cells, n - 1, weights), std::move(held), mass,
              by_sign(ranks, weights)};
}

SharedPoissonSolver::SharedPoissonSolver(const Ranks& ranks, const DistributedMesh& mesh,
                                         const SharedPoissonOptions& options)
    : ranks_(ranks),
      problem_(std::make_shared<Problem>(ranks, mesh, options)),
      solver_(ranks, std::move(problem_->system), options.engine) {}

Solution SharedPoissonSolver::solve(const Vector& f, const Vector& boundary_values,
                                    const Vector& normal_derivatives) const {
    const Problem& of = *problem_;
    const auto given = [](const char* what, const Vector& values, Eigen::Index size) {
        if (values.size() > 0)
            check_values(what, values, size);
        return values.size() > 0 ? values : Vector(Vector::Zero(size));
    };
    Vector values, derivatives;
    ranks_.together("data", [&] {
        check_values("right-hand side", f, of.mass.size());
        values = given("boundary data", boundary_values, of.own_values);
        derivatives = given("normal derivatives", normal_derivatives, of.own_facets);
    });
    return solver_.solve(of.mass.cwiseProduct(f) + of.load(values, derivatives), of.fixed(values));
}

} // namespace polydec
