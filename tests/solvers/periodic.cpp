// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_periodic {

using std::numbers::pi;

PeriodicMesh periodic_box(int n, int cells) {
    return periodic(kuhn(n, cells), unit_translations(n, n));
}

TEST(PeriodicBox, is_a_torus_of_equal_cells) {
    for (int n = 1; n <= 3; ++n) {
        const int cells = 4;
        const auto mesh = circumcentric(periodic_box(n, cells).quotient);
        const auto betti = betti_numbers(mesh.complex());
        const auto boxes = static_cast<Index>(std::pow(cells, n));
        for (int k = 0; k <= n; ++k) {
            // merged cells are the boxes' faces, also those across the seams
            EXPECT_EQ(mesh.complex().size(k), boxes * binomial(n, k));
            EXPECT_EQ(betti[k], binomial(n, k));
            const Vector star = mesh.stars()[k].diagonal();
            EXPECT_NEAR(star.minCoeff(), std::pow(cells, 2 * k - n), 1e-12);
            EXPECT_NEAR(star.maxCoeff(), std::pow(cells, 2 * k - n), 1e-12);
        }
        EXPECT_TRUE(mesh.warnings().empty());
        const auto open = circumcentric(kuhn(n, cells));
        EXPECT_GT(open.stars()[0].diagonal().maxCoeff(),
                  open.stars()[0].diagonal().minCoeff() * 1.5);
    }
}

/// Of boxes, k-forms have the eigenvalues of the lattice, C(n,k) times each: 4 sin^2 / h^2.
TEST(PeriodicBox, has_the_eigenvalues_of_plane_waves) {
    for (int n = 1; n <= 3; ++n) {
        const int cells = n == 3 ? 6 : 12;
        const auto mesh = circumcentric(periodic_box(n, cells).quotient);
        const double first = 4 * std::pow(cells * std::sin(pi / cells), 2);
        EXPECT_NEAR(first, 4 * pi * pi, 0.1 * 4 * pi * pi);
        for (const Side side : {Side::primal, Side::dual})
            for (int k = 0; k <= n; ++k) {
                const Index zeros = binomial(n, k);
                const auto found = spectrum({mesh, side, k}, {.count = zeros + 2 * n * zeros});
                for (Index i = 0; i < found.eigenvalues.size(); ++i)
                    EXPECT_NEAR(found.eigenvalues[i], i < zeros ? 0 : first, 1e-8 * first);
            }
    }
}

/// A k-form of plane waves, Delta u = 4 pi^2 |m|^2 u; `turn` breaks its periods.
SmoothForm waves(int n, int k, double turn = 0) {
    return [=](const Vector& x) {
        Vector result(binomial(n, k));
        for (Index i = 0; i < result.size(); ++i)
            result[i] = std::sin(2 * pi * x.sum() + 0.4 * i + turn * x[0]);
        return result;
    };
}

double wave_error(const Mesh& box, int k, Side side, double turn = 0) {
    const int n = box.dimension();
    const auto glued = periodic(box, unit_translations(n, n));
    const auto mesh = circumcentric(glued);
    const PoissonSolver solver({mesh, side, k, {}});
    Cochain u = de_rham(mesh, side == Side::primal ? k : n - k,
                        waves(n, side == Side::primal ? k : n - k, turn));
    if (side == Side::dual)
        u = star(mesh, u);
    const auto solution = solver.solve(4 * pi * pi * n * u);
    return norm(mesh, solution.form - u) / norm(mesh, u);
}

TEST(PeriodicBox, has_solutions_of_every_degree_with_order_2) {
    for (int n = 1; n <= 3; ++n)
        for (int k = 0; k <= n; ++k)
            for (const Side side : {Side::primal, Side::dual}) {
                const int m = n == 3 ? 3 : 8;
                EXPECT_GE(std::log2(wave_error(kuhn(n, m), k, side) /
                                    wave_error(kuhn(n, 2 * m), k, side)),
                          1.7)
                    << n << k << name(side);
                EXPECT_GT(wave_error(kuhn(n, 2 * m), k, side, 1), 0.1);
            }
}

/// (x + 1, 1 - y) with (x, y + 1), and in space a half turn with each step up.
std::vector<Isometry> with_a_twist(int n) {
    std::vector<Isometry> result;
    for (int axis = n == 2 ? 1 : 0; axis < (n == 2 ? 2 : n - 1); ++axis)
        result.push_back([=](const Vector& x) -> Vector { return x + Vector::Unit(n, axis); });
    result.push_back([n](const Vector& x) -> Vector {
        Vector image = Vector::Ones(n) - x;
        const int along = n == 2 ? 0 : n - 1;
        image[along] = x[along] + 1;
        return image;
    });
    return result;
}

