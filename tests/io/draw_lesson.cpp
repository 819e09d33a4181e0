// SPDX-License-Identifier: MIT
#include "io/pictures/svg_canvas.h"
#include "io/pictures/svg_layout.h"
#include "tests/io/support.h"

#include <regex>

namespace polydec::test::in_draw_lesson {

const DiscretizeOptions unmerged_cells{.criterion = MergeCriterion::none};

/// A chain of edges of several lengths, in two coordinates.
Mesh chain() {
    Mesh mesh{Points(6, 2), Simplices(5, 2), {}};
    mesh.points << 0, 0, 1, 0, 1.3, 0.2, 2.4, 0, 4, 1, 5, 1;
    mesh.simplices << 0, 1, 1, 2, 2, 3, 3, 4, 4, 5;
    return mesh;
}

/// Triangles of which some have their circumcenter outside, and dual edges of negative length.
Mesh obtuse() {
    Mesh mesh{Points(5, 2), Simplices(4, 3), {}};
    mesh.points << 0, 0, 2, 0, 2.2, 1, 0, 1.3, 0.4, 0.5;
    mesh.simplices << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
    return mesh;
}

/// A needle of triangles, whose numbers have no room where they belong.
Mesh needle() {
    Mesh mesh{Points(6, 2), Simplices(4, 3), {}};
    mesh.points << 0, 0, 1, 0, 2, 0, 0, 0.05, 1, 0.05, 2, 0.05;
    mesh.simplices << 0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4;
    return mesh;
}

std::vector<Discretization> plane_meshes() {
    std::vector<Discretization> meshes;
    for (const Mesh& mesh : {grid(3, 2), hexagons(3), well_centered(2), obtuse(), needle()})
        for (const auto& options : {DiscretizeOptions{}, unmerged_cells})
            meshes.push_back(discretize(mesh, options));
    return meshes;
}

template <class Shape>
std::vector<Shape> all_of(const SvgDrawing& drawing, const std::string& color) {
    std::vector<Shape> found;
    for (const auto& shape : drawing.shapes)
        if (const auto* own = std::get_if<Shape>(&shape))
            if (own->style.stroke == color || own->style.fill == color)
                found.push_back(*own);
    return found;
}

/// Positive if counterclockwise.
double area(const std::vector<SvgPoint>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& [ax, ay] = ring[i];
        const auto& [bx, by] = ring[(i + 1) % ring.size()];
        twice += ax * by - ay * bx;
    }
    return twice / 2;
}

double filled_area(const Discretization& mesh, Index vertex, bool centroids) {
    const StructureOptions options{.centroids = centroids, .cell = vertex, .words = false};
    double sum = 0;
    for (const auto& polygon : all_of<SvgPolygon>(draw_structure(mesh, options), "#F0B429"))
        sum += area(polygon.points);
    return sum;
}

/// The boxes of the numbers in a file, in pixels.
std::vector<SvgBox> boxes_of_numbers(const std::string& svg) {
    std::vector<SvgBox> boxes;
    const std::regex text(R"re(<text x="([^"]+)" y="([^"]+)" font-size="([^"]+)" [^>]*>(\d+)<)re");
    for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
        const double x = std::stod((*it)[1]), y = std::stod((*it)[2]), size = std::stod((*it)[3]);
        boxes.push_back(
            box_around({x, y - 0.35 * size}, svg_text_width((*it)[4].str(), size), 0.9 * size));
    }
    return boxes;
}

void expect_disjoint(const std::vector<SvgBox>& boxes, const std::string& about) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(boxes[i].meets(boxes[j])) << about << ", numbers " << j << " and " << i;
}

TEST(DrawLesson, TheFilledAreaIsTheDualVolume) {
    for (const auto& mesh : plane_meshes())
        for (Index v = 0; v < mesh.size(0); ++v)
            EXPECT_NEAR(filled_area(mesh, v, false), mesh.volumes().dual(0)[v], 1e-12) << v;
    for (const Mesh& input : {grid(2, 2), obtuse()}) {
        const auto circumcentric = discretize(input, unmerged_cells);
        const auto barycentric = discretize(input, {.centers = Centers::centroids()});
        for (Index v = 0; v < barycentric.size(0); ++v) {
            const double volume = barycentric.volumes().dual(0)[v];
            EXPECT_NEAR(filled_area(circumcentric, v, true), volume, 1e-12) << v;
            EXPECT_NEAR(filled_area(barycentric, v, false), volume, 1e-12) << v;
        }
    }
}

TEST(DrawLesson, TheBandOfAChainIsAsLongAsTheDualVolume) {
    const auto mesh = discretize(chain());
    for (Index v = 0; v < mesh.size(0); ++v) {
        const auto drawing = draw_structure(mesh, {.cell = v, .words = false});
        double length = 0;
        for (const auto& band : all_of<SvgPolyline>(drawing, "#F2D28B"))
            length += std::hypot(band.points[1][0] - band.points[0][0],
                                 band.points[1][1] - band.points[0][1]);
        EXPECT_NEAR(length, mesh.volumes().dual(0)[v], 1e-12) << v;
    }
}

