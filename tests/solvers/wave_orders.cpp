// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_wave_orders {

constexpr double pi = std::numbers::pi;
constexpr double omega = 2, end = 1;

/// Of a form E_0 cos(omega t) with delta d E_0 = lambda E_0, in a conducting medium with sources.
struct Manufactured {
    int degree;
    BoundaryCondition condition;
    double lambda;
    SmoothForm form;
};

Manufactured clamped(int n) {
    return {0, BoundaryCondition::essential, n * pi * pi,
            function_form([](const Vector& x) { return (pi * x.array()).sin().prod(); })};
}

Manufactured free_membrane(int n) {
    return {0, BoundaryCondition::natural, n * pi * pi,
            function_form([](const Vector& x) { return (pi * x.array()).cos().prod(); })};
}

/// Along the last axis, constant along it; for perfect conductors. In the plane along x.
Manufactured electric(int n) {
    return {1, BoundaryCondition::essential, (n - 1) * pi * pi,
            circulation_form([n](const Vector& x) -> Vector {
                return (pi * x.head(n - 1).array()).sin().prod() * Vector::Unit(n, n - 1);
            })};
}

/// In the first two directions around the middle, so that its flux is 0 at the walls.
Manufactured between_magnetic_walls(int n) {
    return {1, BoundaryCondition::natural, 2 * pi * pi,
            circulation_form([n](const Vector& x) -> Vector {
                return std::sin(pi * x[0]) * std::cos(pi * x[1]) * Vector::Unit(n, 0) -
                       std::cos(pi * x[0]) * std::sin(pi * x[1]) * Vector::Unit(n, 1);
            })};
}

/// The largest error of E over time, of its largest size; speed is that which the sources are for,
/// squared.
double error(const Discretization& mesh, const Manufactured& exact, Side side, double speed) {
    const int n = mesh.dimension(), degree = exact.degree;
    const int e = side == Side::primal ? degree : n - degree;
    const FormSpace space(mesh, side, degree, {exact.condition});
    const HodgeStar star = space.inside().stars()[e];
    const auto norm = [&](const Vector& values) {
        const Vector kept = space.restrict(values);
        return std::sqrt(kept.dot(side == Side::primal ? star * kept : star.solve(kept)));
    };

    const double limit = stable_step(space);
    const int steps = static_cast<int>(std::ceil(end / (0.5 * limit)));
    const double dt = end / steps;
    const double sigma = side == Side::primal || star.is_diagonal() ? 0.7 : 0;
    const Vector E0 = side == Side::primal ? de_rham(mesh, degree, exact.form).values
                                           : dual_de_rham(mesh, degree, exact.form).values;
    WaveOptions options{.time_step = dt};
    if (sigma > 0)
        options.loss = Vector::Constant(E0.size(), sigma);
    // dB/dt = -d E_0 cos(omega t), so that B = -d E_0 sin(omega t) / omega
    options.B = std::sin(omega * dt / 2) / omega * d(mesh.complex(), {side, degree, E0}).values;
    options.source = [&](double t) -> Vector {
        return ((speed * exact.lambda / omega - omega) * std::sin(omega * t) +
                sigma * std::cos(omega * t)) *
               E0;
    };
    Waves waves(space, E0, options);
    double worst = 0;
    waves.march(end, [&](double t) {
        worst = std::max(worst, norm(waves.form(0).values - std::cos(omega * t) * E0));
    });
    return worst / norm(E0);
}

/// With circumcentric stars if waves of this kind can be had with them, else with those that are
/// positive on every mesh.
double wave_order(const Case& cells, const Manufactured& exact, Side side, double speed = 1) {
    const auto order_by = [&](StarKind star) {
        return order({cells.pattern, cells.coarse, cells.fine, star},
                     [&](const auto& mesh) { return error(mesh, exact, side, speed); });
    };
    try {
        return order_by(StarKind::circumcentric);
    } catch (const InvalidInput&) {
        return order_by(StarKind::automatic);
    }
}

/// The least order of one form, near 2 unless told: the error is the difference from the integrals
/// of the exact form, and for degrees 1 .. n-1 near a boundary where cells are cut irregularly the
/// fluxes of circumcentric stars are of lower order.
struct Expected {
    Manufactured exact;
    double primal = 1.9, dual = 1.9;
};

struct Row : Case {
    std::vector<Expected> forms;
};

class WaveOrders : public testing::TestWithParam<Row> {};

TEST_P(WaveOrders, are_2_with_both_conditions_on_both_sides) {
    for (const auto& [exact, primal, dual] : GetParam().forms) {
        EXPECT_GT(wave_order(GetParam(), exact, Side::primal), primal) << exact.degree;
        EXPECT_GT(wave_order(GetParam(), exact, Side::dual), dual) << exact.degree;
    }
}

std::vector<Expected> all(int n) {
    return {{clamped(n)}, {free_membrane(n)}, {electric(n)}, {between_magnetic_walls(n)}};
}

INSTANTIATE_TEST_SUITE_P(Grids, WaveOrders,
                         testing::Values(Row{{"squares"}, all(2)}, Row{{"hexagons"}, all(2)},
                                         Row{{"triangles", 12, 24},
                                             {{clamped(2), 1.9, 1.8},
                                              {free_membrane(2)},
                                              {electric(2), 1.9, 1.45},
                                              {between_magnetic_walls(2), 1.45, 1.45}}},
                                         Row{{"cubes", 4, 8}, all(3)},
                                         Row{{"fcc", 3, 6},
                                             {{clamped(3)}, {free_membrane(3)}, {electric(3)}}},
                                         Row{{"bcc", 3, 6},
                                             {{clamped(3)},
                                              {free_membrane(3)},
                                              {electric(3), 1.9, 1},
                                              {between_magnetic_walls(3), 1.9, 1}}}),
                         name_of<Row>);

TEST(WaveOrdersBroken, are_not_2_for_sources_of_another_speed) {
    EXPECT_LT(wave_order({"squares"}, clamped(2), Side::primal, 1.05), 0.5);
}

} // namespace polydec::test::in_wave_orders
