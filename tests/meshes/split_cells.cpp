// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec::test::in_split_cells {

using Cells = std::vector<std::vector<Index>>;

/// Cubes as hexahedra of the points of kuhn.
Cells hexahedra(Index n) {
    const Index z = 1, y = n + 1, x = y * y;
    Cells cells;
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            for (Index k = 0; k < n; ++k) {
                const Index v = i * x + j * y + k * z;
                cells.push_back(
                    {v, v + x, v + x + y, v + y, v + z, v + x + z, v + x + y + z, v + y + z});
            }
    return cells;
}

/// The hexahedra, or in a third of the columns each as two wedges, in another as six pyramids
/// around a new vertex.
PolygonMesh mixed(Index n) {
    const Mesh grid = kuhn(3, n);
    const Cells cubes = hexahedra(n);
    Points points(grid.points.rows() + static_cast<Eigen::Index>(cubes.size()), 3);
    points.topRows(grid.points.rows()) = grid.points;
    auto next = static_cast<Index>(grid.points.rows());
    Cells cells;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
        const auto& c = cubes[i];
        points.row(next) = 0.5 * (points.row(c[0]) + points.row(c[6]));
        const auto kind = i / static_cast<std::size_t>(n) % 3;
        if (kind == 0)
            cells.push_back(c);
        else if (kind == 1)
            cells.insert(cells.end(), {{c[0], c[1], c[2], c[4], c[5], c[6]},
                                       {c[0], c[2], c[3], c[4], c[6], c[7]}});
        else
            for (const auto& [p, q, r, s] : std::vector<std::array<int, 4>>{{0, 1, 2, 3},
                                                                            {4, 7, 6, 5},
                                                                            {0, 4, 5, 1},
                                                                            {1, 5, 6, 2},
                                                                            {2, 6, 7, 3},
                                                                            {3, 7, 4, 0}})
                cells.push_back({c[p], c[q], c[r], c[s], next});
        ++next;
    }
    return mesh_of(points, cells);
}

/// The same with vertices numbered in random order.
PolygonMesh renumbered(const PolygonMesh& mesh, std::uint64_t seed) {
    const std::vector<Index> number = Random(seed).order(mesh.points.rows());
    PolygonMesh result = mesh;
    for (Index v = 0; v < mesh.points.rows(); ++v)
        result.points.row(number[static_cast<std::size_t>(v)]) = mesh.points.row(v);
    for (Index& corner : result.corners)
        corner = number[static_cast<std::size_t>(corner)];
    return result;
}

TEST(SplitCells, AGridOfHexahedraIsTheKuhnGridBitForBit) {
    for (const Index n : {1, 2, 3}) {
        const Mesh grid = kuhn(3, n);
        const Mesh split = split_cells(mesh_of(grid.points, hexahedra(n)), 3);
        EXPECT_EQ(split.points, grid.points);
        EXPECT_EQ(sorted_rows(split.simplices), sorted_rows(grid.simplices));
        EXPECT_GT(least_determinant(split), 0);
    }
}

TEST(SplitCells, NeighborsAgreeOnTheirFaceWhateverTheNumbers) {
    const PolygonMesh mesh = mixed(3);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Mesh split = split_cells(renumbered(mesh, seed), 3);
        const FacetTally facets = tally_facets(split);
        EXPECT_EQ(facets.boundary, 6 * 9 * 2);
        EXPECT_EQ(facets.branching + facets.clashing, 0);
        EXPECT_NEAR(total_volume(split), 1.0, 1e-12);
        EXPECT_GT(least_determinant(split), 1e-6);
    }
}

TEST(SplitCells, AGridOfBoxesMergesBackToBoxes) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Index n = 3;
        const PolygonMesh boxes = renumbered(mesh_of(kuhn(3, n).points, hexahedra(n)), seed);
        const Discretization made = discretize(split_cells(boxes, 3));
        EXPECT_EQ(sizes(made.complex()), (std::vector<Index>{64, 144, 108, 27}));
    }
}

TEST(SplitCells, SolidsAreConesOverTheFacesWithoutTheirSmallestVertex) {
    const Points points = Points::Random(12, 3);
    for (const auto& [corners, count] :
         std::map<Index, Index>{{4, 1}, {5, 2}, {6, 3}, {8, 6}, {10, 9}, {12, 12}}) {
        std::vector<Index> cell(static_cast<std::size_t>(corners));
        std::iota(cell.begin(), cell.end(), 0);
        const Mesh split = split_cells(mesh_of(points, {cell}), 3);
        EXPECT_EQ(split.simplices.rows(), count) << corners;
        EXPECT_EQ(split.warnings.size(), corners == 4 ? 0U : 1U);
    }
}

