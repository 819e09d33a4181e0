// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec::test::in_generators {

/// What is true of a mesh by theory.
struct Expectation {
    std::string name;
    Mesh mesh;
    Index vertices;
    Index cells;
    Index euler;
    Index boundary_facets;
    double volume; ///< NaN: no formula
};

void PrintTo(const Expectation& expected, std::ostream* out) {
    *out << expected.name;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<Expectation> expectations() {
    // clang-format off
    std::vector<Expectation> result{
        {"grid_1_1", grid(1, 1), 4, 2, 1, 4, 1.0},
        {"grid_5_3", grid(5, 3, 2.0, 0.5), 24, 30, 1, 16, 1.0},
        {"uv_sphere_3_2", uv_sphere(3, 2), 5, 6, 2, 0, unknown},
        {"uv_sphere_7_6", uv_sphere(7, 6), 37, 70, 2, 0, unknown},
        {"torus_3_3", torus(3, 3), 9, 18, 0, 0, unknown},
        {"torus_9_5", torus(9, 5, 3.0, 1.0), 45, 90, 0, 0, unknown},
        {"kuhn_1", kuhn(1, 7), 8, 7, 1, 2, 1.0},
        {"kuhn_5", kuhn(5, 1), 32, 120, 1, 240, 1.0},
        {"kuhn_box", kuhn({2, 1, 3}, {0.5, 4.0, 3.0}), 24, 36, 1, 44, 6.0},
        {"split_2", split_boxes({7, 5}), 48, 70, 1, 24, 1.0},
        {"split_3", split_boxes({2, 1, 3}, {0.5, 4.0, 3.0}, 7), 24, 36, 1, 44, 6.0},
        {"split_5", split_boxes({1, 1, 1, 1, 2}), 48, 240, 1, 432, 1.0},
        {"bcc_box", bcc({2, 1, 3}, 0.5), 30, 72, 1, 44, 0.75},
        {"fcc_box", fcc({1, 3, 2}, 0.5), 53, 144, 1, 88, 0.75},
        {"d4_1", d4(1), 41, 192, 1, 192, 1.0},
        {"d4_box", d4({2, 1, 1, 1}, 0.5), 68, 384, 1, 336, 0.125},
    };
    // clang-format on
    for (const Index c : {2, 3, 4, 5, 9, 20}) {
        const auto vertices = static_cast<Index>(hexagons(c).points.rows());
        const Index rows = (vertices - 1) / (2 * c + 1);
        result.push_back({"hexagons_" + std::to_string(c), hexagons(c), rows * (2 * c + 1) + 1,
                          4 * c * rows - 2 * c, 1, 2 * (c + rows), 1.0});
    }
    for (const Index r : {2, 3, 4, 7, 16}) {
        const auto m = static_cast<Index>(std::lround(std::sqrt(3.0) * r));
        result.push_back({"well_centered_" + std::to_string(r), well_centered(r),
                          (r + 1) * m + r * (m - 1), 4 * r * (m - 1), 1, 2 * (m - 1 + r), 1.0});
    }
    for (const Index f : {1, 2, 3, 4, 7}) {
        const std::string name = std::to_string(f);
        result.push_back(
            {"icosphere_" + name, icosphere(f), 10 * f * f + 2, 20 * f * f, 2, 0, unknown});
        result.push_back(
            {"goldberg_" + name, goldberg(f), 20 * f * f, 40 * f * f - 4, 2, 0, unknown});
    }
    for (const Index c : {1, 2, 3}) {
        const std::string name = std::to_string(c);
        const Index corners = (c + 1) * (c + 1) * (c + 1);
        result.push_back(
            {"bcc_" + name, bcc(c), corners + c * c * c, 12 * c * c * c, 1, 12 * c * c, 1.0});
        result.push_back({"fcc_" + name, fcc(c), corners + 3 * (c + 1) * c * c, 24 * c * c * c, 1,
                          24 * c * c, 1.0});
    }
    const Mesh part = flange(12);
    const auto vertices = static_cast<Index>(part.points.rows());
    result.push_back({"flange_12", part, vertices, 2 * vertices, 0, 0, unknown});
    return result;
}

class Generated : public testing::TestWithParam<Expectation> {};

TEST_P(Generated, has_the_counts_of_its_formula) {
    const auto& expected = GetParam();
    EXPECT_EQ(expected.mesh.points.rows(), expected.vertices);
    EXPECT_EQ(expected.mesh.simplices.rows(), expected.cells);
    const auto counts = face_counts(expected.mesh);
    EXPECT_EQ(counts.front(), expected.vertices);
    EXPECT_EQ(counts.back(), expected.cells);
    EXPECT_EQ(euler_characteristic(expected.mesh), expected.euler);
    EXPECT_TRUE(expected.mesh.warnings.empty());
}

TEST_P(Generated, sees_each_interior_facet_once_each_way) {
    const FacetTally tally = tally_facets(GetParam().mesh);
    EXPECT_EQ(tally.boundary, GetParam().boundary_facets);
    EXPECT_EQ(tally.clashing, 0);
    EXPECT_EQ(tally.branching, 0);
}

TEST_P(Generated, is_oriented_positively) {
    const auto& expected = GetParam();
    const bool is_flat = expected.mesh.dimension() == expected.mesh.ambient_dimension();
    EXPECT_GT(is_flat ? least_determinant(expected.mesh) : enclosed_volume(expected.mesh), 0.0);
}

TEST_P(Generated, fills_its_domain) {
    const auto& expected = GetParam();
    const double volume = total_volume(expected.mesh);
    EXPECT_NEAR(volume, std::isnan(expected.volume) ? volume : expected.volume, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Generated, testing::ValuesIn(expectations()),
                         [](const auto& instance) { return instance.param.name; });

TEST(Generators, make_the_golden_meshes) {
    EXPECT_TRUE(same_geometry(grid(4, 4), read_golden("grid4.nsc")));
    EXPECT_TRUE(same_geometry(hexagons(4), read_golden("hex4.nsc")));
    EXPECT_TRUE(same_geometry(well_centered(4), read_golden("wellcentred4.nsc")));
    EXPECT_TRUE(same_geometry(uv_sphere(8, 8), read_golden("uv8.off")));
    EXPECT_TRUE(same_geometry(torus(8, 6), read_golden("torus8x6.off")));
    EXPECT_TRUE(same_geometry(kuhn(1, 5), read_golden("kuhn1d.nsc")));
    EXPECT_TRUE(same_geometry(kuhn(3, 2), read_golden("kuhn3.nsc")));
    EXPECT_TRUE(same_geometry(kuhn(4, 1), read_golden("kuhn4.nsc")));
    EXPECT_TRUE(same_geometry(fcc(1), read_golden("fcc1.nsc")));
    EXPECT_FALSE(same_geometry(grid(4, 4, 1.0, 1.0 + 1e-11), read_golden("grid4.nsc")));
    EXPECT_FALSE(same_geometry(well_centered(4), read_golden("grid4.nsc")));
}

/// Cells without a facet in the boundary, which is where the diagonals are a free choice.
std::vector<std::vector<Index>> inner_cells(const Simplices& cells) {
    auto result = sorted_rows(cells);
    const Mesh place = read_golden("bcc2.nsc");
    const auto in_boundary_facet = [&](const std::vector<Index>& cell) {
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {0.0, 1.0})
                if (std::count_if(cell.begin(), cell.end(),
                                  [&](Index v) { return place.points(v, axis) == side; }) == 3)
                    return true;
        return false;
    };
    result.erase(std::remove_if(result.begin(), result.end(), in_boundary_facet), result.end());
    return result;
}

TEST(Generators, make_the_golden_body_centered_lattice_but_for_diagonals_in_the_boundary) {
    const Mesh ours = bcc(2), theirs = read_golden("bcc2.nsc");
    ASSERT_EQ(ours.points.rows(), theirs.points.rows());
    const auto inner = inner_cells(theirs.simplices);
    EXPECT_EQ(inner.size(), 48U);
    const auto in_theirs = matching_vertices(ours, theirs, 1e-12);
    EXPECT_EQ(inner_cells(ours.simplices.unaryExpr([&](Index v) { return in_theirs[v]; })), inner);
}

TEST(Kuhn, lists_its_vertices_in_lexicographic_order_also_of_the_golden_file) {
    EXPECT_EQ(kuhn(3, 2).points, read_golden("kuhn3.nsc").points);
    EXPECT_EQ(kuhn(3, 2).simplices, read_golden("kuhn3.nsc").simplices);
}

TEST(Moebius, is_one_sided_and_has_one_boundary) {
    for (const auto& [around, across] : {std::pair{3, 1}, {8, 3}, {20, 4}}) {
        const Mesh mesh = moebius(around, across);
        EXPECT_EQ(mesh.ambient_dimension(), 3);
        EXPECT_EQ(face_counts(mesh),
                  (std::vector<Index>{around * (across + 1), around * (3 * across + 1),
                                      2 * around * across}));
        EXPECT_EQ(euler_characteristic(mesh), 0);
        const FacetTally tally = tally_facets(mesh);
        EXPECT_EQ(tally.boundary, 2 * around);
        EXPECT_EQ(tally.branching, 0);
        EXPECT_GT(tally.clashing, 0);
    }
}

TEST(Flange, is_a_closed_part_whose_volume_is_that_of_its_profile) {
    for (const int segments : {3, 24, 100}) {
        const double polygon = 0.5 * segments * std::sin(2.0 * std::numbers::pi / segments);
        const double hub = 0.55 * 0.55, top = 0.45 * 0.45, bore = 0.3 * 0.3;
        const double integral = 0.2 * (1.0 - bore) + 0.4 * (hub - bore) +
                                0.1 * ((hub + 0.55 * 0.45 + top) / 3.0 - bore);
        EXPECT_NEAR(enclosed_volume(flange(segments)), polygon * integral, 1e-13);
    }
}

TEST(Generators, refuse_wrong_arguments_by_name_and_range) {
    const auto infinity = std::numeric_limits<double>::infinity();
    const auto most = std::numeric_limits<int>::max();
    EXPECT_REFUSED(grid(0, 1), "grid", "nx", "0", "1", "2147483647");
    EXPECT_REFUSED(grid(1, -3), "grid", "ny", "-3", "1", "2147483647");
    EXPECT_REFUSED(grid(1, 1, 0.0), "grid", "width", "0", "above 0");
    EXPECT_REFUSED(grid(1, 1, 1.0, infinity), "grid", "height", "inf", "above 0");
    EXPECT_REFUSED(grid(100000, 100000), "grid", "1.00002e+10 vertices", "2^31 - 1");
    EXPECT_REFUSED(hexagons(1), "hexagons", "columns", "1", "2", "1000000000");
    EXPECT_REFUSED(hexagons(1000000000), "hexagons", "2.309401079e+18 vertices", "2^31 - 1");
    EXPECT_REFUSED(well_centered(1), "well_centered", "rows", "1", "2", "1000000000");
    EXPECT_REFUSED(well_centered(20000), "well_centered", "2771200000 cells", "2^31 - 1");
    EXPECT_REFUSED(uv_sphere(2, 8), "uv_sphere", "meridians", "2", "3", "2147483647");
    EXPECT_REFUSED(uv_sphere(8, 1), "uv_sphere", "bands", "1", "2", "2147483647");
    EXPECT_REFUSED(uv_sphere(most, most), "uv_sphere", "4.611686012e+18 vertices", "2^31 - 1");
    EXPECT_REFUSED(icosphere(0), "icosphere", "frequency", "0", "1", "2147483647");
    EXPECT_REFUSED(icosphere(10363), "icosphere", "2147835380 cells", "2^31 - 1");
    EXPECT_REFUSED(goldberg(0), "goldberg", "frequency", "0", "1", "64");
    EXPECT_REFUSED(goldberg(65), "goldberg", "frequency", "65", "1", "64");
    EXPECT_REFUSED(torus(2, 6), "torus", "major", "2", "3", "2147483647");
    EXPECT_REFUSED(torus(8, 2), "torus", "minor", "2", "3", "2147483647");
    EXPECT_REFUSED(torus(8, 6, 0.4, 0.4), "torus", "minor_radius", "0.4", "major_radius", "0.4");
    EXPECT_REFUSED(moebius(2, 1), "moebius", "around", "2", "3", "2147483647");
    EXPECT_REFUSED(moebius(8, 0), "moebius", "across", "0", "1", "2147483647");
    EXPECT_REFUSED(moebius(8, 1, 2.0), "moebius", "width", "2", "0", "2");
    EXPECT_REFUSED(flange(2), "flange", "segments", "2", "3", "2147483647");
    EXPECT_REFUSED(flange(most), "flange", "4.11099316e+18 vertices", "2^31 - 1");
    EXPECT_REFUSED(kuhn(0, 1), "kuhn", "n = 0", "1", "12");
    EXPECT_REFUSED(kuhn(13, 1), "kuhn", "n = 13", "1", "12");
    EXPECT_REFUSED(kuhn(3, 0), "kuhn", "cells_per_side", "0", "1", "2147483647");
    EXPECT_REFUSED(kuhn({2, 0}), "kuhn", "cells[1]", "0", "1", "2147483647");
    EXPECT_REFUSED(kuhn({2, 2}, {1.0}), "kuhn", "1 lengths", "2 axes");
    EXPECT_REFUSED(kuhn({2, 2}, {1.0, -1.0}), "kuhn", "lengths[1]", "-1", "above 0");
    EXPECT_REFUSED(kuhn(1, most), "kuhn", "2147483648 vertices", "2^31 - 1");
    EXPECT_REFUSED(bcc(0), "bcc", "cells", "0", "1", "2147483647");
    EXPECT_REFUSED(bcc(600), "bcc", "2592000000 cells", "2^31 - 1");
    EXPECT_REFUSED(bcc({2, 2}), "bcc", "2 counts", "3 axes");
    EXPECT_REFUSED(bcc({2, 2, 0}), "bcc", "cells[2]", "0", "1", "2147483647");
    EXPECT_REFUSED(fcc({1, 1, 1}, -2.0), "fcc", "edge", "-2", "above 0");
    EXPECT_REFUSED(bcc({1, 4, 1}, 1e308), "bcc", "cells[1] * edge", "inf", "above 0");
    EXPECT_REFUSED(d4(0), "d4", "cells", "0", "1", "2147483647");
    EXPECT_REFUSED(d4(60), "d4", "2488320000 cells", "2^31 - 1");
    EXPECT_REFUSED(split_boxes({}), "split_boxes", "n = 0", "1", "12");
    EXPECT_REFUSED(fcc(0), "fcc", "cells", "0", "1", "2147483647");
    EXPECT_REFUSED(fcc(448), "fcc", "2157969408 cells", "2^31 - 1");
}

} // namespace polydec::test::in_generators