TEST(DrawLesson, DualEdgesPointWhereTheDualDerivativeCountsTheirEnd) {
    auto meshes = plane_meshes();
    meshes.push_back(discretize(chain()));
    Mesh turned = obtuse(); // not all cells are oriented alike
    turned.simplices.row(1).head(2).reverseInPlace();
    meshes.push_back(discretize(turned));
    for (const auto& mesh : meshes) {
        const int n = mesh.dimension();
        const auto drawing = draw_structure(mesh, {.dual_orientations = true, .words = false});
        std::vector<SvgArrow> arrows;
        for (const auto& shape : drawing.shapes)
            if (const auto* arrow = std::get_if<SvgArrow>(&shape))
                arrows.push_back(*arrow);
        const DenseMatrix ends = dual_derivative(mesh.complex(), 0).toDense();
        const Points centers = cell_centers(mesh, n), middles = cell_centers(mesh, n - 1);
        std::size_t i = 0;
        for (Index cell = 0; cell < mesh.size(n); ++cell)
            for (const auto& [facet, sign] : mesh.complex().incidences(n - 1)[cell]) {
                if (ends(facet, cell) < 0 && ends.row(facet).maxCoeff() > 0)
                    continue;
                const SvgArrow& arrow = arrows.at(i++);
                double along = 0;
                for (int axis = 0; axis < 2; ++axis)
                    along += (arrow.to[axis] - arrow.from[axis]) *
                             (centers(cell, axis) - middles(facet, axis));
                EXPECT_GE(ends(facet, cell) * along, 0);
                EXPECT_TRUE(along != 0 || std::abs(mesh.volumes().dual(n - 1)[facet]) < 1e-9 ||
                            (centers.row(cell) - middles.row(facet)).norm() < 1e-9);
            }
        EXPECT_EQ(i, arrows.size());
    }
}

TEST(DrawLesson, NumbersDoNotOverlap) {
    std::vector<std::pair<std::string, Mesh>> meshes{{"grid", grid(4, 3)},
                                                     {"hexagons", hexagons(3)},
                                                     {"well-centered", well_centered(2)},
                                                     {"obtuse", obtuse()},
                                                     {"needle", needle()},
                                                     {"chain", chain()},
                                                     {"torus", torus(8, 5)},
                                                     {"Moebius band", moebius(12, 2)},
                                                     {"Goldberg", goldberg(2)},
                                                     {"icosphere", icosphere(2)},
                                                     {"flange", flange(8)},
                                                     {"boxes", split_boxes({2, 2})},
                                                     {"Kuhn's cubes", kuhn(3, 2)}};
    for (const auto& [name, input] : meshes)
        for (const auto& options : {DiscretizeOptions{}, unmerged_cells}) {
            const auto mesh = discretize(input, options);
            LessonOptions shown{.explode = mesh.dimension() == 3 ? 0.5 : 0};
            shown.structure.numbers = true;
            shown.structure.view.width = 1400;
            const auto boxes = boxes_of_numbers(to_svg(draw_lesson(mesh, shown)));
            EXPECT_GE(boxes.size(), 4U) << name;
            if (mesh.ambient_dimension() == 2) {
                EXPECT_EQ(std::ssize(boxes),
                          mesh.size(0) + mesh.size(1) + (mesh.dimension() == 2 ? mesh.size(2) : 0));
            }
            expect_disjoint(boxes, name);
        }
}

TEST(DrawBoundary, EntriesAreThoseOfTheBoundary) {
    for (const Mesh& input : {chain(), grid(2, 1), moebius(5, 1), kuhn(3, 1)}) {
        const auto mesh = discretize(input, unmerged_cells);
        for (int k = 1; k <= mesh.dimension(); ++k) {
            std::map<double, std::map<double, std::string>> rows; // by place, from above
            for (const auto& shape : draw_boundary(mesh.complex(), k).shapes)
                if (const auto* text = std::get_if<SvgText>(&shape))
                    if (text->anchor == SvgAnchor::middle)
                        rows[-text->at[1]][text->at[0]] = text->text;
            const DenseMatrix boundary = mesh.complex().boundary(k).toDense().cast<double>();
            ASSERT_EQ(std::ssize(rows), boundary.rows() + 1);
            Index i = -1;
            for (const auto& [y, row] : rows) {
                ASSERT_EQ(std::ssize(row), boundary.cols() + (i < 0 ? 0 : 1));
                Index j = i < 0 ? 0 : -1;
                for (const auto& [x, text] : row) {
                    const std::string expected =
                        i < 0 || j < 0           ? std::to_string(std::max(i, j))
                        : boundary(i, j) == -1.0 ? "\u22121"
                                                 : std::to_string(static_cast<int>(boundary(i, j)));
                    EXPECT_EQ(text, expected) << k << ", " << i << ", " << j;
                    ++j;
                }
                ++i;
            }
        }
    }
    EXPECT_REFUSED(draw_boundary(discretize(grid(2, 2)).complex(), 3), "3-cells", "dimension 2");
    EXPECT_REFUSED(draw_boundary(discretize(grid(9, 9)).complex(), 1), "100 rows", "at most 60");
}