TEST(SplitCells, TheOrientationOfASolidInSpaceIsPositive) {
    Points points(6, 3);
    points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1;
    for (const auto& cell : Cells{{0, 1, 2, 3, 4, 5}, {3, 4, 5, 0, 1, 2}, {0, 2, 1, 3, 5, 4}}) {
        const Mesh split = split_cells(mesh_of(points, {cell}), 3);
        EXPECT_GT(least_determinant(split), 0);
        EXPECT_NEAR(total_volume(split), 0.5, 1e-15);
    }
}

TEST(SplitCells, AHexahedronWithCoincidingCornersIsTheWedgeOrPyramidThatItStandsFor) {
    const Points points = kuhn(3, 1).points;
    const std::array<Index, 8> h{0, 4, 6, 2, 1, 5, 7, 3};
    const Mesh wedge = split_cells(mesh_of(points, {{h[0], h[1], h[2], h[4], h[5], h[6]}}), 3);
    const Mesh collapsed =
        split_cells(mesh_of(points, {{h[0], h[1], h[2], h[2], h[4], h[5], h[6], h[6]}}), 3);
    EXPECT_EQ(sorted_rows(collapsed.simplices), sorted_rows(wedge.simplices));
    const Mesh pyramid = split_cells(mesh_of(points, {{h[0], h[1], h[2], h[3], h[4]}}), 3);
    const Mesh peaked =
        split_cells(mesh_of(points, {{h[0], h[1], h[2], h[3], h[4], h[4], h[4], h[4]}}), 3);
    EXPECT_EQ(sorted_rows(peaked.simplices), sorted_rows(pyramid.simplices));
    const Mesh flat = split_cells(mesh_of(points, {{0, 1, 2, 3, 0, 1, 2, 3}, {0, 1, 2, 4}}), 3);
    EXPECT_EQ(flat.simplices.rows(), 1);
    EXPECT_EACH_SAYS(flat.warnings, {"1 solid", "too few", "cell 0"});
}

TEST(SplitCells, TagsFollowAndFacetsAreSplitLikeTheirCells) {
    PolygonMesh mesh = mesh_of(kuhn(3, 2).points, hexahedra(2));
    mesh.tags = {1, 2, 3, 4, 5, 6, 7, 8};
    mesh = renumbered(mesh, 5);
    const Mesh split = split_cells(mesh, 3);
    for (std::size_t i = 0; i < 48; ++i)
        EXPECT_EQ(split.tags[i], static_cast<Index>(i / 6 + 1));

    PolygonMesh bases;
    for (Index cell = 0; cell < 8; ++cell)
        bases.add(mesh.face(cell).first(4));
    bases.tags = {1, 2, 3, 0, 5, 6, 7, 8};
    const TaggedSimplices tagged = pull_tagged(bases, 2);
    EXPECT_EQ(tagged.tags, (std::vector<Index>{1, 1, 2, 2, 3, 3, 5, 5, 6, 6, 7, 7, 8, 8}));
    std::vector<std::vector<Index>> facets;
    for (const auto& cell : sorted_rows(split.simplices))
        for (std::size_t omitted = 0; omitted < 4; ++omitted) {
            facets.push_back(cell);
            facets.back().erase(facets.back().begin() + static_cast<std::ptrdiff_t>(omitted));
        }
    std::sort(facets.begin(), facets.end());
    for (const auto& facet : sorted_rows(tagged.simplices))
        EXPECT_TRUE(std::binary_search(facets.begin(), facets.end(), facet));
}

TEST(SplitCells, RefusesOtherNumbersOfCorners) {
    const Points points = Points::Random(8, 3);
    EXPECT_REFUSED(split_cells(mesh_of(points, {{0, 1, 2, 3}, {0, 1, 2, 3, 4, 5, 6}}), 3), "cell 1",
                   "7 corners", "8");
    EXPECT_REFUSED(split_cells(mesh_of(points, {{0, 1, 2, 8}}), 3), "8", "7");
}

TEST(CubeShapes, have_one_dimension_at_least) {
    for (const int n : {1, 2, 3})
        EXPECT_EQ(std::ssize(cube_shape(n).facets), n == 1 ? 0 : 2 * n);
    for (const int n : {0, -1, 31})
        EXPECT_REFUSED(cube_shape(n), "cube", "1 to 30");
}

TEST(SplitCells, RefusesTagsOfSomeCellsAlone) {
    for (const int dimension : {2, 3}) {
        auto mesh = mesh_of(Points::Random(4, 3), {{0, 1, 2, 3}, {0, 1, 3, 2}});
        mesh.tags = {7};
        EXPECT_REFUSED(split_cells(mesh, dimension), "1 tags", "2 faces");
    }
}

} // namespace polydec::test::in_split_cells
