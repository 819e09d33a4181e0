// SPDX-License-Identifier: MIT
#include "complex/surfaces/ordered_surface.h"
#include "shape/measured_simplex.h"
#include "tests/shape/known_shapes.h"

namespace polydec::test::in_refinement {

std::vector<Index> some(std::mt19937& random, Index size) {
    std::vector<Index> chosen;
    for (Index t = 0; t < size; ++t)
        if (random() % 3 == 0)
            chosen.push_back(t);
    return chosen;
}

/// Eigenvalues are those of the shape, so the parts enclose them as well: also with conditions,
/// weights and branching edges.
TEST(Bisection, changes_the_mesh_and_not_the_shape) {
    std::mt19937 random(11);
    for (int i = 0; i < 30; ++i) {
        KnownShape known = random_shape(random);
        const int n = known.shape.pieces.dimension();
        const Index zeros = zero_eigenvalues(known.shape);
        for (int step = 0; step < (n == 2 ? 2 : 1); ++step)
            known.shape = bisected(known.shape, some(random, known.shape.pieces.size(n)));
        EXPECT_EQ(zero_eigenvalues(known.shape), zeros);
        SCOPED_TRACE(known.name + std::to_string(i));
        expect_enclosed(shape_spectrum(known.shape, {.count = 4}), known.eigenvalues, 1e-12);
    }
}

std::vector<Index> all(const Shape& shape) {
    std::vector<Index> numbers(shape.pieces.size(shape.pieces.dimension()));
    std::iota(numbers.begin(), numbers.end(), Index{0});
    return numbers;
}

double volume(const Shape& shape) {
    long double sum = 0;
    for (const Index s : all(shape))
        sum += measured_simplex(shape, s).volume;
    return static_cast<double>(sum);
}

/// n! volume / h^n of the worst simplex.
double quality(const Shape& shape) {
    const int n = shape.pieces.dimension();
    double least = 1;
    for (const Index s : all(shape)) {
        const auto simplex = measured_simplex(shape, s);
        const double whole = std::tgamma(n + 1) * double(simplex.volume);
        least = std::min(least, whole / std::pow(simplex.longest_square, n / 2.0));
    }
    return least;
}

/// The tetrahedra, or n-simplices, of one cube of Kuhn's mesh with opposite sides glued: a flat
/// torus with one vertex. A k-simplex is a list of k disjoint sets of steps.
Shape torus_of_one_cube(int n) {
    using Steps = std::vector<unsigned>;
    std::vector<std::map<Steps, Index>> numbers(n + 1);
    const auto add = [&](const auto& self, const Steps& steps, unsigned rest) -> void {
        auto& known = numbers[steps.size()];
        known.emplace(steps, Index(known.size()));
        for (unsigned next = 1; next < 1u << n; ++next)
            if ((next & rest) == next) {
                Steps longer = steps;
                longer.push_back(next);
                self(self, longer, rest & ~next);
            }
    };
    add(add, {}, (1u << n) - 1);
    std::vector<Simplices> faces;
    for (int k = 1; k <= n; ++k) {
        Simplices& table = faces.emplace_back(Index(numbers[k].size()), k + 1);
        for (const auto& [steps, s] : numbers[k])
            for (int i = 0; i <= k; ++i) {
                Steps face = steps;
                if (i > 0 && i < k)
                    face[i] |= face[i - 1];
                face.erase(face.begin() + std::max(i - 1, 0));
                table(s, i) = numbers[k - 1].at(face);
            }
    }
    std::vector<std::int8_t> orientations(faces.back().rows());
    for (const auto& [steps, s] : numbers[n]) {
        int inversions = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < i; ++j)
                inversions += steps[j] > steps[i] ? 1 : 0;
        orientations[s] = inversions % 2 == 0 ? 1 : -1;
    }
    Vector lengths(faces.front().rows());
    for (const auto& [steps, e] : numbers[1])
        lengths[e] = std::sqrt(std::popcount(steps.front()));
    return {Pieces(faces, orientations, {0}), lengths};
}

/// A regular tetrahedron, two pairs of whose sides are glued so that four edges are one: a sphere.
Shape folded_tetrahedron() {
    Simplices edges(3, 2), triangles(2, 3), tetrahedron(1, 4);
    edges << 0, 0, 1, 1, 1, 0;
    triangles << 1, 2, 2, 2, 2, 0;
    tetrahedron << 0, 0, 1, 1;
    return {Pieces({edges, triangles, tetrahedron}, {1}, {0, 1}), Vector::Ones(3)};
}