TEST(DrawLesson, CellsMoveApartByAFactorOfTheirDistance) {
    const auto mesh = discretize(kuhn(3, 1), unmerged_cells);
    const SvgDrawing whole = draw_lesson(mesh, {.explode = 1e-12}),
                     apart = draw_lesson(mesh, {.explode = 0.5});
    ASSERT_EQ(whole.shapes.size(), apart.shapes.size());
    for (std::size_t i = 0; i < whole.shapes.size(); ++i) {
        const auto& a = std::get<SvgPolygon>(whole.shapes[i]).points;
        const auto& b = std::get<SvgPolygon>(apart.shapes[i]).points;
        for (std::size_t j = 1; j < a.size(); ++j)
            for (int axis = 0; axis < 2; ++axis)
                EXPECT_NEAR(1.5 * (b[j][axis] - b[0][axis]), a[j][axis] - a[0][axis], 1e-11)
                    << "in the units of the picture";
    }
}

/// What is inside is never seen, whatever the order of painting.
TEST(DrawLesson, SolidsThatAreWholeHaveTheirSurfaceAlone) {
    const auto mesh = discretize(kuhn(3, 2), unmerged_cells);
    EXPECT_EQ(draw_lesson(mesh).shapes.size(), 3 * 8);
}

TEST(DrawLesson, CellsOnOneSphereArePaintedFromFarToNear) {
    for (const int cells : {1, 2}) {
        const auto mesh = discretize(kuhn(3, cells), unmerged_cells);
        const SolidView view;
        const auto faces = kept_cells(
            mesh, [](const Vector&) { return true; }, 0.3);
        std::map<Index, int> first, last;
        int place = 0;
        for (const Index face : painting_order(faces, view)) {
            first.try_emplace(faces.cells[face], place);
            last[faces.cells[face]] = place++;
        }
        const Points centroids = cell_centroids(mesh, 3), middles = cell_centroids(mesh, 2);
        const IncidenceMatrix around = mesh.complex().boundary(3);
        for (Index face = 0; face < mesh.size(2); ++face) {
            std::vector<Index> both;
            for (IncidenceMatrix::InnerIterator it(around, face); it; ++it)
                both.push_back(static_cast<Index>(it.col()));
            if (both.size() != 2)
                continue;
            const auto ends = mesh.pieces().simplices(2);
            const Eigen::RowVector3d a = mesh.points().row(ends(face, 0)),
                                     b = mesh.points().row(ends(face, 1)),
                                     c = mesh.points().row(ends(face, 2));
            Eigen::RowVector3d normal = (b - a).cross(c - a);
            if (normal.dot(centroids.row(both[1]) - centroids.row(both[0])) < 0)
                normal *= -1; // from the first cell to the second
            const double towards = normal.dot(view.eye.transpose());
            if (std::abs(towards) > 1e-9) {
                EXPECT_LT(last.at(both[towards > 0 ? 0 : 1]), first.at(both[towards > 0 ? 1 : 0]));
            }
        }
    }
}

TEST(DrawLesson, BothDualsStandSideBySide) {
    const auto mesh = discretize(obtuse());
    const SvgDrawing both = draw_lesson(mesh, {.structure = {.words = false}, .both_duals = true});
    std::set<std::string> titles;
    for (const auto& shape : both.shapes)
        if (const auto* text = std::get_if<SvgText>(&shape))
            titles.insert(text->text);
    EXPECT_EQ(titles, (std::set<std::string>{"circumcentric dual", "barycentric dual"}));
    double left_end = 0, right_begin = 1e300;
    for (const auto& line : all_of<SvgPolyline>(both, "#C2185B"))
        left_end = std::max(left_end, line.points[0][0]);
    EXPECT_GT(left_end, 0) << "negative dual edges";
    EXPECT_LT(left_end, 720) << "in the first drawing alone";
    for (const auto& polygon : all_of<SvgPolygon>(both, "#E4E9EF"))
        if (polygon.points[0][0] > 720)
            right_begin = std::min(right_begin, polygon.points[0][0]);
    EXPECT_LT(right_begin, 1440);
}

TEST(DrawLesson, RefusesWhatDoesNotFit) {
    const auto refused = [](const Mesh& mesh, const LessonOptions& options) {
        return refusal([&] { draw_lesson(discretize(mesh), options); });
    };
    EXPECT_SAYS(refused(grid(1, 1), {.structure = {.cell = 9}}), "9");
    EXPECT_SAYS(refused(goldberg(1), {.explode = 1}), "dimension 2");
    EXPECT_SAYS(refused(kuhn(3, 1), {.explode = -1}), "-1");
    EXPECT_SAYS(refused(kuhn(3, 1), {.both_duals = true}), "solid");
    EXPECT_SAYS(refused(kuhn(4, 1), {}), "dimension 4");
    std::string hidden = "accepted";
    for (Index v = 0; v < 12 && hidden == "accepted"; ++v)
        hidden = refused(icosphere(1), {.structure = {.cell = v}});
    EXPECT_SAYS(hidden, "turned away");
}

} // namespace polydec::test::in_draw_lesson
