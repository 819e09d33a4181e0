// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_draw_structure {

/// In the plane: squares, hexagons, and triangles of which some have their circumcenter outside.
std::vector<Mesh> plane_meshes() {
    Mesh few{Points(5, 2), Simplices(4, 3), {}};
    few.points << 0, 0, 2, 0, 2.2, 1, 0, 1.3, 0.4, 0.5;
    few.simplices << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
    return {grid(3, 2), hexagons(3), well_centered(2), few};
}

DiscretizeOptions options_of(bool merge) {
    return {.criterion = merge ? MergeOptions{}.criterion : MergeCriterion::none};
}

template <class Shape>
std::vector<Shape> all_of(const SvgDrawing& drawing, const std::string& color = {}) {
    std::vector<Shape> found;
    for (const auto& shape : drawing.shapes)
        if (const auto* own = std::get_if<Shape>(&shape)) {
            if constexpr (requires { own->style; })
                if (!color.empty() && own->style.stroke != color)
                    continue;
            found.push_back(*own);
        }
    return found;
}

double cross_of(SvgPoint a, SvgPoint b, SvgPoint c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The largest cosine between a dual edge and the edge whose center it ends at.
double worst_angle(const Discretization& mesh) {
    const auto drawing = draw_structure(mesh, {.duals = true});
    auto halves = all_of<SvgPolyline>(drawing);
    std::erase_if(halves, [](const SvgPolyline& line) {
        return line.style.stroke != "#0072B2" && line.style.stroke != "#C2185B";
    });
    const Points edges = cell_centers(mesh, 1);
    double worst = 0;
    std::size_t i = 0;
    for (Index cell = 0; cell < mesh.complex().size(2); ++cell)
        for (const auto& [edge, sign] : mesh.complex().incidences(1)[cell]) {
            const auto& ends = halves.at(i++).points;
            EXPECT_NEAR(ends[1][0], edges(edge, 0), 1e-12);
            Eigen::Vector2d along = Eigen::Vector2d::Zero();
            for (const auto& [vertex, end] : mesh.complex().incidences(0)[edge])
                along += end * mesh.points().row(vertex).head(2).transpose();
            const Eigen::Vector2d dual(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
            if (dual.norm() > 1e-9)
                worst = std::max(worst, std::abs(along.dot(dual)) / along.norm() / dual.norm());
        }
    const bool any_negative = mesh.volumes().dual(1).minCoeff() < -1e-12;
    EXPECT_EQ(halves.size(), i + (any_negative ? 2 : 1)) << "and samples beside the words";
    return worst;
}

TEST(DrawStructure, CirclesPassThroughAllCornersOfTheirCells) {
    for (const Mesh& input : plane_meshes())
        for (const bool merge : {true, false}) {
            const auto mesh = discretize(input, options_of(merge));
            const auto circles = all_of<SvgCircle>(draw_structure(mesh, {.circumcircles = true}));
            ASSERT_EQ(std::ssize(circles), mesh.complex().size(2));
            double elsewhere = 1;
            for (Index cell = 0; cell < mesh.complex().size(2); ++cell) {
                const auto& [center, radius, style] = circles[cell];
                const auto own = mesh.merging().vertices(2, cell);
                for (Index v = 0; v < mesh.complex().size(0); ++v) {
                    const double off = std::abs(std::hypot(mesh.points()(v, 0) - center[0],
                                                           mesh.points()(v, 1) - center[1]) -
                                                radius);
                    if (std::find(own.begin(), own.end(), mesh.input().vertex_number(v)) !=
                        own.end())
                        EXPECT_LE(off, 1e-9);
                    else
                        elsewhere = std::min(elsewhere, off);
                }
            }
            EXPECT_TRUE(!merge || elsewhere > 1e-3) << "a vertex of another cell is on a circle";
        }
}

TEST(DrawStructure, DualEdgesAreOrthogonal) {
    for (const Mesh& input : plane_meshes()) {
        EXPECT_LE(worst_angle(discretize(input)), 1e-9);
        EXPECT_LE(worst_angle(discretize(input, options_of(false))), 1e-9);
    }
    EXPECT_GT(worst_angle(discretize(plane_meshes().back(), {.centers = Centers::centroids()})),
              0.1);
}

TEST(DrawStructure, NegativeDualsAreRed) {
    for (const Mesh& input : plane_meshes())
        for (const bool merge : {true, false}) {
            const auto mesh = discretize(input, options_of(merge));
            Index halves = 0;
            for (Index cell = 0; cell < mesh.complex().size(2); ++cell)
                for (const auto& [edge, sign] : mesh.complex().incidences(1)[cell])
                    halves += mesh.volumes().dual(1)[edge] < -1e-12 ? 1 : 0;
            const auto red = all_of<SvgPolyline>(
                draw_structure(mesh, {.duals = true, .words = false}), "#C2185B");
            EXPECT_EQ(std::ssize(red), halves);
            EXPECT_EQ(halves > 0, input.points.rows() == 5);
        }
}

TEST(SideBySide, ShapesAreAsLargeAsAloneAndDoNotMeet) {
    const auto one = draw_structure(discretize(grid(2, 1)), {.circumcircles = true});
    auto other = draw_structure(discretize(hexagons(2)), {.duals = true});
    other.width = 300;
    const SvgDrawing row = side_by_side({one, other});
    ASSERT_EQ(row.shapes.size(), one.shapes.size() + other.shapes.size());
    const auto span = [](auto begin, auto end) {
        double low = 1e300, high = -1e300;
        for (auto shape = begin; shape != end; ++shape)
            if (const auto* polygon = std::get_if<SvgPolygon>(&*shape))
                for (const auto& point : polygon->points) {
                    low = std::min(low, point[0]);
                    high = std::max(high, point[0]);
                }
        return std::pair(low, high);
    };
    const auto middle = row.shapes.begin() + std::ssize(one.shapes);
    const auto first = span(row.shapes.begin(), middle), second = span(middle, row.shapes.end());
    EXPECT_LT(first.second + 20, second.first);
    EXPECT_NEAR(second.second - second.first, 300 - 2 * other.margin, 1e-9);
    EXPECT_EQ(to_svg(row).size(), to_svg(side_by_side({one, other})).size());
    EXPECT_REFUSED(side_by_side({}), "no drawings");
}

TEST(DrawStructure, NumbersEveryCellOnce) {
    for (const Mesh& input : plane_meshes())
        for (const bool merge : {true, false}) {
            const auto mesh = discretize(input, options_of(merge));
            StructureOptions options{.numbers = true};
            options.view.width = 3000;
            std::map<std::string, std::multiset<Index>> found;
            for (const auto& text : all_of<SvgText>(draw_structure(mesh, options)))
                if (text.anchor == SvgAnchor::middle)
                    found[text.color].insert(std::stoi(text.text));
            ASSERT_EQ(found.size(), 3U);
            for (const auto& [color, numbers] : found) {
                const int k = color == "#222222" ? 0 : color == "#B34700" ? 1 : 2;
                std::multiset<Index> wanted;
                for (Index i = 0; i < mesh.complex().size(k); ++i)
                    wanted.insert(i);
                EXPECT_EQ(numbers, wanted) << k;
            }
        }
}

TEST(DrawStructure, ShowsTheEdgesThatWereMergedAway) {
    for (const Mesh& input : plane_meshes()) {
        const auto mesh = discretize(input);
        const Index removed = mesh.pieces().size(1) - mesh.complex().size(1);
        const auto dashed = all_of<SvgPolyline>(draw_structure(mesh), "#D55E00");
        EXPECT_EQ(std::ssize(dashed), removed > 0 ? removed + 1 : 0) << "with one beside the words";
    }
}

TEST(DrawStructure, ArcsTurnAsCellsAreOriented) {
    for (Mesh input : plane_meshes())
        for (const double sign : {1.0, -1.0}) {
            const auto mesh = discretize(input);
            const auto arcs =
                all_of<SvgPolyline>(draw_structure(mesh, {.orientations = true}), "#6F4E9C");
            ASSERT_EQ(std::ssize(arcs), mesh.complex().size(2) + 1);
            for (std::size_t i = 0; i + 1 < arcs.size(); ++i)
                EXPECT_GT(sign * cross_of(arcs[i].points[0], arcs[i].points[5], arcs[i].points[10]),
                          0);
            input.simplices.col(0).swap(input.simplices.col(1));
        }
}

TEST(DrawStructure, OfAClosedSurfaceShowsTheSideTowardsTheEye) {
    const auto mesh = discretize(goldberg(2));
    const auto fronts = all_of<SvgPolygon>(draw_structure(mesh), "#222222");
    EXPECT_LT(std::ssize(fronts), mesh.complex().size(2));
    EXPECT_GE(2 * std::ssize(fronts), mesh.complex().size(2));
    const auto open = discretize(moebius(12, 2));
    EXPECT_EQ(std::ssize(all_of<SvgPolygon>(draw_structure(open), "#222222")),
              open.complex().size(2));
}

TEST(DrawStructure, RefusesWhatItCannotShow) {
    EXPECT_REFUSED(draw_structure(discretize(kuhn(3, 1))), "cells", "dimension 3", "3 coordinates");
    EXPECT_REFUSED(draw_structure(discretize(grid(60, 60)), {.numbers = true}), "7320 edges",
                   "720 pixels");
    const auto flipped =
        discretize(plane_meshes().back(), {.delaunay = Delaunay::flips_and_splits});
    ASSERT_FALSE(flipped.passage().is_identity());
    EXPECT_REFUSED(draw_structure(flipped), "flipped", "straight lines");
}

} // namespace polydec::test::in_draw_structure
