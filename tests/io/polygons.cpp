// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <rapidcheck.h>

namespace polydec::test::in_polygons {

using Cells = std::vector<std::vector<Index>>;

/// One polygon with its corners in this order, in the plane of the first and the last axis of R^N.
PolygonMesh polygon(const std::vector<std::pair<double, double>>& places, int axes = 2) {
    PolygonMesh mesh;
    mesh.points = Points::Zero(static_cast<Eigen::Index>(places.size()), axes);
    for (std::size_t i = 0; i < places.size(); ++i) {
        mesh.points(static_cast<Eigen::Index>(i), 0) = places[i].first;
        mesh.points(static_cast<Eigen::Index>(i), axes - 1) += axes > 1 ? places[i].second : 0.0;
        mesh.corners.push_back(static_cast<Index>(i));
    }
    mesh.offsets.push_back(static_cast<Index>(places.size()));
    return mesh;
}

/// Signed areas in the plane of the first and the last axis.
std::vector<double> areas(const Mesh& mesh) {
    std::vector<double> result;
    for (Eigen::Index i = 0; i < mesh.simplices.rows(); ++i) {
        const auto place = [&mesh, i](Eigen::Index corner) -> Eigen::Vector2d {
            const auto row = mesh.points.row(mesh.simplices(i, corner));
            return {row[0], row[row.size() - 1]};
        };
        const Eigen::Vector2d u = place(1) - place(0);
        const Eigen::Vector2d v = place(2) - place(0);
        result.push_back(0.5 * (u.x() * v.y() - u.y() * v.x()));
    }
    return result;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Polygons, TrianglesHaveTheTagOfTheirPolygon) {
    auto square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    square.corners.insert(square.corners.end(), {0, 1, 2, 3});
    square.offsets = {0, 4, 5, 8};
    square.tags = {7, 8, 9};
    EXPECT_EQ(split_polygons(square).tags, (std::vector<Index>{7, 7, 9}));
    square.tags = {7, 8};
    EXPECT_REFUSED(split_polygons(square), "2 tags", "3 faces");
}

TEST(Polygons, NoTriangleIsWithoutArea) {
    const auto mesh = split_polygons(polygon({{0, 0}, {1, 0}, {2, 0}, {1, 2}}));
    EXPECT_EQ(rows(mesh.simplices), (Cells{{1, 2, 3}, {1, 3, 0}}));
}

TEST(Polygons, NoTriangleIsFlipped) {
    const auto mesh = split_polygons(polygon({{0, 0}, {2, -2}, {0.5, 0}, {2, 2}}));
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 2, 3}}));
    const auto turned = split_polygons(polygon({{2, -2}, {0.5, 0}, {2, 2}, {0, 0}}));
    EXPECT_EQ(rows(turned.simplices), (Cells{{1, 2, 3}, {1, 3, 0}}));
}

TEST(Polygons, EarsAreCutWhereNoFanFits) {
    const auto comb = polygon({{0, 0},
                               {6, 0},
                               {6, 3},
                               {5, 3},
                               {5, 1},
                               {4, 1},
                               {4, 3},
                               {2, 3},
                               {2, 1},
                               {1, 1},
                               {1, 3},
                               {0, 3}});
    const auto mesh = split_polygons(comb);
    const auto parts = areas(mesh);
    EXPECT_EQ(mesh.simplices.rows(), 10);
    EXPECT_GT(*std::min_element(parts.begin(), parts.end()), 0.4);
    EXPECT_NEAR(sum(parts), 14.0, 1e-12);
}

TEST(Polygons, HolesMayBeReachedByABridge) {
    auto ring = polygon({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {1, 2}, {2, 2}, {2, 1}});
    ring.corners = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
    ring.offsets = {0, 10};
    const auto mesh = split_polygons(ring);
    const auto parts = areas(mesh);
    EXPECT_EQ(mesh.simplices.rows(), 8);
    EXPECT_GT(*std::min_element(parts.begin(), parts.end()), 0.0);
    EXPECT_NEAR(sum(parts), 8.0, 1e-12);
}

TEST(Polygons, EveryStarShapedPolygonIsCoveredOnceWhateverTheAmbientDimension) {
    const auto holds = rc::check("areas are positive and sum up", [] {
        const int size = *rc::gen::inRange(4, 30);
        const int axes = *rc::gen::inRange(2, 6);
        std::vector<std::pair<double, double>> places;
        for (int i = 0; i < size; ++i) {
            const double angle = 2.0 * std::acos(-1.0) * i / size;
            const double radius = 0.01 * *rc::gen::inRange(20, 100);
            places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
        double area = 0.0;
        for (int i = 0; i < size; ++i) {
            const auto& [x, y] = places[static_cast<std::size_t>(i)];
            const auto& [u, v] = places[static_cast<std::size_t>((i + 1) % size)];
            area += 0.5 * (x * v - y * u);
        }
        const auto mesh = split_polygons(polygon(places, axes));
        const auto parts = areas(mesh);
        RC_ASSERT(mesh.simplices.rows() == size - 2);
        RC_ASSERT(*std::min_element(parts.begin(), parts.end()) > 0.0);
        RC_ASSERT(std::abs(sum(parts) - area) < 1e-12);
    });
    EXPECT_TRUE(holds);
}

TEST(Polygons, OnesWithoutAreaAreAFanForLaterChecks) {
    const Cells fan{{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(rows(split_polygons(polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}})).simplices), fan);
    EXPECT_EQ(rows(split_polygons(polygon({{0, 0}, {0, 0}, {0, 0}, {0, 0}})).simplices), fan);
    EXPECT_EQ(rows(split_polygons(polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}})).simplices), fan);
    EXPECT_EQ(rows(split_polygons(polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 1)).simplices), fan);
}

TEST(Polygons, RepeatedCornersAreRemovedFromPolygonsAlone) {
    auto mesh = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    mesh.corners = {0, 1, 1, 2, 3, 3, 0, /**/ 0, 1, 1, /**/ 0, 1, 1, 2, /**/ 0, 1, 1, 0};
    mesh.offsets = {0, 7, 10, 14, 18};
    const auto split = split_polygons(mesh);
    EXPECT_EQ(rows(split.simplices), (Cells{{0, 1, 3}, {1, 2, 3}, {0, 1, 1}, {0, 1, 2}}));
    EXPECT_EACH_SAYS(split.warnings, {"1 face", "three corners", "face 3"},
                     {"6 repeated corners", "face 0"}, {"1 polygon", "triangles", "face 0"});
}

TEST(Polygons, VeryLargeOnesNeedAFanFromTheSmallestVertex) {
    std::vector<std::pair<double, double>> saw;
    for (int i = 0; i < 5000; ++i)
        saw.emplace_back(i, i % 2);
    saw.emplace_back(2500, 10000);
    EXPECT_REFUSED(split_polygons(polygon(saw)), "face 0", "5001 corners", "fan", "5000");
}

TEST(Polygons, RefusesNumbersOutOfRange) {
    auto mesh = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    mesh.corners = {0, 1, 2, 0, 2, 4};
    mesh.offsets = {0, 3, 6};
    EXPECT_REFUSED(split_polygons(mesh), "face 1", "vertex 4", "0", "3");
    mesh.offsets = {0, 3, 5};
    EXPECT_REFUSED(split_polygons(mesh), "offsets", "polygons", "6");
}

} // namespace polydec::test::in_polygons