TEST(Bisection, of_solids_keeps_volume_topology_and_shape) {
    struct Case {
        Shape shape;
        int rounds;
        double least; ///< share of the quality
    };
    std::mt19937 random(3);
    const Shape box = random_box(random, {2, 1, 1}).shape;
    for (auto& [shape, rounds, least] : std::vector<Case>{{unmerged(kuhn(1, 3)), 6, 1},
                                                          {unmerged(kuhn(3, 1)), 6, 0.7},
                                                          {box, 6, 0.25},
                                                          {unmerged(kuhn(4, 1)), 1, 0.7},
                                                          {torus_of_one_cube(2), 6, 0.99},
                                                          {torus_of_one_cube(3), 4, 0.7},
                                                          {torus_of_one_cube(4), 1, 0.7},
                                                          {folded_tetrahedron(), 6, 0.15}}) {
        const double whole = volume(shape), before = quality(shape);
        const auto betti = betti_numbers(shape.pieces);
        const Index simplices = shape.pieces.size(shape.pieces.dimension());
        const bool is_orientable = shape.pieces.orientable();
        for (int round = 1; round <= rounds; ++round) {
            shape = bisected(shape, all(shape));
            EXPECT_NEAR(volume(shape), whole, 1e-13 * whole);
            EXPECT_GE(quality(shape), least * before);
        }
        EXPECT_GE(shape.pieces.size(shape.pieces.dimension()), 3 * simplices);
        EXPECT_EQ(betti_numbers(shape.pieces), betti);
        EXPECT_EQ(shape.pieces.orientable(), is_orientable);
        EXPECT_NO_THROW(check(shape));
    }
}

TEST(Bisection, of_solids_makes_enclosures_that_intersect) {
    Shape shape = torus_of_one_cube(3);
    for (int round = 0; round < 3; ++round) {
        shape = bisected(shape, all(shape));
        const auto found = shape_spectrum(shape, {.count = 7});
        EXPECT_LE(found.lower[6], 4 * pi * pi);
        EXPECT_GE(found.upper[1], 4 * pi * pi);
    }
}

TEST(Bisection, of_triangles_glued_to_themselves_keeps_area_and_topology) {
    for (const auto& surface : {square_torus(), square_klein(), two_sided_plane(),
                                folded_triangle(), moebius_triangle()}) {
        std::vector<Index> names(surface.vertices());
        std::iota(names.begin(), names.end(), Index{0});
        Shape shape{in_order(surface, names).pieces, Vector::Ones(surface.edges())};
        const double whole = volume(shape);
        const Index characteristic = euler_characteristic(shape.pieces);
        const bool is_orientable = shape.pieces.orientable();
        for (int step = 0; step < 4; ++step) {
            shape = bisected(shape, all(shape));
            EXPECT_NEAR(volume(shape), whole, 1e-12);
            EXPECT_EQ(euler_characteristic(shape.pieces), characteristic);
            EXPECT_EQ(shape.pieces.orientable(), is_orientable);
        }
        EXPECT_GE(shape.pieces.size(2), 16);
    }
}

/// Of a mesh, and of its lengths alone.
std::vector<Shape> shapes_without_long_edges(const Mesh& mesh, double longest) {
    const DiscretizeOptions options{.criterion = MergeCriterion::none, .refine = longest};
    return {shape_of(discretize(mesh, options)), shape_of(discretize(length_mesh(mesh), options))};
}

TEST(Bisection, of_what_is_no_shape_is_refused) {
    Simplices edges(2, 2), triangle(1, 3); // a triangle with two sides glued
    edges << 0, 0, 0, 0;
    triangle << 0, 1, 0;
    Shape shape{.pieces = Pieces({edges, triangle}, {1}, {0}), .lengths = Vector(2)};
    shape.lengths << 0.6031, 1.2084;
    EXPECT_REFUSED(bisected(shape, {0}), "simplex 0", "edge lengths");
    shape.lengths << 0.6031, -1;
    EXPECT_REFUSED(bisected(shape, {0}), "-1");
    const Shape square = unmerged(kuhn(2, 2));
    for (const Index simplex : {-1, 8, 1'000'000})
        EXPECT_REFUSED(bisected(square, {0, simplex}), "simplex " + std::to_string(simplex),
                       "0 to 7");
}

