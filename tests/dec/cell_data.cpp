// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_cell_data {

/// What each n-cell has, by the names of its vertices.
using ByCorners = std::map<std::vector<Index>, double>;

template <class NameOf>
ByCorners by_corners(const Discretization& mesh, const Vector& values, NameOf name_of) {
    ByCorners result;
    for (Index cell = 0; cell < values.size(); ++cell) {
        std::vector<Index> corners;
        for (const Index v : cell_vertices(mesh, mesh.dimension(), cell))
            corners.push_back(name_of(v));
        std::sort(corners.begin(), corners.end());
        result[corners] = values[cell];
    }
    return result;
}

/// A number of each row of the input, equal within a cell, that no other cell has.
Vector any_data(const Discretization& mesh) {
    const int n = mesh.dimension();
    Vector result(mesh.input().size(n));
    for (Index t = 0; t < result.size(); ++t)
        result[mesh.input().input_row(t)] = 1 + mesh.merging().carriers(n)[t].cell;
    return result;
}

Vector on_cells(const Discretization& mesh, const Vector& data) {
    return CellData(data).on(mesh, "weight", Range::positive);
}

class DataOfCells : public OverMeshes {};

TEST_P(DataOfCells, go_with_the_cells_of_the_input_in_whatever_order) {
    const Mesh& input = mesh_named(GetParam());
    const auto mesh = discretize(input);
    const Vector data = any_data(mesh);
    const auto same = [](Index v) { return v; };
    const auto expected = by_corners(mesh, on_cells(mesh, data), same);
    EXPECT_EQ(expected.size(), static_cast<std::size_t>(mesh.complex().size(mesh.dimension())));
    const Renumbered other = shuffled(input, 3);
    const auto permuted = discretize(other.mesh);
    const auto old_number = [&](Index v) { return other.vertices[v]; };
    EXPECT_EQ(by_corners(permuted, on_cells(permuted, data(other.cells)), old_number), expected);
    if (mesh.complex().size(mesh.dimension()) > 4 && mesh.merging().is_identity()) {
        EXPECT_NE(by_corners(permuted, on_cells(permuted, data), old_number), expected);
    }
}

POLYDEC_OVER_MESHES(DataOfCells);

/// Cells that make no sense before and between those of a square of four triangles around its
/// middle, and one that is turned over.
TEST(DataOfCells, stay_with_cells_when_others_are_left_out) {
    const Points points = made_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.4}}, {{0, 1, 4}}).points;
    Mesh mesh{points, Simplices(7, 3), {}};
    mesh.simplices << 0, 0, 1, 2, 4, 1, 0, 1, 4, 1, 0, 4, 4, 2, 3, 0, 1, 1, 3, 0, 4;
    const auto made = discretize(mesh, {.criterion = MergeCriterion::none});
    ASSERT_EQ(made.complex().size(2), 4);
    EXPECT_EQ(count_input_cells(made), 7);
    const Vector found = on_cells(made, Vector::LinSpaced(7, 1, 7));
    const ByCorners expected{{{0, 1, 4}, 3}, {{1, 2, 4}, 2}, {{2, 3, 4}, 5}, {{0, 3, 4}, 7}};
    EXPECT_EQ(by_corners(made, found, [](Index v) { return v; }), expected);
}

TEST(DataOfCells, are_one_for_each_polygon_that_was_split) {
    PolygonMesh polygons; // a row of rectangles of different sizes, of which two are cut in two
    polygons.points =
        made_of({{0, 0}, {0, 1}, {1, 0}, {1, 1}, {4, 0}, {4, 1}, {9, 0}, {9, 1}, {16, 0}, {16, 1}},
                {{}})
            .points;
    for (const auto& corners : std::vector<std::vector<Index>>{
             {0, 2, 3, 1}, {2, 4, 3}, {4, 5, 3}, {4, 6, 7, 5}, {6, 8, 7}, {8, 9, 7}})
        polygons.add(corners);
    const auto mesh = discretize(split_polygons(polygons));
    EXPECT_EQ(count_input_cells(mesh), 6);
    ASSERT_EQ(mesh.complex().size(2), 4);
    const Vector found = on_cells(mesh, Vector{{1, 2, 2, 3, 4, 4}});
    for (Index cell = 0; cell < 4; ++cell)
        EXPECT_EQ(found[cell], 1 + cell_vertices(mesh, 2, cell).front() / 2);
    EXPECT_REFUSED(on_cells(mesh, Vector::Ones(8)), "8 values", "6");
}

