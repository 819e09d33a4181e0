// SPDX-License-Identifier: MIT
#include "solvers/stokes.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/conditioned_complex.h"
#include "dec/forms/derivative.h"
#include "solvers/saddle_solver.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

namespace {

const CellComplex& checked(const CellComplex& complex, const HodgeStars& stars,
                           const StokesOptions& options) {
    check_fit(complex, stars);
    const int n = complex.dimension();
    check_number("the dimension of a flow", n, 2, 1000);
    if (!(options.viscosity > 0) || !std::isfinite(options.viscosity))
        throw InvalidInput(fmt::format("a viscosity of {} is given: expected a finite one above 0",
                                       options.viscosity));
    check_positive_mass(stars[n - 2], Side::primal, n - 2);
    const auto inside =
        conditioned_complex(complex, stars, Side::primal, n - 1, {BoundaryCondition::essential});
    check_positive_mass(inside.stars[n - 1], Side::primal, n - 1);
    return complex;
}

std::vector<Index> facets_inside(const CellComplex& complex) {
    const int k = complex.dimension() - 1;
    std::vector<Index> result;
    for (Index f = 0; f < complex.size(k); ++f)
        if (complex.coface_counts(k)[f] != 1)
            result.push_back(f);
    return result;
}

SparseMatrix columns_of(const std::vector<Index>& columns, Index size) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (const Index column : columns)
        entries.emplace_back(column, static_cast<Index>(entries.size()), 1.0);
    SparseMatrix result(size, static_cast<Index>(columns.size()));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// Blocks of constraints on a flux: its turn, and its divergence.
SparseMatrix stacked(const SparseMatrix& above, const SparseMatrix& below) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (const auto* A : {&above, &below})
        for (Index row = 0; row < A->rows(); ++row)
            for (SparseMatrix::InnerIterator entry(*A, row); entry; ++entry)
                entries.emplace_back(row + (A == &below ? above.rows() : 0), entry.col(),
                                     entry.value());
    SparseMatrix result(above.rows() + below.rows(), above.cols());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// The matrix above, nothing below.
SparseMatrix padded(SparseMatrix A, Index more) {
    A.conservativeResize(A.rows() + more, A.cols() + more);
    return A;
}

/// Of u and (w, -p): nu d^T M_n d u + nu M d w - d^T p, which fixes the divergence twice, so that
/// the upper block is not empty; and the turn and the divergence of u.
std::unique_ptr<SaddleSolver>
saddle_solver_of(const HodgeStars& stars, const SparseMatrix& divergence, const SparseMatrix& turn,
                 const std::vector<Index>& inside, const StokesOptions& options) {
    const int n = stars.dimension();
    const double nu = options.viscosity;
    const SparseMatrix P = columns_of(inside, static_cast<Index>(divergence.cols()));
    const SparseMatrix d = divergence * P;
    return std::make_unique<SaddleSolver>(
        SparseMatrix(nu * SparseMatrix(d.transpose()) * stars[n].matrix() * d),
        stacked(nu * turn * P, d), padded(nu * stars[n - 2].matrix(), static_cast<Index>(d.rows())),
        options.linear_solver, n);
}

} // namespace

StokesSolver::StokesSolver(const Discretization& mesh, const StokesOptions& options)
    : StokesSolver(mesh.complex(), mesh.stars(), options) {}

StokesSolver::StokesSolver(const CellComplex& complex, const HodgeStars& stars,
                           const StokesOptions& options)
    : complex_(checked(complex, stars, options)),
      viscosity_(options.viscosity),
      inside_(facets_inside(complex)),
      divergence_(derivative(complex, complex.dimension() - 1)),
      turn_(SparseMatrix(derivative(complex, complex.dimension() - 2).transpose()) *
            stars[complex.dimension() - 1].matrix()),
      M_(stars[complex.dimension() - 1].matrix()),
      M_below_(stars[complex.dimension() - 2].matrix()),
      boundary_(dual_boundary_derivative(complex, 1)),
      volumes_(stars.volumes().primal(complex.dimension())),
      solver_(saddle_solver_of(stars, divergence_, turn_, inside_, options)) {}

StokesSolver::StokesSolver(StokesSolver&&) noexcept = default;
StokesSolver::~StokesSolver() = default;

StokesFlow StokesSolver::solve(const Cochain& force, const Vector& through,
                               const Vector& along) const {
    const int n = complex_.dimension();
    check(complex_, force);
    if (force.side != Side::primal || force.degree != n - 1)
        throw InvalidInput(fmt::format("a {} {}-form is given as a force: expected its flux, a "
                                       "primal {}-form",
                                       name(force.side), force.degree, n - 1));
    check_as_many("fluxes through facets", through.size(), M_.rows());
    Vector tangential = Vector::Zero(M_below_.rows());
    if (along.size() > 0) {
        check_as_many("tangential velocities", along.size(), tangential.size());
        tangential = along;
    }
    if (!through.allFinite() || !tangential.allFinite())
        throw InvalidInput("velocities on the boundary are not finite");
    Vector flux = through;
    flux(inside_).setZero();
    const Vector out = divergence_ * flux;
    if (std::abs(out.sum()) > 1e-10 * out.cwiseAbs().sum())
        throw InvalidInput(fmt::format("what flows through the boundary adds up to {}: expected "
                                       "as much to flow in as out",
                                       out.sum()));

    const Vector b =
        M_ * force.values - viscosity_ * (divergence_.transpose() * out.cwiseQuotient(volumes_));
    const double sign = n % 2 == 0 ? 1 : -1; // of star u in the derivative of degree n-2
    Vector g(turn_.rows() + out.size());
    g << -viscosity_ * (turn_ * flux - sign * (boundary_ * tangential)), -out;
    auto [u, c, report] = solver_->solve(b(inside_), g);

    flux(inside_) = u;
    Vector pressure = -c.tail(out.size());
    pressure.array() -= pressure.dot(volumes_) / volumes_.sum();
    return {{Side::primal, n - 1, std::move(flux)},
            {Side::primal, n - 2, c.head(turn_.rows())},
            {Side::dual, 0, std::move(pressure)},
            std::move(report)};
}

} // namespace polydec