TEST(Refine, encloses_the_eigenvalues_of_the_same_shape) {
    for (const Mesh& mesh : {kuhn(2, 2), cube_surface(2), kuhn(3, 1)}) {
        const bool is_solid = mesh.dimension() == 3;
        const auto before = shape_spectrum(unmerged(mesh), {.count = 4});
        for (const Shape& shape : shapes_without_long_edges(mesh, is_solid ? 0.6 : 0.3)) {
            EXPECT_LE(shape.lengths.maxCoeff(), (is_solid ? 0.6 : 0.3) * (1 + 2e-12));
            const auto after = shape_spectrum(shape, {.count = 4});
            for (Index j = 0; j < 4; ++j) {
                EXPECT_LE(after.lower[j], before.upper[j] * (1 + 1e-12));
                EXPECT_GE(after.upper[j], before.lower[j] * (1 - 1e-12));
                EXPECT_LE(after.upper[j] - after.lower[j], before.upper[j] - before.lower[j]);
            }
        }
    }
}

/// Points of new vertices are rounded where the mesh lies far from the origin.
TEST(Refine, knows_what_rounding_has_changed) {
    Mesh mesh = perturbed(kuhn(3, 2), 0.05, 1);
    mesh.points.array() += 1e5 / 3;
    const auto shapes = shapes_without_long_edges(mesh, 0.2);
    const auto squares = [&](int i) { return shapes[i].lengths.array().square().eval(); };
    const double change = ((squares(0) - squares(1)) / squares(1)).abs().maxCoeff();
    EXPECT_GT(change, 1e-12);
    EXPECT_LT(change, shapes[0].metric_error);
    EXPECT_LT(shapes[0].metric_error, 1e-5);
    EXPECT_GT(shapes[1].metric_error, 1e-14);
    EXPECT_LT(shapes[1].metric_error, 1e-11);
}

TEST(Refine, changes_nothing_where_nothing_is_divided) {
    for (Mesh mesh : {grid(5, 5), cube_surface(2), kuhn(3, 2)}) {
        const double longest = mesh.points.norm();
        mesh.points.array() += 5e6;
        for (const Shape& shape : shapes_without_long_edges(mesh, longest))
            EXPECT_EQ(shape.metric_error, 0);
        for (const Shape& shape : shapes_without_long_edges(mesh, 0.1))
            EXPECT_GT(shape.metric_error, 0);
    }
}

TEST(Refine, so_far_from_the_origin_that_middles_say_nothing_is_refused) {
    Mesh mesh = grid(5, 5);
    mesh.points.array() += 4e13;
    const DiscretizeOptions options{.criterion = MergeCriterion::none, .refine = 0.15};
    EXPECT_REFUSED(shape_spectrum(shape_of(discretize(mesh, options))), "simplex", "origin");
}

TEST(Refine, keeps_weights_of_cells_of_the_input) {
    const Mesh mesh = kuhn(2, 2);
    const Vector weights = Vector::LinSpaced(mesh.simplices.rows(), 1, 2);
    const DiscretizeOptions options{.criterion = MergeCriterion::none, .refine = 0.3};
    for (const auto& parts : {discretize(mesh, options), discretize(length_mesh(mesh), options)}) {
        const Shape shape = shape_of(parts, {BoundaryCondition::natural}, CellData(weights));
        double sum = 0;
        for (const Index s : all(shape))
            sum += shape.conductivity[s] * double(measured_simplex(shape, s).volume);
        EXPECT_NEAR(sum, weights.mean(), 1e-14);
    }
}

/// Order N^-2 in the number of triangles, in spite of the corner.
TEST(Adaptive, enclosures_of_an_l_have_order_4) {
    const Shape shape = unmerged(l_shape(2), {BoundaryCondition::essential});
    const double truth = 9.6397238440219;
    std::vector<double> wide, triangles;
    for (const double width : {1e-2, 1e-4}) {
        const auto found =
            shape_spectrum(shape, {.count = 1, .width = width, .max_triangles = 9000});
        expect_enclosed(found, {truth});
        EXPECT_LE(widths(found)[0], width);
        EXPECT_TRUE(found.warnings.empty());
        EXPECT_EQ(found.modes.rows(), shape.pieces.size(0));
        wide.push_back(widths(found)[0]);
        triangles.push_back(found.simplices);
    }
    EXPECT_GE(std::log(wide[0] / wide[1]) / std::log(triangles[1] / triangles[0]), 1.7);
    EXPECT_LE(triangles[1], 1800);
}

