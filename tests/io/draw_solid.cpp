// SPDX-License-Identifier: MIT
#include "io/pictures/upright_view.h"
#include "tests/support/test.h"

namespace polydec::test::in_draw_solid {

using Place = Eigen::Vector3d;
using Keep = std::function<bool(const Vector&)>;

struct Solid {
    const char* name;
    Mesh mesh;
    Keep keep;
    Place eye;
};

bool all_of_it(const Vector&) {
    return true;
}

bool without_a_corner(const Vector& x) {
    return x[0] < 0.5 || x[1] > 0.5 || x[2] < 0.5;
}

std::vector<Solid> solids() {
    const Place high(1, -2, 1.2), low(-0.4, -1, 0.1);
    const Keep slab = [](const Vector& x) { return x[1] > 0.45; };
    return {{"Kuhn", kuhn(3, 4), all_of_it, high},
            {"Kuhn, cut", kuhn(3, 4), without_a_corner, high},
            {"flat boxes, cut", kuhn({3, 3, 3}, {1, 1, 0.1}), without_a_corner, low},
            {"BCC, cut", bcc(2), without_a_corner, high},
            {"BCC, halved", bcc(2), slab, low},
            {"FCC", fcc(2), all_of_it, low},
            {"FCC, cut", fcc(2), without_a_corner, high},
            {"FCC, halved", fcc(2), slab, high}};
}

std::vector<Place> ring(const SolidFaces& faces, Index f) {
    std::vector<Place> places;
    for (const Index corner : faces.polygons.face(f))
        places.push_back(faces.polygons.points.row(corner));
    return places;
}

void reverse(SolidFaces& faces, Index f) {
    auto& [points, corners, offsets, tags] = faces.polygons;
    std::reverse(corners.begin() + offsets[f], corners.begin() + offsets[f + 1]);
}

/// By the divergence theorem, of x / 3.
double enclosed_volume(const SolidFaces& faces) {
    double sum = 0;
    for (Index f = 0; f < faces.polygons.size(); ++f) {
        const auto p = ring(faces, f);
        for (std::size_t i = 1; i + 1 < p.size(); ++i)
            sum += p[0].dot(p[i].cross(p[i + 1])) / 6;
    }
    return sum;
}

Vector kept_volumes(const Discretization& mesh, const Keep& keep) {
    const Points centroids = cell_centroids(mesh, 3);
    Vector volumes = mesh.volumes().primal(3);
    for (Index cell = 0; cell < volumes.size(); ++cell)
        volumes[cell] *= keep(centroids.row(cell).transpose());
    return volumes;
}

TEST(KeptFaces, enclose_the_kept_cells) {
    for (const auto& solid : solids()) {
        const auto mesh = discretize(solid.mesh);
        const double volume = kept_volumes(mesh, solid.keep).sum();
        auto faces = kept_faces(mesh, solid.keep);
        EXPECT_NEAR(enclosed_volume(faces), volume, 1e-13) << solid.name;
        // one that looks inward spoils it
        reverse(faces, faces.polygons.size() - 1);
        EXPECT_GT(std::abs(enclosed_volume(faces) - volume), 1e-4) << solid.name;
    }
}

TEST(KeptFaces, are_those_with_one_kept_cell) {
    for (const auto& solid : solids()) {
        const auto mesh = discretize(solid.mesh);
        const Vector volumes = kept_volumes(mesh, solid.keep);
        Vector kept(volumes.size());
        for (Index cell = 0; cell < kept.size(); ++cell)
            kept[cell] = volumes[cell] > 0;
        const Vector around =
            SparseMatrix(mesh.complex().coboundary(2).cast<double>().cwiseAbs()).transpose() * kept;
        const auto faces = kept_faces(mesh, solid.keep);
        EXPECT_EQ(faces.polygons.size(), (around.array() == 1).count()) << solid.name;
        EXPECT_GT((around.array() == 2).count(), 0) << solid.name;
        for (const Index cell : faces.cells)
            EXPECT_EQ(kept[cell], 1) << solid.name;
    }
}

TEST(KeptFaces, have_the_values_of_the_cells_behind) {
    const auto mesh = discretize(fcc(2));
    const Points centroids = cell_centroids(mesh, 3);
    const Place slope(1, 2, 3);
    const auto faces = kept_faces(mesh, without_a_corner, centroids * slope);
    ASSERT_EQ(faces.values.size(), faces.polygons.size());
    for (Index f = 0; f < faces.polygons.size(); ++f) {
        // the centroid of a convex cell is behind its face
        const auto p = ring(faces, f);
        const Place normal = (p[1] - p[0]).cross(p[2] - p[0]);
        const Place behind = centroids.row(faces.cells[f]);
        EXPECT_LT(normal.dot(behind - p[0]), 0);
        EXPECT_EQ(faces.values[f], (centroids * slope)[faces.cells[f]]);
    }
}

TEST(KeptCells, shrink_towards_their_centroids) {
    for (const auto& solid : solids()) {
        const auto mesh = discretize(solid.mesh);
        const double volume = kept_volumes(mesh, solid.keep).sum();
        for (const double gap : {0.0, 0.25})
            EXPECT_NEAR(enclosed_volume(kept_cells(mesh, solid.keep, gap)),
                        std::pow(1 - gap, 3) * volume, 1e-13)
                << solid.name;
    }
}

/// How far towards the eye the plane of a polygon is at a place of the picture, if the polygon
/// covers it by a margin; NaN if not.
double depth_at(const std::vector<Place>& p, const Place& eye, const Place& at) {
    const Place normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    const double facing = normal.dot(eye);
    if (std::abs(facing) < 1e-9)
        return std::numeric_limits<double>::quiet_NaN();
    const double along = normal.dot(p[0] - at) / facing;
    const Place hit = at + along * eye;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Place edge = p[(i + 1) % p.size()] - p[i];
        if (normal.dot(edge.cross(hit - p[i])) < 1e-6)
            return std::numeric_limits<double>::quiet_NaN();
    }
    return along;
}

