// SPDX-License-Identifier: MIT
//
// Pages without a browser: which triangles and lines they show, what they refuse, and that they
// hold what they were given. What a browser makes of them is tested in tests/pages.
#include "io/pages/page_content.h"
#include "io/pages/page_faces.h"
#include "io/pages/page_text.h"
#include "io/xml_text.h"
#include "tests/io/support.h"
#include "tests/io/svg_text.h"

namespace polydec::test::in_pages {

using Side2 = std::pair<Index, Index>;

/// Of how many sides, each counted once, a kind of line is.
std::set<Side2> sides_of_kind(const PageFaces& faces, Index kind) {
    std::set<Side2> sides;
    for (Index i = 0; i < 3 * faces.size(); ++i)
        if ((faces.sides[i / 3] >> 2 * (i % 3) & 3) == kind) {
            const Index a = faces.corners[i], b = faces.corners[i % 3 < 2 ? i + 1 : i - 2];
            sides.emplace(std::min(a, b), std::max(a, b));
        }
    return sides;
}

bool is_drawable(const Mesh& mesh) {
    return mesh.simplices.cols() >= 3 && mesh.simplices.cols() <= 4 && mesh.points.cols() <= 3;
}

/// The pieces of degree 1 on triangles that are seen, which lie in cells of this dimension or more.
std::set<Side2> pieces_in(const Merging& merging, int least, int most) {
    const auto& K = merging.pieces();
    std::set<Side2> sides;
    for (Index t = 0; t < K.size(2); ++t)
        for (int i = 0; i < 3 && merging.carriers(2)[t].dimension == 2; ++i) {
            const Index e = K.face(2, t, i);
            const int dimension = merging.carriers(1)[e].dimension;
            if (dimension >= least && dimension <= most)
                sides.emplace(K.vertex_number(K.simplices(1)(e, 0)),
                              K.vertex_number(K.simplices(1)(e, 1)));
        }
    return sides;
}

Page simple_page() {
    Page page;
    page.text.title = "two triangles";
    page.grid.points = Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<Index> first{0, 1, 2}, second{0, 2, 3};
    add_cell(page.grid, VtuCell::triangle, first);
    add_cell(page.grid, VtuCell::triangle, second);
    page.grid.point_data.push_back({"u", std::vector<double>{0, 0.25, 0.5, 1}});
    return page;
}

std::string page_error(const Page& page) {
    return refusal([&] { to_html(page); });
}

TEST(Pages, RefuseVectorsWhoseLengthsOverflow) {
    Page page = simple_page();
    page.grid.point_data.push_back({"far", std::vector<double>(12, 1.7e308), 3});
    EXPECT_REFUSED(to_html(page), "vectors `far`", "finite");
}

TEST(Pages, ShowEveryEdgeOfTheMergedCellsAndEveryOneThatWasMergedAway) {
    int seen = 0, merged_away = 0;
    for (const auto& [name, mesh] : test::meshes()) {
        if (!is_drawable(mesh))
            continue;
        const auto made = discretize(mesh);
        const auto faces = page_faces(made.merging());
        EXPECT_EQ(sides_of_kind(faces, PageFaces::edge), pieces_in(made.merging(), 1, 1)) << name;
        const auto removed = sides_of_kind(faces, PageFaces::removed);
        EXPECT_EQ(removed, pieces_in(made.merging(), 2, 3)) << name;
        ++seen;
        merged_away += removed.empty() ? 0 : 1;
    }
    EXPECT_GT(seen, 5);
    EXPECT_GT(merged_away, 3);
}

TEST(Pages, NameTheCellsOnBothSidesOfEachTriangle) {
    for (const auto& [name, mesh] : test::meshes()) {
        if (!is_drawable(mesh))
            continue;
        const auto made = discretize(mesh);
        const int n = made.dimension();
        const auto faces = page_faces(made.merging());
        std::vector<Index> around(static_cast<std::size_t>(made.complex().size(n)), 0);
        for (Index t = 0; t < faces.size(); ++t) {
            for (const Index cell : faces.owners[t])
                if (cell >= 0)
                    ++around[cell];
            if (n == 3) {
                std::vector<Index> both;
                for (const Index cell : faces.owners[t])
                    for (const SignedFace& f :
                         made.complex().incidences(2)[std::max<Index>(cell, 0)])
                        if (cell >= 0 && f.face == faces.faces[t])
                            both.push_back(cell);
                EXPECT_EQ(std::count(faces.owners[t].begin(), faces.owners[t].end(), -1) +
                              static_cast<std::ptrdiff_t>(both.size()),
                          2)
                    << name << ", triangle " << t;
            }
        }
        EXPECT_GT(*std::min_element(around.begin(), around.end()), 0) << name;
    }
}

TEST(Pages, ShowAGridAsItsMesh) {
    for (const auto& [name, mesh] : test::meshes()) {
        if (!is_drawable(mesh) || !test::is_flat(mesh))
            continue;
        const auto made = discretize(mesh);
        const auto own = page_faces(made.merging());
        const auto drawn = page_faces(draw_cells(made, made.dimension()));
        EXPECT_EQ(sides_of_kind(own, PageFaces::edge), sides_of_kind(drawn, PageFaces::edge))
            << name;
        EXPECT_TRUE(sides_of_kind(drawn, PageFaces::removed).empty()) << name;
    }
}

TEST(Pages, AreTheSameForTheSame) {
    const auto page = simple_page();
    const auto html = to_html(page);
    EXPECT_EQ(html, to_html(page));
    auto other = page;
    std::get<std::vector<double>>(other.grid.point_data[0].values)[2] = 0.75;
    EXPECT_NE(html, to_html(other));
}

TEST(Pages, KeepHostileWordsAsText) {
    const std::string hostile = "</script><script>alert(1)</script>\"'&{{data}}\x1b[31m";
    auto page = simple_page();
    page.text = {.title = hostile,
                 .command = hostile,
                 .facts = {hostile},
                 .warnings = {hostile},
                 .table = {{hostile}, {{hostile}}, {hostile}, hostile}};
    page.grid.point_data[0].name = page.shown = hostile.substr(0, hostile.find('\x1b'));
    page.grid.point_data[0].about = hostile;
    const auto plain = to_html(simple_page()), html = to_html(page);
    EXPECT_EQ(count(html, "<script"), count(plain, "<script"));
    EXPECT_EQ(count(html, "</script"), count(plain, "</script"));
    EXPECT_EQ(html.find('\x1b'), std::string::npos);
    EXPECT_GT(count(html, "&lt;/script&gt;&lt;script&gt;alert(1)"), 5U);
    EXPECT_EQ(json_text("</a>\"\\\n\x01"), "\"\\u003c/a\\u003e\\u0022\\u005c\\u000a\\u005cx01\"");
}

TEST(Pages, HaveTheAxisUpwardsOfTheirFileUnlessToldOtherwise) {
    const auto up_of = [](const PageText& text) {
        auto page = simple_page();
        page.text = text;
        return upward_axis(page);
    };
    for (const char* name : {"a.obj", "A.OBJ", "a.ply", "a.off"})
        EXPECT_EQ(up_of({.file = name}), 1) << name;
    for (const char* name : {"a.stl", "a.msh", "a.vtk", "a.nsc", ""})
        EXPECT_EQ(up_of({.file = name}), 2) << name;
    EXPECT_EQ(up_of({.file = "a.obj", .up = 0}), 0);
    auto page = simple_page();
    page.text.up = 0;
    EXPECT_EQ(count(to_html(page), "\"up\":0"), 1U);
    page.text.up = 3;
    EXPECT_SAYS(page_error(page), "axis 3", "expected");
}

TEST(Pages, NameTheUnitsOfTheirFields) {
    auto page = simple_page();
    page.grid.point_data[0].about = "areas, in units of length^2, of cells";
    EXPECT_EQ(count(to_html(page), "\"unit\":\"length^2\""), 1U);
    page.text.length_unit = "mm";
    EXPECT_EQ(count(to_html(page), "\"unit\":\"mm^2\""), 1U);
    page.text.length_unit = "";
    page.grid.point_data[0].about = "areas";
    EXPECT_EQ(count(to_html(page), "\"unit\":\"length^2\""), 0U);
}

TEST(Pages, AreBoundIntoAnAlbum) {
    auto second = simple_page();
    second.text.title = "b <&\"";
    const std::vector<std::string> pages{to_html(simple_page()), to_html(second)};
    const auto album = album_html("both", pages);
    EXPECT_EQ(count(album, "<iframe"), 2U);
    EXPECT_EQ(count(album, "<script"), 0U) << "they stand in attributes, as text";
    EXPECT_EQ(count(album, "srcdoc=\"" + xml_escaped(pages[1]) + "\""), 1U);
    EXPECT_EQ(count(album, "<a id=\"to-1\" href=\"#page-1\"><img alt=\"\" src=\"data:image/png;"),
              1U);
    EXPECT_EQ(count(album, "<strong>b &lt;&amp;&quot;</strong> The mesh: 2 cells."), 1U);
    EXPECT_REFUSED(album_html("none", {}), "album", "pages");
    EXPECT_REFUSED(album_html("a", {pages[0], "<html><title>x</title></html>"}), "page 1", "album",
                   "write_page");
    EXPECT_REFUSED(album_html("a", {pages[0], album}), "page 1", "is an album", "pages");
}

TEST(Pages, RefuseWhatDoesNotFit) {
    auto page = simple_page();
    page.steps = {{page.grid, "0"}, {page.grid, "1"}};
    EXPECT_EQ(page_error(page), "accepted");
    page.steps[1].point_data[0].name = "v";
    EXPECT_SAYS(page_error(page), "step 1", "page", "arrays");
    page = simple_page();
    page.arrows.push_back({"u", Points::Zero(3, 2), Points::Zero(2, 2)});
    EXPECT_SAYS(page_error(page), "2 vectors", "3 sites", "u");
    page = simple_page();
    page.grid.corners[1] = 7;
    EXPECT_NE(page_error(page), "accepted");
    page = simple_page();
    std::get<std::vector<double>>(page.grid.point_data[0].values)[0] =
        std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(page_error(page), "accepted");
}

TEST(Pages, OfAFileHoldWhatItHolds) {
    const TemporaryFolder folder;
    auto grid = simple_page().grid;
    grid.cell_data.push_back({"vectors", std::vector<double>{1, 2, 3, 4, 5, 6}, 3});
    write_vtu(folder.path("a.vtu"), grid);
    const auto found = read_grid(folder.path("a.vtu"));
    EXPECT_EQ(found.types, grid.types);
    EXPECT_EQ(found.corners, grid.corners);
    EXPECT_EQ(found.points.leftCols(2), grid.points);
    ASSERT_EQ(found.point_data.size(), 1U);
    EXPECT_EQ(found.point_data[0].values, grid.point_data[0].values);
    EXPECT_EQ(found.cell_data.at(0).values, grid.cell_data[0].values);
    EXPECT_EQ(found.cell_data[0].components, 3);

    folder.write("a.pvd",
                 "<VTKFile type=\"Collection\"><Collection>"
                 "<DataSet timestep=\"0.5\" part=\"0\" file=\"a.vtu\"/>"
                 "<DataSet timestep=\"2\" part=\"0\" file=\"a.vtu\"/></Collection></VTKFile>");
    const auto series = read_series(folder.path("a.pvd"));
    ASSERT_EQ(series.steps.size(), 2U);
    EXPECT_EQ(series.steps[1].time, "2");
    EXPECT_EQ(series.steps[1].point_data[0].values, grid.point_data[0].values);
}

} // namespace polydec::test::in_pages
