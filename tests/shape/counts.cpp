// SPDX-License-Identifier: MIT
#include "shape/family_counter.h"
#include "tests/shape/known_shapes.h"

namespace polydec::test::in_counts {

/// How many random shapes the law is tried on; POLYDEC_SHAPES sets another number.
int tries() {
    const char* given = std::getenv("POLYDEC_SHAPES");
    return given == nullptr ? 120 : std::max(1, std::atoi(given));
}

Index below(const std::vector<double>& eigenvalues, double s) {
    return static_cast<Index>(std::count_if(eigenvalues.begin(), eigenvalues.end(),
                                            [s](double value) { return value < s; }));
}

/// The law of it all: at least low(s), at most high(s).
TEST(CountBelow, encloses_the_number_of_eigenvalues) {
    std::mt19937 random(1);
    Index counts = 0, exact = 0;
    for (int i = 0; i < tries(); ++i) {
        const KnownShape known = random_shape(random);
        for (int j = 0; j < 5; ++j) {
            const double s = 150 * std::pow(random() / 4294967296.0, 2);
            for (const int degree : {1, 2}) {
                const auto count = count_below(known.shape, s, {.level = degree});
                const Index truth = below(known.eigenvalues, s);
                EXPECT_LE(count.at_least, truth) << known.name << i << " " << s << " " << degree;
                if (!count.at_most)
                    continue;
                EXPECT_GE(*count.at_most, truth) << known.name << i << " " << s << " " << degree;
                ++counts;
                exact += count.at_least == *count.at_most;
            }
        }
    }
    EXPECT_GE(counts, tries() * 3);
    EXPECT_GE(2 * exact, counts); // it says something
    RecordProperty("counts", counts);
    RecordProperty("exact", exact);
}

TEST(CountBelow, knows_constants) {
    const Shape two = unmerged(pillow(4));
    EXPECT_EQ(zero_eigenvalues(two), 1);
    EXPECT_EQ(zero_eigenvalues(unmerged(grid(3, 2), {BoundaryCondition::robin, {}, {1}})), 0);
    for (const double s : {1e-9, 1e-3, 1.0})
        for (const int degree : {1, 2}) {
            const auto count = count_below(two, s, {.level = degree});
            EXPECT_EQ(count.at_least, 1) << s;
            EXPECT_EQ(count.at_most, 1) << s;
        }
    EXPECT_EQ(count_below(two, 0).at_most, 0);
}

/// A grid of needles, ten thousand times as long as wide.
TEST(CountBelow, is_sharp_on_needles_with_right_angles) {
    const Shape shape = unmerged(kuhn({2000, 1}, {1, 5}), {BoundaryCondition::natural});
    for (const int degree : {1, 2}) {
        const auto count = count_below(shape, 0.1, {.level = degree});
        EXPECT_EQ(count.at_least, 1);
        EXPECT_EQ(count.at_most, 1);
    }
}

/// Two triangles of a square of side 1: C^2 is 2 / 14.68.
TEST(CountBelow, names_simplices_that_are_too_large) {
    const Shape shape = unmerged(grid(1, 1));
    const auto count = count_below(shape, 8);
    EXPECT_FALSE(count.at_most);
    EXPECT_EQ(count.too_large, (std::vector<Index>{0, 1}));
    ASSERT_EQ(count.warnings.size(), 1u);
    EXPECT_SAYS(count.warnings[0], "7.34", "2", "too large", "0, 1", "divide");
    EXPECT_TRUE(count_below(shape, 7).at_most);
}

/// Right triangles of legs 1 and h, whose lengths may be off by a share e each.
TEST(CountBelow, is_safe_where_lengths_are_not_known_exactly) {
    Shape shape = unmerged(kuhn(2, 8), {BoundaryCondition::essential});
    const double first = 2 * pi * pi;
    shape.length_error = 1e-3;
    for (const double share : {0.994, 0.998, 1.002, 1.006}) {
        const auto count = count_below(shape, share * first);
        EXPECT_EQ(count.at_least, 0);
        EXPECT_EQ(count.at_most, 1);
    }
    EXPECT_EQ(count_below(shape, 0.95 * first).at_most, 0);
    EXPECT_EQ(count_below(shape, 1.05 * first).at_least, 1);
}

TEST(CountBelow, refuses_what_is_no_shape) {
    const Shape shape = unmerged(grid(2, 2));
    const auto refused = [](const Shape& given, double s = 1, int level = 2) {
        return refusal([&] { count_below(given, s, {.level = level}); });
    };
    EXPECT_SAYS(refused(shape, 1, 3), "level 3", "1", "2");
    EXPECT_SAYS(refused(shape, std::nan("")), "nan", "finite");
    Shape other = shape;
    other.lengths[3] = -1;
    EXPECT_SAYS(refused(other), "edge 3", "-1");
    other = shape;
    other.lengths[0] = 9;
    EXPECT_SAYS(refused(other), "simplex 0", "vertices", "lengths");
    other = shape;
    other.density = Vector::Ones(7);
    EXPECT_SAYS(refused(other), "7 density", "8");
    other.density = -Vector::Ones(8);
    EXPECT_SAYS(refused(other), "density", "-1", "simplex 0", "positive");
    other = shape;
    other.conditions.fixed_vertices.assign(9, true);
    EXPECT_SAYS(refused(other), "vertex", "facets");
    other.conditions.fixed_vertices.assign(3, false);
    EXPECT_REFUSED(check(other), "3 marks of fixed vertices", "9");
    other.conditions.fixed_vertices.assign(9, false);
    EXPECT_NO_THROW(check(bisected(other, {0})));
    other = shape;
    other.length_error = 0.5;
    EXPECT_SAYS(refused(other), "0.5", "0.1");
    std::mt19937 random(1);
    other = book(random, 3, 2).shape;
    other.functions = ShapeFunctions::twisted;
    EXPECT_REFUSED(check(other), "3 simplices", "facet", "twisted");
}

TEST(Shape, of_a_tilted_plane_has_the_lengths_between_the_points_given) {
    Mesh mesh = grid(24, 24);
    DenseMatrix basis(2, 3);
    basis << 0.6, 0.64, 0.48, -0.8, 0.48, 0.36;
    mesh.points = (mesh.points * basis).eval();
    const auto on = discretize(mesh, {.criterion = MergeCriterion::none});
    ASSERT_EQ(on.geometry().metric().ambient_dimension(), 2);
    EXPECT_EQ(shape_of(on).lengths, edge_lengths(on.pieces(), mesh.points));
}

TEST(Shape, of_merged_cells_has_the_marks_of_vertices_of_its_pieces) {
    const Discretization merged = discretize(grid(3, 3));
    BoundaryConditions conditions;
    conditions.fixed_vertices.assign(merged.complex().size(0), false);
    EXPECT_NO_THROW(shape_of(merged, conditions));
    conditions.fixed_vertices.pop_back();
    EXPECT_REFUSED(shape_of(merged, conditions), "15 marks of fixed vertices", "16");
}

/// Forms say nothing from there on.
TEST(FamilyCounter, counts_below_the_limit_alone) {
    for (const int level : {1, 2}) {
        const FormFamily family = lower_form(unmerged(kuhn(2, 3)), level);
        FamilyCounter counter(family, "auto");
        EXPECT_TRUE(counter.at(0.9 * family.limit()));
        EXPECT_FALSE(counter.at(1.1 * family.limit()));
    }
}

TEST(CountBelow, of_numbers_out_of_range_is_refused) {
    const auto check = [](const Shape& shape, const CountBelow& expected, double unit, bool fits) {
        if (!fits) {
            EXPECT_REFUSED(count_below(shape, 50 * unit), "simplex 0", "outside the range");
            try {
                shape_spectrum(shape, {.count = 2});
                ADD_FAILURE();
            } catch (const InvalidInput& error) {
                EXPECT_SAYS(error.what(), "simplex 0", "outside the range");
                EXPECT_EQ(error.place().cells, std::vector<Index>{0});
            }
            return;
        }
        const CountBelow count = count_below(shape, 50 * unit);
        EXPECT_EQ(count.at_least, expected.at_least);
        EXPECT_EQ(count.at_most, expected.at_most);
    };
    for (const Mesh& mesh : {kuhn(1, 2), kuhn(2, 2), kuhn(3, 1), kuhn(4, 1)}) {
        const Shape given = unmerged(mesh);
        const CountBelow expected = count_below(given, 50);
        for (const double size : {1e-90, 1e-65, 1e-30, 1e30, 1e65, 1e90}) {
            Shape shape = given;
            shape.lengths *= size;
            check(shape, expected, 1 / (size * size), std::abs(std::log10(size)) < 50);
        }
        for (const auto& [kappa, rho, fits] : {std::tuple{1e60, 1e-100, false},
                                               {1e-50, 1e-40, true},
                                               {1e90, 1e-20, true},
                                               {1e260, 1e255, false},
                                               {1.0, 1e-160, false},
                                               {1e-160, 1.0, false}}) {
            Shape shape = given;
            shape.conductivity = Vector::Constant(mesh.simplices.rows(), kappa);
            shape.density = Vector::Constant(mesh.simplices.rows(), rho);
            check(shape, expected, kappa / rho, fits);
        }
    }
}

} // namespace polydec::test::in_counts
