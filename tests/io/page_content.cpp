// SPDX-License-Identifier: MIT
#include "io/pages/page_content.h"

#include "io/pages/still_scene.h"
#include "tests/support/test.h"

namespace polydec::test::in_page_content {

using Place = Eigen::Vector3d;

/// A page of a function at vertices or at cells, and how it opens.
struct Opened {
    Page page;
    PageContent content;
    const Opening& opening;

    explicit Opened(Page made) : page(std::move(made)), content(page), opening(content.opening) {}
};

Opened opened(const Discretization& mesh, Side side,
              const std::function<double(const Place&)>& function) {
    const Points sites = side == Side::primal ? cell_centers(mesh, 0) : cell_centers(mesh, 3);
    Vector values(sites.rows());
    for (Index i = 0; i < sites.rows(); ++i)
        values[i] = function(sites.row(i).transpose());
    return Opened(draw_page(mesh, {NamedForm{"f", Cochain{side, 0, values}}}));
}

Cochain x_of_vertices(const Discretization& mesh) {
    return {Side::primal, 0, Vector(cell_centers(mesh, 0).col(0))};
}

/// Largest at a place.
std::function<double(const Place&)> hump(const Place& middle) {
    return [middle](const Place& x) { return std::exp(-20 * (x - middle).squaredNorm()); };
}

TEST(Openings, AreFromASideWhereTheLargestValueIsSeen) {
    const auto sphere = circumcentric(icosphere(3));
    for (const Place& middle : {Place(1, 0, 0), Place(-1, 0, 0), Place(0, 1, 0), Place(0, -1, 0),
                                Place(0.6, 0, 0.8), Place(-0.6, -0.6, 0.5)}) {
        const auto found = opened(sphere, Side::primal, hump(middle));
        EXPECT_GT(Place(found.opening.view.eye).dot(middle), 0) << middle.transpose();
        EXPECT_EQ(found.opening.percent, 100);
        EXPECT_EQ(found.opening.view.up, SolidView().up);
    }
}

TEST(Openings, AreFromBelowWhereNothingElseShowsTheLargestValue) {
    const auto sphere = circumcentric(icosphere(3));
    EXPECT_LT(opened(sphere, Side::primal, hump({0, 0, -1})).opening.view.eye[2], 0);
}

TEST(Openings, PreferTheLargestValueToOneNearlyAsLarge) {
    const auto sphere = circumcentric(icosphere(3));
    const auto front = hump({0, -1, 0}), back = hump({0, 1, 0});
    const auto found =
        opened(sphere, Side::primal, [&](const Place& x) { return 0.97 * front(x) + back(x); });
    EXPECT_GT(found.opening.view.eye[1], 0);
}

/// Wherever its field is largest: the path is the answer.
TEST(Openings, AreFromTheSideThatShowsMostOfAPath) {
    const auto sphere = circumcentric(icosphere(3));
    for (const Place& middle : {Place(1, 0, 0), Place(-1, 0, 0), Place(0, 1, 0), Place(0, -1, 0)}) {
        Page page = opened(sphere, Side::primal, hump(-middle)).page;
        Mesh path;
        path.points = Points(2, 3);
        path.points.row(0) = 1.01 * middle - Place(0, 0, 0.1);
        path.points.row(1) = 1.01 * middle + Place(0, 0, 0.1);
        path.simplices = Simplices{{0, 1}};
        const Points none(0, 3);
        page.arrows.push_back({"f", none, none, path});
        EXPECT_GT(Place(Opened(page).opening.view.eye).dot(middle), 0) << middle.transpose();
    }
}

TEST(Openings, AreAsUsualWhereTheLargestValueIsSeenSo) {
    const auto sphere = circumcentric(icosphere(2));
    const auto constant = opened(sphere, Side::primal, [](const Place&) { return 1; });
    const auto front = opened(sphere, Side::primal, hump({0, -1, 0}));
    const Opened bare(draw_page(sphere));
    for (const auto* each : {&constant, &front, &bare})
        EXPECT_EQ(each->opening.view.eye, SolidView().eye);
}

TEST(Openings, CutSolidsThroughTheLargestValueInside) {
    const auto cube = circumcentric(kuhn(3, 6));
    for (const Side side : {Side::primal, Side::dual})
        for (const double depth : {0.3, 0.5, 0.7}) {
            const auto found = opened(cube, side, hump({0.5, depth, 0.5}));
            EXPECT_LT(found.opening.percent, 100);
            // the cut is towards -y: the part behind the largest value stays
            EXPECT_NEAR(found.opening.percent, 100 * (1 - depth), 18) << depth;
            const PageFaces seen = found.content.visible();
            double nearest = 1;
            for (const Index corner : seen.corners)
                nearest = std::min(
                    nearest,
                    (Place(found.page.grid.points.row(corner)) - Place(0.5, depth, 0.5)).norm());
            EXPECT_LT(nearest, 0.2);
        }
}

TEST(Openings, LeaveSolidsWholeWhoseLargestValueIsOutside) {
    const auto cube = circumcentric(kuhn(3, 4));
    for (const Side side : {Side::primal, Side::dual}) {
        const auto found = opened(cube, side, [](const Place& x) { return x[0] + x[2]; });
        EXPECT_EQ(found.opening.percent, 100);
        EXPECT_EQ(found.content.visible().size(), 6 * 2 * 16);
    }
}

TEST(Openings, CutSolidsWithVectorsInTheirMiddlePart) {
    const auto cube = circumcentric(kuhn(3, 4));
    for (const double depth : {0.0, 0.4, 1.0}) {
        DenseMatrix vectors = DenseMatrix::Zero(cube.complex().size(0), 3);
        const Points sites = cell_centers(cube, 0);
        for (Index i = 0; i < sites.rows(); ++i)
            vectors(i, 0) = hump({0.5, depth, 0.5})(sites.row(i).transpose());
        const Opened found(draw_page(cube, {NamedForm{"v", Side::primal, vectors}}));
        EXPECT_GE(found.opening.percent, 30);
        EXPECT_LE(found.opening.percent, 70);
    }
}

/// A plate that lies down is cut from above, one that stands from the front.
TEST(Openings, CutSolidsWhereThatShowsClearlyMost) {
    for (const bool lies : {true, false}) {
        Mesh plate = kuhn(3, 4);
        plate.points.col(lies ? 2 : 1) *= 0.2;
        const auto mesh = circumcentric(plate);
        const DenseMatrix vectors = DenseMatrix::Ones(mesh.complex().size(0), 3);
        const Opened found(draw_page(mesh, {NamedForm{"v", Side::primal, vectors}}));
        EXPECT_EQ(found.opening.side, lies ? 2 : 4);
    }
}

/// Arrows of a form in the plane have its vectors, and no third coordinate.
TEST(StillScenes, HaveTheVectorsOfPlaneFormsInSpace) {
    const auto square = circumcentric(kuhn(2, 4));
    Page page = draw_page(square, {NamedForm{"w", d(square.complex(), x_of_vertices(square))}});
    const PageContent content(page);
    const StillScene scene = StillScenes(content).at(0);
    ASSERT_EQ(scene.vectors.cols(), 3);
    ASSERT_EQ(scene.vectors.rows(), content.faces.size());
    for (Index i = 0; i < content.faces.size(); ++i)
        EXPECT_LE((Place(scene.vectors.row(i)) - Place(1, 0, 0)).norm(), 1e-12);
}

/// Each face of two tetrahedra on the same vertices has both of them: none is outside.
TEST(Openings, OfSolidsWithoutOutsideDoNotFail) {
    Page page;
    page.grid.points = kuhn(3, 1).points.topRows(4);
    page.grid.points.row(3) << 0, 0, 1;
    page.grid.types = {VtuCell::tetra, VtuCell::tetra};
    page.grid.corners = {0, 1, 2, 3, 0, 1, 2, 3};
    page.grid.offsets = {4, 8};
    page.grid.face_offsets = {-1, -1};
    page.grid.point_data = {vtu_array("f", Vector::LinSpaced(4, 0, 1))};
    page.shown = "f";
    EXPECT_EQ(Opened(page).content.visible().size(), 0);
    EXPECT_GT(to_html(page).size(), 1000U);
}

} // namespace polydec::test::in_page_content
