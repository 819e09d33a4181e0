// SPDX-License-Identifier: MIT
#include "dec/discretization.h"
#include "meshes/generate.h"
#include "solvers/poisson.h"
#include "tests/support/circumcentric.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace polydec::test::in_poisson_orders {
namespace {

using std::numbers::pi;

/// A solution of Delta u = n frequency^2 u, a product of cosines.
struct Waves {
    double frequency, shift;

    Vector at(const Points& sites) const {
        return (frequency * sites.array() + shift).cos().rowwise().prod();
    }
};

/// Not symmetric, given on the boundary; and one whose normal derivative vanishes there.
constexpr Waves given{pi / 2, 0.3}, free{pi, 0.0};

/// `terms` is n, or else the right-hand side belongs to another solution.
double l2_error(const Discretization& mesh, Side side, BoundaryCondition condition, int terms) {
    const Waves& wave = condition == BoundaryCondition::essential ? given : free;
    PoissonSolver solver(mesh, {.side = side, .boundary = {condition}});
    const Vector exact = wave.at(solver.sites());
    const Vector u = solver
                         .solve(terms * wave.frequency * wave.frequency * exact,
                                wave.at(solver.boundary_sites()))
                         .values;
    const Vector& weights =
        side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(mesh.dimension());
    return std::sqrt(weights.dot((u - exact).cwiseAbs2()));
}

struct Family {
    std::string name;
    std::function<Mesh(int)> make;
    BoundaryCondition condition;
    int coarse, fine;
};

void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

/// Of primal and of dual functions.
std::array<double, 2> orders(const Family& family, int more_terms = 0) {
    std::array<double, 2> result{};
    for (const int cells : {family.coarse, family.fine}) {
        const auto mesh = circumcentric(family.make(cells));
        for (const Side side : {Side::primal, Side::dual}) {
            const double error =
                std::log(l2_error(mesh, side, family.condition, mesh.dimension() + more_terms));
            result[side == Side::primal ? 0 : 1] += cells == family.coarse ? error : -error;
        }
    }
    for (double& order : result)
        order /= std::log(static_cast<double>(family.fine) / family.coarse);
    return result;
}

class Orders : public testing::TestWithParam<Family> {};

TEST_P(Orders, are_two_on_both_sides) {
    for (const double order : orders(GetParam()))
        EXPECT_NEAR(order, 2.0, 0.1);
}

constexpr auto essential = BoundaryCondition::essential, natural = BoundaryCondition::natural;

Family kuhn3() {
    return {"kuhn3", [](int N) { return kuhn(3, N); }, essential, 8, 16};
}

TEST(OrdersBroken, are_not_two_for_another_right_hand_side) {
    for (const double order : orders(kuhn3(), 1))
        EXPECT_LT(std::abs(order), 1.0);
}

INSTANTIATE_TEST_SUITE_P(
    Lattices, Orders,
    testing::Values(kuhn3(), Family{"bcc", [](int N) { return bcc(N); }, essential, 8, 12},
                    Family{"fcc", [](int N) { return fcc(N); }, essential, 8, 12},
                    Family{"split_cubes",
                           [](int N) {
                               return split_boxes({N, N, N});
                           },
                           essential, 8, 16},
                    Family{"kuhn4", [](int N) { return kuhn(4, N); }, natural, 4, 8},
                    Family{"d4", [](int N) { return d4(N); }, natural, 3, 4},
                    Family{"kuhn5", [](int N) { return kuhn(5, N); }, natural, 3, 4}),
    [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace polydec::test::in_poisson_orders