/// At how many places of painted polygons another one than the nearest is painted last.
int wrong_places(const SolidFaces& faces, const std::vector<Index>& order, const Place& eye) {
    std::vector<std::vector<Place>> rings;
    for (const Index f : order)
        rings.push_back(ring(faces, f));
    int wrong = 0;
    for (const auto& p : rings) {
        Place mean = Place::Zero();
        for (const Place& corner : p)
            mean += corner / static_cast<double>(p.size());
        for (const Place& corner : p) {
            const Place at = 0.1 * mean + 0.9 * corner;
            double last = std::numeric_limits<double>::quiet_NaN();
            double nearest = -std::numeric_limits<double>::infinity();
            for (const auto& other : rings)
                if (const double depth = depth_at(other, eye, at); !std::isnan(depth)) {
                    last = depth;
                    nearest = std::max(nearest, depth);
                }
            wrong += !(last >= nearest - 1e-9);
        }
    }
    return wrong;
}

TEST(PaintingOrder, leaves_the_nearest_polygon_to_be_seen_everywhere) {
    int wrong_by_faces = 0;
    for (const auto& solid : solids()) {
        const auto mesh = discretize(solid.mesh);
        const SolidView view{.eye = solid.eye};
        const Place eye = solid.eye.normalized();
        const auto surface = kept_faces(mesh, solid.keep);
        EXPECT_EQ(wrong_places(surface, painting_order(surface, view), eye), 0) << solid.name;

        auto cells = kept_cells(mesh, solid.keep, 0.1);
        auto order = painting_order(cells, view);
        EXPECT_EQ(wrong_places(cells, order, eye), 0) << solid.name;
        std::reverse(order.begin(), order.end());
        EXPECT_GT(wrong_places(cells, order, eye), 0) << solid.name;

        // the depth of the faces themselves is not enough
        cells.depth_sites.resize(0, 0);
        wrong_by_faces += wrong_places(cells, painting_order(cells, view), eye);
    }
    EXPECT_GT(wrong_by_faces, 0);
}

TEST(PaintingOrder, leaves_out_what_is_turned_away_if_closed) {
    const auto mesh = discretize(kuhn(3, 2));
    auto cube = kept_faces(mesh, all_of_it);
    EXPECT_EQ(cube.polygons.size(), 24);
    EXPECT_EQ(painting_order(cube).size(), 12U);
    EXPECT_EQ(painting_order(cube, {.eye = Place(0, -1, 0)}).size(), 4U);
    cube.closed = false;
    EXPECT_EQ(painting_order(cube).size(), 24U);
}