TEST(Glue, makes_a_klein_bottle_with_the_eigenvalues_of_its_lattice) {
    const int cells = 12;
    const auto bottle = circumcentric(glue(grid(cells, cells), with_a_twist(2)).quotient);
    EXPECT_EQ(bottle.complex().size(0), cells * cells);
    EXPECT_EQ(bottle.complex().size(1), 2 * cells * cells);
    EXPECT_EQ(betti_numbers(bottle.complex()), (std::vector<Index>{1, 1, 0}));
    // exp(i pi m x) goes with cosines of 2 pi k y for even m, with sines for odd
    const auto eigenvalue = [&](double m, double k) {
        const auto part = [&](double half) { return std::pow(2 * cells * std::sin(half), 2); };
        return part(pi * m / 2 / cells) + part(pi * k / cells);
    };
    std::vector<double> expected;
    for (int m = -4; m <= 4; ++m)
        for (int k = m % 2 == 0 ? 0 : 1; k <= 3; ++k)
            expected.push_back(eigenvalue(m, k));
    std::sort(expected.begin(), expected.end());
    const auto found = spectrum({bottle, Side::primal, 0}, {.count = 10});
    for (Index i = 0; i < 10; ++i)
        EXPECT_NEAR(found.eigenvalues[i], expected[i], 1e-8 * expected[3]) << i;
    const auto torus =
        spectrum({circumcentric(periodic_box(2, cells).quotient), Side::primal, 0}, {.count = 5});
    EXPECT_GT(std::abs(torus.eigenvalues[4] - expected[4]), 0.1) << "that of a torus";
}

TEST(Glue, makes_the_half_turn_space) {
    const int cells = 4;
    const auto space = circumcentric(glue(kuhn(3, cells), with_a_twist(3)).quotient);
    EXPECT_EQ(space.complex().size(0), cells * cells * cells);
    EXPECT_EQ(space.complex().size(3), cells * cells * cells);
    EXPECT_EQ(betti_numbers(space.complex()), (std::vector<Index>{1, 1, 1, 1}));
    for (int k = 0; k <= 3; ++k) {
        const auto found = spectrum({space, Side::primal, k}, {.count = 3});
        EXPECT_NEAR(found.eigenvalues[0], 0, 1e-9);
        EXPECT_GT(found.eigenvalues[1], 1);
    }
}

/// Regular triangles in a sixth of a plane, `rows` of them from `first` edges off the tip.
Mesh sixth(int first, int rows) {
    const int size = first + rows;
    const Mesh squares = grid(size, size, size, size);
    const SimplicialComplex wedge(
        without(squares, [=](const Vector& x) { return x[1] > x[0] || x[0] < first; }).simplices);
    const Mesh mesh{vertex_points(wedge, squares.points), wedge.simplices(2), {}};
    return transformed(mesh, DenseMatrix{{1, -0.5}, {0, std::sqrt(0.75)}});
}

TEST(Glue, makes_a_cone_of_a_wedge) {
    const Isometry turn = [](const Vector& x) -> Vector {
        return Vector{{x[0] / 2 - std::sqrt(0.75) * x[1], std::sqrt(0.75) * x[0] + x[1] / 2}};
    };
    const auto blunt = circumcentric(glue(sixth(3, 4), {turn}).quotient);
    EXPECT_EQ(betti_numbers(blunt.complex()), (std::vector<Index>{1, 1, 0}));
    EXPECT_EQ(blunt.complex().size(0), 3 + 4 + 5 + 6 + 7);
    // every vertex inside is a regular one
    const Vector star = blunt.stars()[0].diagonal();
    EXPECT_EQ(((star.array() - std::sqrt(0.75)).abs() < 1e-12).count(), 4 + 5 + 6);
    // around the tip itself there would be one triangle
    EXPECT_REFUSED(glue(sixth(0, 4), {turn}), "cell 0", "vertex twice");
}

TEST(PeriodicErrors, name_the_cell_or_the_translation) {
    EXPECT_REFUSED(periodic(grid(2, 2), unit_translations(2, 2)), "cell 4",
                   "same corners as another", "simplicial");
    EXPECT_REFUSED(periodic(grid(1, 3), {Vector{{1, 0}}}), "cell 0", "vertex twice", "simplicial");
    EXPECT_REFUSED(glue(grid(3, 3), {[](const Vector& x) -> Vector { return x.array() + 9; }}),
                   "isometry 0", "no vertex", "2 coordinates");
    EXPECT_REFUSED(glue(grid(3, 3), {[](const Vector& x) -> Vector { return 2 * x; }}),
                   "isometry 0", "edge", "vertices 0", "1", "0", "2");
    EXPECT_REFUSED(glue(grid(3, 3), {Isometry()}), "isometry 0", "empty", "function");
    // diagonals of the sides that do not fit to each other
    EXPECT_REFUSED(glue(kuhn(3, 3), {[](const Vector& x) -> Vector {
                            return Vector{{x[0] + 1, 1 - x[1], x[2]}};
                        }}),
                   "isometry 0", "edge", "no edge");
    EXPECT_REFUSED(periodic(grid(3, 3), {Vector{{2, 0}}}), "translation (2, 0)", "no vertex",
                   "2 coordinates");
}

} // namespace polydec::test::in_periodic
