// SPDX-License-Identifier: MIT
#include "solvers/sources/poisson.h"

#include "backends/linear/auto_solver.h"
#include "base/errors.h"
#include "dec/boundary/two_sided.h"
#include "dec/discretization/advice.h"
#include "dec/forms/input_units.h"
#include "meshes/unit_of_length.h"
#include "solvers/sources/poisson_system.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

bool is_alone(const FormSpace& space) {
    const HodgeStars& stars = space.cells().stars();
    const int n = stars.dimension();
    return space.cell_degree() == 0 ||
           (space.cell_degree() == n && stars[n].is_diagonal() && stars[n - 1].is_diagonal() &&
            is_two_sided(space.cells().complex()));
}

/// Warnings about negative entries of the star of fluxes, where stars may have any sign.
std::vector<std::string> warnings_of(const FormSpace& space) {
    if (!is_alone(space))
        return {};
    const int n = space.cells().dimension();
    const bool is_of_values = space.cell_degree() == 0;
    return warning_of_negative_duals(space.cells(), is_of_values ? std::min(1, n) : n - 1,
                                     fmt::format("the solution may be far off there{}; use {}",
                                                 is_of_values ? "" : "; compare with Side::primal",
                                                 positive_stars(n)));
}

std::unique_ptr<const PoissonSystem> system_of(const FormSpace& space, const std::string& engine) {
    const Cells cells = space.cells();
    const int n = cells.dimension(), k = space.cell_degree();
    if (k == 0)
        return system_of_values(space, engine);
    if (space.side() == Side::dual && k == n)
        check_two_sided(cells);
    if (is_alone(space))
        return system_of_densities(space, engine);
    if (k == n && cells.stars()[n].is_diagonal() && is_two_sided(cells.complex()))
        return system_of_fluxes(space, engine);
    return system_of_forms(space, engine);
}

} // namespace

PoissonSolver::PoissonSolver(const FormSpace& space, const std::string& linear_solver)
    : space_(space), system_(system_of(space, linear_solver)), warnings_(warnings_of(space)) {}

PoissonSolution PoissonSolver::solve(const Cochain& f, const BoundaryForms& data,
                                     const Vector& harmonic) const {
    space_.check(f);
    const Side side = space_.side();
    const int n = space_.cells().dimension(), k = space_.cell_degree(), degree = space_.degree();
    const double unit = space_.cells().unit();
    auto [form, flux, removed, report, compatibility] = system_->solve(
        in_input_units(f.values, unit, 2, "source"), in_unit(data, unit, n, degree),
        form_in_input_units(harmonic, unit, degree - n / 2.0, "coefficients of harmonic forms"));
    // exponents relative to u, whose values are equal in both units
    const int power = side == Side::primal ? -2 : 2 * k - n - 2;
    PoissonSolution solution{{side, degree, std::move(form)},
                             {Side::primal, k - 1, {}},
                             {side, degree, in_input_units(removed, unit, -2, "removed part")},
                             std::move(report),
                             compatibility,
                             warning_of(compatibility)};
    solution.warnings.insert(solution.warnings.end(), warnings_.begin(), warnings_.end());
    try {
        solution.flux.values = form_in_input_units(flux, unit, power, "fluxes");
    } catch (const InvalidInput& beyond) { // u may be in range although its flux is not
        solution.warnings.emplace_back(beyond.what());
    }
    if (auto missed = take_missed_engines(); !missed.empty())
        solution.warnings.push_back(std::move(missed));
    return solution;
}

DenseMatrix PoissonSolver::harmonic_forms() const {
    const Cells& cells = space_.cells();
    return in_input_units(system_->harmonic_forms(), cells.unit(),
                          space_.degree() - cells.dimension() / 2.0, "harmonic forms");
}

CurlCurlSolution solve_curl_curl(const PoissonSolver& solver, const Cochain& j,
                                 const BoundaryForms& data) {
    if (j.side != Side::primal)
        throw InvalidInput("the source of curl curl is a dual form: expected a primal form");
    const auto first = solver.solve(j, data);
    Cochain exact{Side::primal, j.degree, Vector::Zero(j.values.size())};
    if (j.degree > 0)
        exact.values = d(solver.space().cells().complex(), first.flux).values;
    auto second = solver.solve(j - exact, data);
    return {std::move(second.form), exact + first.removed, std::move(second.report)};
}

} // namespace polydec
