// SPDX-License-Identifier: MIT
#include "solvers/mixed_poisson.h"

#include "base/errors.h"
#include "complex/relative.h"
#include "dec/forms/derivative.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

namespace {

std::vector<Index> facets_of_unknown_flux(const CellComplex& complex,
                                          const std::vector<bool>& essential) {
    const auto& counts = complex.coface_counts(complex.dimension() - 1);
    std::vector<Index> result;
    for (Index f = 0; f < complex.size(complex.dimension() - 1); ++f)
        if (counts[f] != 1 || essential[f])
            result.push_back(f);
    return result;
}

Vector outward_signs(const CellComplex& complex) {
    const int n = complex.dimension();
    Vector result = Vector::Zero(complex.size(n - 1));
    for (Index cell = 0; cell < complex.size(n); ++cell)
        for (const auto& [f, sign] : complex.incidences(n - 1)[cell])
            if (complex.coface_counts(n - 1)[f] == 1)
                result[f] = sign;
    return result;
}

SaddleSolver saddle_solver(const SparseMatrix& M, const SparseMatrix& divergence,
                           const std::vector<Index>& facets, const std::string& engine, int n) {
    const SparseMatrix P = inclusion(facets, static_cast<Index>(M.rows()));
    return {SparseMatrix(SparseMatrix(P.transpose()) * M * P), divergence * P, engine, n};
}

/// The star of fluxes with what resists them on facets of Robin's condition.
SparseMatrix with_layers(const HodgeStars& stars, const Vector& robin) {
    const int facets = stars.dimension() - 1;
    SparseMatrix M = stars[facets].matrix();
    for (Index f = 0; f < robin.size(); ++f)
        if (robin[f] > 0)
            M.coeffRef(f, f) += 1 / (robin[f] * stars.volumes().primal(facets)[f]);
    return M;
}

/// Cells are connected through facets of unknown flux, and tied by those of known values.
FreeComponents components(const CellComplex& complex, const HodgeStars& stars,
                          const std::vector<bool>& essential, const SparseMatrix& divergence,
                          const std::vector<Index>& facets) {
    const int n = complex.dimension();
    const SparseMatrix sides =
        SparseMatrix(divergence * inclusion(facets, complex.size(n - 1))).cwiseAbs();
    std::vector<bool> tied(complex.size(n), false);
    for (Index cell = 0; cell < complex.size(n); ++cell)
        for (const SignedFace& f : complex.incidences(n - 1)[cell])
            if (essential[f.face])
                tied[cell] = true;
    return {sides * SparseMatrix(sides.transpose()), std::vector<bool>(complex.size(n), false),
            std::move(tied), stars.volumes().primal(n)};
}

} // namespace

void check_loads(const char* what, const DenseMatrix& loads, int degree) {
    for (Index j = 0; j < loads.cols(); ++j)
        for (Index i = 0; i < loads.rows(); ++i)
            if (!std::isfinite(loads(i, j)))
                throw InvalidInput(
                    fmt::format("{} at {}-cell {} is {}: data times volumes leave the range of "
                                "numbers there; divide all data by a power of two, and multiply "
                                "the solution by it",
                                what, degree, i, loads(i, j)),
                    {.degree = degree, .cells = {i}});
}

MixedPoisson::MixedPoisson(const CellComplex& complex, const HodgeStars& stars,
                           const std::vector<bool>& essential, const Vector& robin,
                           const std::string& engine)
    : divergence_(derivative(complex, complex.dimension() - 1)),
      M_(with_layers(stars, robin)),
      outward_(outward_signs(complex)),
      essential_(essential),
      unknown_(facets_of_unknown_flux(complex, essential)),
      solver_(saddle_solver(M_, divergence_, unknown_, engine, complex.dimension())),
      components_(components(complex, stars, essential, divergence_, unknown_)) {}

MixedPoisson::Flow MixedPoisson::solve(const Vector& sources, const Vector& boundary_values,
                                       const Vector& outflow) const {
    Vector flux = outward_.cwiseProduct(outflow), given = Vector::Zero(outward_.size());
    flux(unknown_).setZero();
    for (Index f = 0; f < given.size(); ++f)
        if (essential_[f])
            given[f] = -outward_[f] * boundary_values[f];
    const int n = solver_.domain_dimension();
    const Vector drops = given - M_ * flux;
    Vector left = sources - divergence_ * flux;
    check_loads("the right-hand side of a flux", drops, n - 1);
    check_loads("the right-hand side of the balance", left, n);
    Vector terms(unknown_.size() + left.size());
    terms << Vector(given.cwiseAbs() + M_.cwiseAbs() * flux.cwiseAbs())(unknown_),
        sources.cwiseAbs() + divergence_.cwiseAbs() * flux.cwiseAbs();
    const Compatibility compatibility = components_.balance(left);
    auto [x, c, report] = solver_.solve(drops(unknown_), left, terms);
    flux(unknown_) = x;
    Vector values = -c;
    components_.remove_means(values);
    return {std::move(values), std::move(flux), std::move(report), compatibility};
}

} // namespace polydec