TEST(DataOfCells, are_one_for_each_solid_that_was_split) {
    PolygonMesh solids; // two cubes, one on the other
    solids.points.resize(12, 3);
    for (Index v = 0; v < 12; ++v)
        solids.points.row(v) << (v % 4 == 1 || v % 4 == 2), v % 4 / 2, v / 4;
    solids.corners = {4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5, 6, 7};
    solids.offsets = {0, 8, 16};
    const auto mesh = discretize(split_cells(solids, 3));
    ASSERT_EQ(mesh.complex().size(3), 2);
    EXPECT_EQ(on_cells(mesh, Vector{{5, 3}}), (Vector{{3, 5}}));
}

TEST(DataOfCells, stay_with_cells_that_are_divided_or_peeled) {
    // the lower cell has a hanging node on its upper edge
    const Mesh hanging =
        made_of({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {1, -2}}, {{0, 2, 3}, {2, 1, 3}, {0, 4, 1}});
    const auto divided =
        discretize(join_hanging(hanging).mesh, {.criterion = MergeCriterion::none});
    ASSERT_EQ(divided.complex().size(2), 4);
    const Vector found = on_cells(divided, Vector{{1, 2, 3}});
    EXPECT_EQ((found.array() == 3).count(), 2);
    EXPECT_EQ(found.sum(), 9);

    Mesh sliver = made_of({{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1e-14}}, {{0, 3, 1}, {0, 1, 2}});
    const auto rest = discretize(peeled(sliver));
    ASSERT_EQ(rest.complex().size(2), 1);
    EXPECT_EQ(on_cells(rest, Vector{{5, 7}})[0], 7);
}

TEST(DataOfCells, that_differ_within_a_cell_are_refused_by_both) {
    const Mesh square = grid(1, 1);
    const auto mesh = discretize(square);
    ASSERT_EQ(mesh.complex().size(2), 1);
    const auto with = [&](const Discretization& on, double first, double second) {
        return refusal([&] { weighted_stars(on, 1, Vector{{first, second}}); });
    };
    EXPECT_EQ(with(mesh, 2, 2), "accepted");
    EXPECT_EQ(with(mesh, 0.3, 0.1 + 0.2), "accepted");
    EXPECT_SAYS(with(mesh, 1, 2), "cells 0 and 1", "merged", "tags", "keep");
    EXPECT_EQ(with(discretize(square, {.criterion = MergeCriterion::none}), 1, 2), "accepted");
    Mesh tagged = square;
    tagged.tags = {1, 2};
    EXPECT_EQ(with(discretize(tagged, {.materials = Materials::keep_apart}), 1, 2), "accepted");
    EXPECT_SAYS(with(mesh, -1, 1), "input's 2-cell 0", "-1");
    const Mesh rhombus = made_of({{0, 0}, {1, -0.3}, {2, 0}, {1, 0.3}}, {{0, 1, 2}, {0, 2, 3}});
    const auto flips = discretize(rhombus, {.delaunay = Delaunay::flips});
    EXPECT_EQ(with(flips, 2, 2), "accepted");
    EXPECT_SAYS(with(flips, 1, 2), "flipped");
    EXPECT_EQ(CellData::on_cells(Vector{{4}}).on(mesh, "weight", Range::positive)[0], 4);
    const std::vector<DenseMatrix> tensors{DenseMatrix::Identity(2, 2),
                                           2 * DenseMatrix::Identity(2, 2)};
    EXPECT_REFUSED(material_star(mesh, tensors), "cells 0 and 1", "merged");
}

} // namespace polydec::test::in_cell_data