TEST(SeenAt, maps_lengths_across_the_view_to_themselves) {
    const SolidView view{.eye = Place(0.3, -1, 0.5), .up = Place(0.1, 0.2, 1)};
    const auto place = [&](const Place& p) {
        const auto [x, y] = seen_at(view, p);
        return Eigen::Vector2d(x, y);
    };
    EXPECT_LE(place(view.eye).norm(), 1e-15);
    EXPECT_NEAR(place(view.up)[0], 0, 1e-15);
    EXPECT_GT(place(view.up)[1], 0);
    const Place p(1, 2, -0.5), along = view.eye.normalized();
    EXPECT_NEAR(place(p).norm(), (p - p.dot(along) * along).norm(), 1e-15);
    // from above and below y is up, and z along y if that is up
    for (const double z : {-2.0, 2.0})
        EXPECT_NEAR(seen_at({.eye = Place(0, 0, z)}, Place(0, 1, 0))[1], 1, 1e-15);
    EXPECT_NEAR(seen_at({.eye = Place(0, 3, 0), .up = Place(0, 1, 0)}, Place(0, 0, 1))[1], 1,
                1e-15);
    // from the front, x runs to the right
    EXPECT_NEAR(seen_at({.eye = Place(0, -1, 0)}, Place(1, 0, 0))[0], 1, 1e-15);
}

double lightness(const std::string& color) {
    const auto part = [&](int i) { return std::stoi(color.substr(1 + 2 * i, 2), nullptr, 16); };
    return 0.299 * part(0) + 0.587 * part(1) + 0.114 * part(2);
}

TEST(ColorMaps, AreDivergingForBothSignsBeyondRoundingAndHaveZeroInTheMiddle) {
    for (const double scale : {1e-300, 1.0, 1e300}) {
        const auto signed_range = color_range(-2 * scale, scale);
        EXPECT_EQ(signed_range.map, ColorMap::diverging);
        EXPECT_EQ(signed_range.low, -2 * scale);
        EXPECT_EQ(signed_range.high, 2 * scale);
        for (const double other : {0.0, 0.5, -1e-9}) {
            const auto range = color_range(other * scale, scale);
            EXPECT_EQ(range.map, ColorMap::sequential) << other;
            EXPECT_EQ(range.low, other * scale);
            EXPECT_EQ(range.high, scale);
            EXPECT_FALSE(range.is_constant);
            EXPECT_EQ(color_range(-scale, -other * scale).map, ColorMap::sequential) << other;
        }
        EXPECT_EQ(color_range(-1e-3 * scale, scale).map, ColorMap::diverging);
        EXPECT_TRUE(color_range(scale, scale * (1 + 1e-9)).is_constant);
    }
    EXPECT_TRUE(color_range(0, 0).is_constant);
}

TEST(SolidViews, HaveTheirAxisUpwardsInThePicture) {
    for (const int up : {0, 1, 2}) {
        const auto view = upright_view(up);
        const auto at = seen_at(view, Eigen::Vector3d::Unit(up));
        EXPECT_NEAR(at[0], 0, 1e-15) << up;
        EXPECT_GT(at[1], 0.5) << up;
        EXPECT_GT(view.eye[up], 0) << up;
    }
    EXPECT_EQ(upright_view(2).eye, SolidView().eye);
    EXPECT_REFUSED(upright_view(3), "axis 3", "expected");
}

TEST(ColorMaps, get_darker_all_the_way_to_their_dark_ends) {
    for (int i = 0; i < 100; ++i) {
        const double t = i / 100.0, next = (i + 1) / 100.0;
        EXPECT_GT(lightness(color_at(ColorMap::sequential, t)),
                  lightness(color_at(ColorMap::sequential, next)));
        const int sign = t < 0.5 ? 1 : -1;
        EXPECT_GT(sign * lightness(color_at(ColorMap::diverging, next)),
                  sign * lightness(color_at(ColorMap::diverging, t)));
    }
    EXPECT_EQ(color_at(ColorMap::sequential, -1), color_at(ColorMap::sequential, 0));
    EXPECT_EQ(color_at(ColorMap::diverging, 2), color_at(ColorMap::diverging, 1));
    EXPECT_NE(color_at(ColorMap::diverging, 0), color_at(ColorMap::diverging, 1));
}

SolidFaces triangle() {
    SolidFaces faces;
    faces.polygons.points = Points::Identity(3, 3);
    faces.polygons.corners = {0, 1, 2};
    faces.polygons.offsets = {0, 3};
    return faces;
}

TEST(DrawSolid, HasColorsOfValuesOfAnyFiniteRange) {
    auto faces = triangle();
    faces.values = Vector::Constant(1, 1e308);
    EXPECT_EQ(to_svg(draw_solid(faces, {.range = SvgPoint{-1e308, 1e308}, .legend = false})),
              to_svg(draw_solid(faces, {.range = SvgPoint{0, 1e308}, .legend = false})));
}