TEST(Adaptive, enclosures_of_a_cube_take_few_triangles) {
    const auto found = shape_spectrum(unmerged(cube_surface(2)),
                                      {.count = 4, .width = 1e-4, .max_triangles = 4000});
    EXPECT_LE(widths(found).maxCoeff(), 1e-4);
    EXPECT_LE(found.simplices, 2000);
    EXPECT_LE(found.lower[3], 4.1661180);
    EXPECT_GE(found.upper[1], 4.1660445);
}

TEST(Adaptive, enclosures_of_solids_and_at_level_1_become_narrow) {
    const auto cube =
        shape_spectrum(unmerged(kuhn(3, 1)), {.count = 4, .width = 4e-3, .max_triangles = 4000});
    EXPECT_LE(widths(cube).maxCoeff(), 4e-3);
    EXPECT_LE(cube.simplices, 400);
    EXPECT_LE(cube.lower[3], pi * pi);
    EXPECT_GE(cube.upper[1], pi * pi);
    EXPECT_EQ(cube.modes.rows(), 8);
    for (const Shape& shape : {unmerged(l_shape(2), {BoundaryCondition::essential}),
                               unmerged(kuhn(3, 2), {BoundaryCondition::essential})}) {
        const bool is_solid = shape.pieces.dimension() == 3;
        const double width = is_solid ? 0.1 : 0.02,
                     truth = is_solid ? 3 * pi * pi : 9.6397238440219;
        const auto found =
            shape_spectrum(shape, {.count = 1, .level = 1, .width = width, .max_triangles = 9000});
        EXPECT_LE(widths(found)[0], width);
        expect_enclosed(found, {truth});
    }
}

TEST(Adaptive, fills_the_most_triangles_and_warns) {
    const auto found = shape_spectrum(unmerged(cube_surface(2)),
                                      {.count = 4, .width = 1e-9, .max_triangles = 200});
    EXPECT_GE(found.simplices, 190);
    EXPECT_LE(found.simplices, 200);
    ASSERT_FALSE(found.warnings.empty());
    EXPECT_SAYS(found.warnings.back(), "3 of 4", "1e-09", "refine");
    EXPECT_REFUSED(shape_spectrum(unmerged(cube_surface(2)), {.count = 1, .max_triangles = -5}),
                   "simplices", "-5", "0");
}

/// Of the unit cube they are nearly 2 n alpha.
TEST(Adaptive, ends_where_rounding_hides_the_smallest_eigenvalue) {
    for (const auto& [n, alpha] : {std::pair{1, 1e-12}, {1, 1e-14}, {2, 1e-6}, {2, 1e-12}})
        for (const int level : {1, 2}) {
            SCOPED_TRACE(alpha);
            const Shape box = unmerged(kuhn(n, 4), {BoundaryCondition::robin, {}, {alpha}});
            int calls = 0;
            const auto found = shape_spectrum(box, {.count = 1,
                                                    .level = level,
                                                    .width = 1e-9,
                                                    .max_triangles = 20 * n * n * n,
                                                    .progress = [&](std::string_view) {
                                                        if (++calls > 2000)
                                                            throw std::runtime_error("no end");
                                                    }});
            const auto unrefined = shape_spectrum(box, {.count = 1, .level = level});
            EXPECT_LE(found.upper[0], unrefined.upper[0]);
            EXPECT_GE(found.lower[0], unrefined.lower[0]);
            EXPECT_LE(found.lower[0], 2 * n * alpha);
            EXPECT_GE(found.upper[0], 2 * n * alpha * (1 - 1e-5));
            EXPECT_FALSE(found.warnings.empty());
        }
}

TEST(Adaptive, makes_the_functions_that_a_coarse_mesh_lacks) {
    const Shape triangle = unmerged(kuhn(2, 1), {BoundaryCondition::essential});
    const Shape cube = unmerged(kuhn(3, 1), {BoundaryCondition::essential});
    for (const int level : {1, 2}) {
        expect_enclosed(
            shape_spectrum(triangle, {.count = 1, .level = level, .max_triangles = 500}),
            {2 * pi * pi});
        EXPECT_REFUSED(shape_spectrum(cube, {.count = 200, .level = level, .max_triangles = 40}),
                       "200", "degree " + std::to_string(level), "refine");
        EXPECT_REFUSED(shape_spectrum(triangle, {.count = 20, .level = level}), "20",
                       "degree " + std::to_string(level), "refine");
    }
}

} // namespace polydec::test::in_refinement
