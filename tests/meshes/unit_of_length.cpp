// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_unit_of_length {

Mesh of_size(double size, int n = 2) {
    Mesh mesh = kuhn(n, 1);
    mesh.points *= size;
    return mesh;
}

TEST(UnitOfLength, is_1_for_meshes_of_usual_size) {
    for (const double size : {1e-11, 1e-3, 1.0, 1e6, 1e11}) {
        EXPECT_EQ(unit_of_length(of_size(size)), 1);
        EXPECT_EQ(unit_of_length(length_mesh(of_size(size))), 1);
    }
}

TEST(UnitOfLength, is_a_power_of_4_that_makes_the_longest_edge_1_to_8) {
    for (int n = 1; n <= 5; ++n)
        for (const double size : {1e-300, 1e-150, 1e-20, 1e20, 1e150, 1e300}) {
            const auto mesh = of_size(size, n);
            LengthMesh by_lengths = length_mesh(of_size(1, n));
            by_lengths.lengths *= size;
            for (const double unit : {unit_of_length(mesh), unit_of_length(by_lengths)}) {
                EXPECT_EQ(std::ilogb(unit) % 2, 0);
                EXPECT_EQ(unit, std::exp2(std::ilogb(unit)));
                const auto lengths = length_mesh(in_units(mesh, unit)).lengths;
                EXPECT_GE(lengths.maxCoeff(), 1);
                EXPECT_LT(lengths.maxCoeff(), 8);
            }
        }
}

TEST(LengthMesh, has_lengths_at_every_size) {
    const Vector usual = length_mesh(of_size(1, 3)).lengths;
    for (const int exponent : {-1060, -1000, -700, -540, 0, 520, 700, 1000, 1022}) {
        const double size = std::ldexp(1.0, exponent);
        const Vector lengths = length_mesh(of_size(size, 3)).lengths;
        const double last_digit = std::max(1e-15, std::ldexp(1.0, -1074 - exponent));
        for (Index e = 0; e < lengths.size(); ++e)
            EXPECT_NEAR(lengths[e] / size, usual[e], 2 * last_digit) << exponent;
    }
}

TEST(LengthMesh, tells_of_lengths_that_are_no_numbers) {
    Mesh mesh = of_size(1);
    mesh.points.row(3) << 1.7e308, 1.7e308;
    EXPECT_REFUSED(length_mesh(mesh), "distance", "vertices 0", "3", "inf");
}

TEST(UnitOfLength, leaves_smaller_room_in_many_dimensions) {
    Mesh mesh = of_size(1e9);
    EXPECT_EQ(unit_of_length(mesh), 1);
    mesh.points = 1e9 * Points::Identity(13, 12);
    mesh.simplices.resize(1, 13);
    for (Index i = 0; i < 13; ++i)
        mesh.simplices(0, i) = i;
    EXPECT_NE(unit_of_length(mesh), 1);
}

TEST(UnitOfLength, keeps_the_places_of_vertices_that_no_cell_uses) {
    Mesh mesh = of_size(1e-150);
    mesh.points.conservativeResize(5, Eigen::NoChange);
    mesh.points.row(4) << 3e200, -2e200;
    const double unit = unit_of_length(mesh);
    EXPECT_TRUE(in_units(mesh, unit).points.allFinite());
    EXPECT_EQ(in_units(in_units(mesh, unit), 1 / unit).points, mesh.points);
}

TEST(UnitOfLength, measures_halves_of_lengths_that_are_too_large) {
    Mesh mesh = kuhn(1, 1);
    mesh.points << -1.5e308, 1.5e308;
    EXPECT_EQ(std::ilogb(unit_of_length(mesh)), 1022);
}

TEST(UnitOfLength, leaves_facets_with_tags_as_they_are) {
    Mesh mesh = kuhn(2, 1);
    mesh.facet_tags = {Simplices{{0, 1}}, {5}};
    const Mesh result = in_units(mesh, 4);
    EXPECT_EQ(result.facet_tags.simplices, mesh.facet_tags.simplices);
    EXPECT_EQ(result.facet_tags.tags, mesh.facet_tags.tags);
    EXPECT_NE(result.points, mesh.points);
}

TEST(InInputUnits, numbers_get_their_power_exactly_or_none) {
    const double unit = std::exp2(-400);
    EXPECT_EQ(in_input_units(3.0, unit, 2), 3 * std::exp2(-800));
    EXPECT_EQ(in_input_units(3.0, unit, -0.5), 3 * std::exp2(200));
    EXPECT_EQ(in_input_units(3.0, unit, 3), std::nullopt);
    EXPECT_EQ(in_input_units(3.0, unit, -3), std::nullopt);
    EXPECT_EQ(in_input_units(0.0, unit, 3), 0.0);
    EXPECT_EQ(in_input_units(std::numeric_limits<double>::denorm_min(), 1, 3),
              std::numeric_limits<double>::denorm_min());
}

TEST(InInputUnits, many_numbers_are_refused_by_name_unless_rounding_is_all_that_vanishes) {
    const double unit = std::exp2(-500);
    EXPECT_EQ(in_input_units((Vector(2) << 1, 1e-20).finished(), unit, 2, "x"),
              (Vector(2) << std::exp2(-1000), 0).finished());
    EXPECT_REFUSED(in_input_units((Vector(2) << 1, 1e-10).finished(), unit, 2, "x"), "x", "1e-10",
                   "3.05e-151", "^2");
    EXPECT_REFUSED(in_input_units((Vector(1) << 1).finished(), unit, -3, "volumes"), "volumes", "1",
                   "3.05e-151", "^-3");
}

TEST(InInputUnits, values_of_a_form_lose_digits_that_are_rounding_beside_the_largest) {
    const double unit = std::exp2(-500);
    const Vector form{{1, -1e-10, 0}};
    const Vector found = form_in_input_units(form, unit, 2, "x");
    EXPECT_EQ(found[0], std::exp2(-1000));
    EXPECT_NE(found[1], 0);
    EXPECT_LE((found * std::exp2(1000) - form).norm(), 1e-16);
    EXPECT_REFUSED(form_in_input_units(1e-10 * form, unit, 2, "flux"), "flux", "1e-10", "3.05e-151",
                   "^2");
    EXPECT_EQ(form_in_input_units(form, 1, 2, "x"), form);
}

} // namespace polydec::test::in_unit_of_length