TEST(DrawSolid, paints_each_polygon_of_the_order_and_a_legend) {
    const auto mesh = discretize(kuhn(3, 2));
    const auto plain = kept_faces(mesh, all_of_it);
    EXPECT_EQ(draw_solid(plain).shapes.size(), 12U);
    const auto valued = kept_faces(mesh, all_of_it, Vector::LinSpaced(8, -1, 3));
    EXPECT_EQ(draw_solid(valued, {.legend = false}).shapes.size(), 12U);
    const auto drawing = draw_solid(valued);
    EXPECT_GT(drawing.shapes.size(), 12U);
    // values of both signs have a range with 0 in its middle
    EXPECT_EQ(std::get<SvgText>(drawing.shapes[drawing.shapes.size() - 2]).text, "-3");
    EXPECT_EQ(std::get<SvgText>(drawing.shapes.back()).text, "3");
    EXPECT_NE(to_svg(drawing).find("<polygon"), std::string::npos);

    auto faces = triangle();
    const auto fill = [&] { return std::get<SvgPolygon>(draw_solid(faces).shapes[0]).style.fill; };
    const auto without = fill();
    faces.fills = {"#ff0000"};
    EXPECT_NE(fill(), without);
    EXPECT_EQ(fill().substr(3), "0000");
    faces.fills = {""};
    EXPECT_EQ(fill(), without);
}

TEST(DrawSolidErrors, name_the_polygon) {
    const auto refused = [](auto change) {
        auto faces = triangle();
        change(faces);
        return refusal([&] { draw_solid(faces); });
    };
    EXPECT_EQ(refused([](auto&) {}), "accepted");
    EXPECT_SAYS(refused([](auto& faces) { faces.values = Vector::Ones(2); }), "2 values",
                "1 polygons");
    EXPECT_SAYS(refused([](auto& faces) { faces.depth_sites = Points::Ones(2, 3); }),
                "2 depth sites", "1 polygons");
    EXPECT_SAYS(refused([](auto& faces) { faces.fills = {"red"}; }), "polygon 0", "fill", "color");
    EXPECT_SAYS(refused([](auto& faces) {
                    faces.values = Vector::Constant(1, std::numeric_limits<double>::quiet_NaN());
                }),
                "polygon 0", "value", "NaN");
    EXPECT_SAYS(refused([](auto& faces) {
                    faces.polygons.points(1, 1) = std::numeric_limits<double>::infinity();
                }),
                "polygon 0", "coordinate", "NaN");
    EXPECT_SAYS(refused([](auto& faces) {
                    faces.polygons.offsets = {0, 2, 3};
                }),
                "polygon 0", "three corners");
    EXPECT_SAYS(
        refused([](auto& faces) { faces.polygons.offsets = {0}, faces.polygons.corners = {}; }),
        "no polygons");
    EXPECT_SAYS(refused([](auto& faces) { faces.polygons.points.conservativeResize(3, 2); }),
                "polygons", "2 coordinates", "three");
}

TEST(DrawSolidErrors, name_what_is_wrong_with_the_view) {
    const auto refused = [](const SolidView& view) {
        return refusal([&] {
            auto faces = triangle();
            faces.values = Vector::Ones(1);
            draw_solid(faces, view);
        });
    };
    EXPECT_EQ(refused({}), "accepted");
    EXPECT_SAYS(refused({.eye = Vector::Ones(2)}), "eye", "three", "coordinates");
    EXPECT_SAYS(refused({.up = Vector::Zero(3)}), "'up'", "zero");
    EXPECT_SAYS(refused({.eye = Vector::Zero(3)}), "'eye'", "zero");
    EXPECT_SAYS(refused({.range = SvgPoint{2, 1}}), "range", "2 .. 1", "ascending");
    EXPECT_SAYS(refused({.plain = "blue"}), "plain color", "#rrggbb");
}

TEST(DrawSolidErrors, say_what_is_no_solid) {
    const auto mesh = discretize(kuhn(3, 2));
    EXPECT_REFUSED(kept_faces(discretize(grid(2, 2)), all_of_it), "dimension 2", "2 coordinates",
                   "solid", "3", "3");
    EXPECT_REFUSED(kept_faces(mesh, all_of_it, Vector::Ones(3)), "3 values", "8 merged 3-cells");
    EXPECT_REFUSED(kept_faces(mesh, [](const auto&) { return false; }), "no cell", "keep");
    EXPECT_REFUSED(kept_faces(mesh, {}), "predicate of kept cells", "empty", "function");
    EXPECT_REFUSED(kept_cells(mesh, all_of_it, 1), "gap", "1", "0", "1");
    EXPECT_REFUSED(color_at(ColorMap::diverging, std::nan("")), "NaN", "color");
    EXPECT_REFUSED(seen_at({}, Vector::Ones(2)), "point", "three", "coordinates");
}

} // namespace polydec::test::in_draw_solid
