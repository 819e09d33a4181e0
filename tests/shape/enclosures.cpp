// SPDX-License-Identifier: MIT
#include "tests/shape/known_shapes.h"

namespace polydec::test::in_enclosures {

const BoundaryConditions dirichlet{BoundaryCondition::essential};

/// An eigenvalue in closed form, and how far bounds of each degree may be from it: shares that were
/// measured with programs of their own, and 10 % more.
struct Row {
    std::string name;
    Shape shape;
    int degree;
    Index number;
    double truth, below, above;
};

void expect(const Row& row) {
    const auto found = shape_spectrum(row.shape, {.count = row.number + 1, .level = row.degree});
    const double lower = found.lower[row.number], upper = found.upper[row.number];
    const auto what = row.name + ", degree " + std::to_string(row.degree);
    EXPECT_LE(lower, row.truth * (1 + 1e-14)) << what;
    EXPECT_GE(upper, row.truth * (1 - 1e-14)) << what;
    EXPECT_GE(lower, row.truth * (1 - 1.1 * row.below)) << what;
    EXPECT_LE(upper, row.truth * (1 + 1.1 * row.above)) << what;
}

Shape of_two_materials(int n) {
    const auto mesh = discretize(kuhn(2, n), {.criterion = MergeCriterion::none});
    Shape shape = shape_of(mesh, {BoundaryCondition::natural});
    const Points centroids = cell_centroids(mesh, 2);
    const auto is_right = centroids.col(0).array() > 0.5;
    shape.conductivity = is_right.select(Vector::Constant(mesh.size(2), 10), 1.0);
    shape.density = is_right.select(Vector::Constant(mesh.size(2), 3), 1.0);
    return shape;
}

TEST(ShapeSpectrum, of_plane_domains_is_enclosed_as_closely_as_was_measured) {
    const double two = 2 * pi * pi;
    expect({"square", unmerged(kuhn(2, 8), dirichlet), 1, 0, two, 1.43e-2, 3.9e-2});
    expect({"square", unmerged(kuhn(2, 16), dirichlet), 2, 0, two, 1.9e-5, 1.43e-5});
    const BoundaryConditions robin{BoundaryCondition::robin, {}, {2.5}};
    const double mu = std::sqrt(interval_eigenvalues(1, 2.5, 2.5, 10)[0]);
    EXPECT_NEAR(2 * mu * mu, 6.9304646, 1e-7);
    expect({"Robin", unmerged(kuhn(2, 8), robin), 1, 0, 2 * mu * mu, 1.52e-3, 5.3e-3});
    expect({"Robin", unmerged(kuhn(2, 8), robin), 2, 0, 2 * mu * mu, 1.53e-5, 8e-6});
    // sin a cos b + 30^.5 sin b cos a = 0, a = l^.5 / 2, b = (.3 l)^.5 / 2
    const double materials = 11.628679752;
    expect({"materials", of_two_materials(8), 1, 1, materials, 1.3e-2, 2.2e-2});
    expect({"materials", of_two_materials(8), 2, 1, materials, 5e-5, 4.2e-5});
    expect({"L", unmerged(l_shape(8), dirichlet), 1, 0, 9.6397238440219, 2.3e-2, 2.9e-2});
    expect({"L", unmerged(l_shape(8), dirichlet), 2, 0, 9.6397238440219, 2.9e-3, 2.5e-3});
}

TEST(ShapeSpectrum, of_surfaces_is_enclosed_as_closely_as_was_measured) {
    const double tetrahedron = 4 * pi * pi / 3;
    for (const Index j : {1, 2, 3}) {
        expect(
            {"tetrahedron", unmerged(tetrahedron_surface(8)), 1, j, tetrahedron, 8.8e-3, 1.3e-2});
        expect(
            {"tetrahedron", unmerged(tetrahedron_surface(8)), 2, j, tetrahedron, 3.3e-5, 3.3e-5});
    }
    const auto cube = shape_spectrum(unmerged(cube_surface(8)), {.count = 4});
    for (const Index j : {1, 2, 3}) {
        EXPECT_LE(cube.lower[j], 4.1661180);
        EXPECT_GE(cube.upper[j], 4.1660445);
        EXPECT_LE(widths(cube)[j], 2.5e-4);
    }
    const double first[] = {2.62240, 2.15434, 2.03837}; // level 2 on finer meshes of these
    for (const int frequency : {1, 2, 4}) {
        const double truth = first[frequency / 2];
        for (const int degree : {1, 2}) {
            const auto sphere =
                shape_spectrum(unmerged(icosphere(frequency)), {.count = 4, .level = degree});
            EXPECT_LE(sphere.lower[3], truth * (1 + 1e-4));
            EXPECT_GE(sphere.upper[1], truth * (1 - 1e-4));
        }
    }
}

TEST(ShapeSpectrum, of_solids_is_enclosed) {
    expect({"cube", unmerged(kuhn(3, 4)), 1, 1, pi * pi, 5e-2, 5e-2});
    expect({"cube", unmerged(kuhn(3, 4)), 2, 1, pi * pi, 1e-3, 1e-3});
    expect({"cube", unmerged(kuhn(3, 4), dirichlet), 1, 0, 3 * pi * pi, 1.5e-1, 3e-1});
    expect({"cube", unmerged(kuhn(3, 4), dirichlet), 2, 0, 3 * pi * pi, 4e-2, 1e-2});
}

/// Neumann's and Dirichlet's eigenvalues of a square together: even and odd functions.
TEST(ShapeSpectrum, of_two_squares_glued_along_their_boundaries) {
    const auto found = shape_spectrum(unmerged(pillow(8)), {.count = 6});
    const double one = pi * pi;
    expect_enclosed(found, {0, one, one, 2 * one, 2 * one, 4 * one}, 1e-14);
    EXPECT_LE(widths(found).head(3).maxCoeff(), 1e-4);
}

TEST(ShapeSpectrum, of_many_pieces_has_all_zeros_at_any_count) {
    const Mesh one = kuhn(2, 2);
    Mesh four = one;
    for (const double shift : {2, 4, 6})
        four = united(four, transformed(one, DenseMatrix::Identity(2, 2), 1, shift));
    const Shape shape = unmerged(four);
    for (const int level : {1, 2})
        for (Index count = 1; count <= 6; ++count) {
            const auto found = shape_spectrum(shape, {.count = count, .level = level});
            ASSERT_EQ(found.upper.size(), count);
            ASSERT_EQ(found.lower.size(), count);
            EXPECT_EQ(found.modes.cols(), count);
            EXPECT_EQ(found.zeros, std::min<Index>(count, 4));
            expect_enclosed(found, {0, 0, 0, 0, pi * pi, pi * pi});
            EXPECT_TRUE(found.upper.head(std::min<Index>(count, 4)).isZero(0));
            EXPECT_EQ(found.edge_modes.cols(), level == 2 ? count : 0);
        }
}

TEST(ShapeSpectrum, encloses_every_eigenvalue_of_random_shapes) {
    std::mt19937 random(7);
    for (int i = 0; i < 40; ++i) {
        const KnownShape known = random_shape(random);
        for (const int degree : {1, 2}) {
            const auto found = shape_spectrum(known.shape, {.count = 4, .level = degree});
            SCOPED_TRACE(known.name + std::to_string(i));
            expect_enclosed(found, known.eigenvalues, 1e-12);
            const auto below = std::count_if(known.eigenvalues.begin(), known.eigenvalues.end(),
                                             [&](double l) { return l < found.count_at; });
            EXPECT_LE(found.count.at_least, below);
            EXPECT_GE(found.count.at_most.value_or(1000), below);
            EXPECT_EQ(found.zeros,
                      std::count(known.eigenvalues.begin(), known.eigenvalues.begin() + 4, 0.0));
        }
    }
}

/// Divided triangles are the same shape, whose eigenvalues lie in all of its enclosures.
TEST(ShapeSpectrum, of_a_mesh_and_of_its_refinements_meet) {
    for (const Mesh& coarse : {icosphere(1), cube_surface(2), grid(4, 3, 1.3, 0.7)}) {
        Mesh mesh = coarse;
        double least[2] = {1e300, 1e300}, most[2] = {0, 0};
        for (int step = 0; step < 4; ++step) {
            for (const int degree : {1, 2}) {
                const auto found = shape_spectrum(unmerged(mesh), {.count = 6, .level = degree});
                for (const int which : {0, 1}) {
                    const Index j = which == 0 ? 1 : 5;
                    most[which] = std::max(most[which], found.lower[j]);
                    least[which] = std::min(least[which], found.upper[j]);
                }
            }
            mesh = divided(mesh);
        }
        for (const int which : {0, 1})
            EXPECT_LE(most[which], least[which]);
    }
}

TEST(ShapeSpectrum, has_orders_2_and_4_on_a_square) {
    for (const int degree : {1, 2}) {
        std::vector<double> below, above;
        for (const int n : {8, 16, 32}) {
            const auto found =
                shape_spectrum(unmerged(kuhn(2, n), dirichlet), {.count = 1, .level = degree});
            below.push_back(2 * pi * pi - found.lower[0]);
            above.push_back(found.upper[0] - 2 * pi * pi);
        }
        for (const int step : {0, 1}) {
            EXPECT_NEAR(std::log2(below[step] / below[step + 1]), 2 * degree, 0.2);
            EXPECT_NEAR(std::log2(above[step] / above[step + 1]), 2 * degree, 0.2);
        }
    }
}

TEST(ShapeSpectrum, does_not_depend_on_units_and_numbers) {
    const Mesh mesh = perturbed(grid(6, 5, 1.3, 0.7), 0.2, 3);
    const auto one = shape_spectrum(unmerged(mesh, dirichlet), {.count = 5});
    const auto expect_same = [&](const Shape& shape, double factor) {
        const auto other = shape_spectrum(shape, {.count = 5});
        for (Index j = 0; j < 5; ++j) {
            const double share = 1e-3 * widths(one)[j];
            EXPECT_NEAR(other.lower[j] * factor, one.lower[j], share * one.lower[j]);
            EXPECT_NEAR(other.upper[j] * factor, one.upper[j], 1e-8 * one.upper[j]);
        }
    };
    for (const double scale : {1e-8, 0.3, 1e8}) {
        Mesh scaled = mesh;
        scaled.points *= scale;
        expect_same(unmerged(scaled, dirichlet), scale * scale);
    }
    expect_same(unmerged(shuffled(mesh, 5).mesh, dirichlet), 1);
}

TEST(ShapeSpectrum, has_modes_that_are_the_functions) {
    const Mesh mesh = kuhn(2, 6);
    const Shape shape = unmerged(mesh, dirichlet);
    const auto found = shape_spectrum(shape, {.count = 1});
    ASSERT_EQ(found.modes.rows(), mesh.points.rows());
    const double sign = found.modes.sum() > 0 ? 1 : -1;
    const auto exact = [](double x, double y) { return 2 * std::sin(pi * x) * std::sin(pi * y); };
    for (Index v = 0; v < mesh.points.rows(); ++v)
        EXPECT_NEAR(sign * found.modes(v, 0), exact(mesh.points(v, 0), mesh.points(v, 1)), 1e-2);
    const auto& edges = shape.pieces.simplices(1);
    for (Index e = 0; e < edges.rows(); ++e) {
        const Eigen::RowVectorXd p =
            (mesh.points.row(edges(e, 0)) + mesh.points.row(edges(e, 1))) / 2;
        EXPECT_NEAR(sign * found.edge_modes(e, 0), exact(p[0], p[1]), 1e-2);
    }
}

TEST(ShapeSpectrum, stays_as_close_as_rounding_lets_it_where_cells_are_many) {
    for (const int cells : {64, 128, 300}) {
        const auto found = shape_spectrum(unmerged(kuhn(1, cells), dirichlet), {.count = 4});
        EXPECT_LT(widths(found).maxCoeff(), 2e-4) << cells;
    }
}

TEST(ShapeSpectrum, is_there_however_small_robins_coefficient_is) {
    for (const double alpha : {1e-12, 1e-16, 1e-30, 1e-100})
        for (const int level : {1, 2}) {
            const BoundaryConditions robin{BoundaryCondition::robin, {}, {alpha}};
            const auto found =
                shape_spectrum(unmerged(kuhn(2, 6), robin), {.count = 2, .level = level});
            EXPECT_LE(found.lower[0], 4 * alpha);
            EXPECT_LT(found.upper[0], 1e-6);
            EXPECT_GT(found.lower[1], 0.9 * pi * pi);
        }
}

TEST(ShapeSpectrum, proves_with_few_factorizations) {
    const auto found = shape_spectrum(unmerged(cube_surface(8)), {.count = 9});
    EXPECT_LE(found.factorizations, 4 * 9);
    EXPECT_EQ(found.count.at_least, found.count.at_most);
}

} // namespace polydec::test::in_enclosures
