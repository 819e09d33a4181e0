// SPDX-License-Identifier: MIT
#include "tests/solvers/wave_problems.h"

#include "dec/fields/cell_centers.h"
#include "dec/operators.h"

#include <cmath>

namespace polydec::test {

namespace {

constexpr double coefficient = 1.7;

bool on_the_left(const Vector& site) {
    return site[0] < 1e-9;
}

} // namespace

/// Robin's condition opposite to essential facets.
BoundaryConditions conditions_of(const Discretization& mesh, Where where) {
    if (where == Where::essential)
        return {BoundaryCondition::essential};
    if (where == Where::natural)
        return {BoundaryCondition::natural};
    const auto mixed = essential_where(cell_centers(mesh, mesh.dimension() - 1), on_the_left);
    return where == Where::mixed ? mixed : robin_elsewhere(mixed, coefficient);
}

Cochain exact_form(const Discretization& mesh, Side side, const WaveForm& wave) {
    const int n = mesh.dimension();
    if (side == Side::primal || mesh.stars()[n - wave.degree()].is_diagonal())
        return wave.on(mesh, side);
    const double twice = wave.degree() * (n - wave.degree()) % 2 == 0 ? 1 : -1;
    return twice * star(mesh, de_rham(mesh, n - wave.degree(), wave.star()));
}

double size_of(const Discretization& mesh, const Cochain& form) {
    const int n = mesh.dimension(), k = form.side == Side::primal ? form.degree : n - form.degree;
    const HodgeStar star = mesh.stars()[k];
    if (!star.is_diagonal())
        return norm(mesh, form);
    const Vector weights = star.diagonal().cwiseAbs();
    const Vector inverse = (weights.array() > 1e-9).select(weights.cwiseInverse(), 0);
    return std::sqrt((form.side == Side::primal ? weights : inverse).dot(form.values.cwiseAbs2()));
}

BoundaryForms data_of(const Discretization& mesh, Side side, const WaveForm& wave, Where where) {
    BoundaryForms data = wave.boundary(mesh, side);
    if (where != Where::robin || data.derivative_flow.size() == 0)
        return data;
    data.derivative_flow += coefficient * wave.boundary_star(mesh, side);
    if (side == Side::dual && data.values.size() > 0)
        data.values = boundary_de_rham(mesh, wave.degree(), [=](const Vector& x) -> Vector {
            return (on_the_left(x) ? 1 : 0) * wave.form()(x);
        });
    return data;
}

} // namespace polydec::test
