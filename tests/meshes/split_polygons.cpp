// SPDX-License-Identifier: MIT
#include "meshes/polygon_splitter.h"
#include "tests/meshes/propositions.h"

namespace polydec::test::in_split_polygons {

using Faces = std::vector<std::vector<Index>>;
using Cells = std::vector<std::array<Index, 3>>;

/// The triangles, in the order that they have, each from its smallest vertex.
Cells cells(const Mesh& mesh) {
    Cells result;
    for (Eigen::Index t = 0; t < mesh.simplices.rows(); ++t) {
        std::array<Index, 3> corners{mesh.simplices(t, 0), mesh.simplices(t, 1),
                                     mesh.simplices(t, 2)};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        result.push_back(corners);
    }
    return result;
}

Cells split(const Points& points, const Faces& faces) {
    return cells(split_polygons(mesh_of(points, faces)));
}

Cells sorted(Cells cells) {
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// Random whole numbers from 0 to below `most`.
std::size_t below(Random& random, std::size_t most) {
    return static_cast<std::size_t>(random.point(1)[0] * static_cast<double>(most)) % most;
}

/// A star-shaped polygon with random radii; in R^N, N > 2, bent out of its plane.
Points star(Random& random, Index corners, Index axes, double bend) {
    Points points = Points::Zero(corners, axes);
    for (Index i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const double radius = 0.3 + random.point(1)[0];
        points(i, 0) = radius * std::cos(angle);
        points(i, 1) = radius * std::sin(angle);
        for (Index axis = 2; axis < axes; ++axis)
            points(i, axis) = bend * random.point(1)[0];
    }
    return points;
}

/// A surface of quads, triangles and pentagons in space: a grid with some sides between faces left
/// out, and bent.
PolygonMesh patches(Random& random, Index n) {
    Points points((n + 1) * (n + 1), 3);
    for (Index v = 0; v < points.rows(); ++v) {
        const double x = v % (n + 1) + 0.4 * random.point(1)[0];
        const double y = v / (n + 1) + 0.4 * random.point(1)[0];
        points.row(v) << x, y, 0.2 * random.point(1)[0];
    }
    Faces faces;
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; i += 2) {
            const Index a = j * (n + 1) + i, b = a + n + 1;
            if (below(random, 2) == 0)
                faces.push_back({a, a + 1, a + 2, b + 2, b + 1, b});
            else
                faces.insert(faces.end(), {{a, a + 1, b + 1, b}, {a + 1, a + 2, b + 2, b + 1}});
        }
    return mesh_of(points, faces);
}

Faces faces_of(const PolygonMesh& mesh) {
    Faces faces;
    for (Index f = 0; f < mesh.size(); ++f)
        faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    return faces;
}

double angle(const Points& points, Index i, Index j, Index k) {
    const Vector u = points.row(i) - points.row(j), v = points.row(k) - points.row(j);
    return std::acos(std::clamp(u.dot(v) / (u.norm() * v.norm()), -1.0, 1.0));
}

/// Of each inner edge the corners opposite to it.
std::map<EdgeEnds, std::vector<Index>> opposites(const Cells& cells) {
    std::map<EdgeEnds, std::vector<Index>> result;
    for (const auto& cell : cells)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(cell[(i + 1) % 3], cell[(i + 2) % 3]);
            result[{low, high}].push_back(cell[i]);
        }
    std::erase_if(result, [](const auto& edge) { return edge.second.size() != 2; });
    return result;
}

/// Whether the vertices a, b, c turn left in the plane of the first two axes.
bool turns_left(const Points& points, Index a, Index b, Index c) {
    const auto x = [&](Index v, Index axis) { return points(v, axis) - points(a, axis); };
    return x(b, 0) * x(c, 1) - x(b, 1) * x(c, 0) > 1e-9;
}

/// A closed ring of faces over 0-1-2: two bent quads that share two edges, and two triangles.
const Points five{{-1, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 1}, {0, -1, 1}};
const Faces closed{{0, 1, 2, 3}, {0, 4, 2, 1}, {0, 3, 4}, {2, 4, 3}};

TEST(SplitPolygons, NoFaceRemembersTheCornerItBeginsWith) {
    Random random(3);
    for (int trial = 0; trial < 20; ++trial) {
        const PolygonMesh mesh = patches(random, 6);
        const Faces faces = faces_of(mesh);
        Faces turned = faces;
        for (auto& face : turned)
            std::rotate(face.begin(),
                        face.begin() + static_cast<std::ptrdiff_t>(below(random, face.size())),
                        face.end());
        EXPECT_EQ(split(mesh.points, turned), split(mesh.points, faces));
    }
    // Ties, where rounding would decide: squares and a regular polygon, in every plane.
    for (const Index corners : {4, 6, 100}) {
        Points points(corners, 3);
        for (Index i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            points.row(i) << 7 + std::cos(angle), std::sin(angle), 0.3 * std::cos(angle);
        }
        std::vector<Index> face(static_cast<std::size_t>(corners));
        std::iota(face.begin(), face.end(), 0);
        const Cells first = split(points, {face});
        for (Index i = 1; i < corners; ++i) {
            std::rotate(face.begin(), face.begin() + 1, face.end());
            EXPECT_EQ(split(points, {face}), first);
        }
    }
}

TEST(SplitPolygons, TheOrderAndTheSideOfFacesDoNotMatter) {
    Random random(4);
    const PolygonMesh mesh = patches(random, 8);
    Faces faces = faces_of(mesh);
    const Cells first = sorted(split(mesh.points, faces));
    std::reverse(faces.begin(), faces.end());
    EXPECT_EQ(sorted(split(mesh.points, faces)), first);

    for (auto& face : faces)
        std::reverse(face.begin(), face.end());
    Cells turned = split(mesh.points, faces);
    for (auto& cell : turned)
        std::swap(cell[1], cell[2]);
    EXPECT_EQ(sorted(turned), first);
}

TEST(SplitPolygons, TheUnitDoesNotMatter) {
    Random random(6);
    const PolygonMesh mesh = patches(random, 8);
    const Cells first = split(mesh.points, faces_of(mesh));
    for (const int power : {-900, -300, 300, 900})
        EXPECT_EQ(split(mesh.points * std::ldexp(1.0, power), faces_of(mesh)), first) << power;
    EXPECT_EQ(split(five * 1e234, closed), split(five, closed));
}

TEST(SplitPolygons, TrianglesOfAPlanePolygonAreDelaunay) {
    Random random(5);
    for (int trial = 0; trial < 100; ++trial) {
        const auto corners = static_cast<Index>(4 + below(random, 20));
        const Points points = star(random, corners, 2, 0);
        std::vector<Index> face(static_cast<std::size_t>(corners));
        std::iota(face.begin(), face.end(), 0);
        const Cells cells = split(points, {face});
        ASSERT_EQ(static_cast<Index>(cells.size()), corners - 2);
        for (const auto& [a, b, c] : cells)
            EXPECT_TRUE(turns_left(points, a, b, c));
        for (const auto& [edge, ends] : opposites(cells)) {
            const double sum =
                angle(points, edge[0], ends[0], edge[1]) + angle(points, edge[0], ends[1], edge[1]);
            const bool is_convex = turns_left(points, edge[0], ends[0], ends[1]) !=
                                   turns_left(points, edge[1], ends[0], ends[1]);
            EXPECT_TRUE(!is_convex || sum < std::numbers::pi + 1e-9);
        }
    }
}

TEST(SplitPolygons, ABentQuadHasTheSmallerSumOfOppositeAngles) {
    Random random(6);
    for (int trial = 0; trial < 200; ++trial) {
        const Points points = star(random, 4, 4, 0.3);
        const auto sum = [&](Index i) {
            return angle(points, (i + 3) % 4, i, (i + 1) % 4) +
                   angle(points, (i + 1) % 4, (i + 2) % 4, (i + 3) % 4);
        };
        const Cells cells = split(points, {{0, 1, 2, 3}});
        const auto diagonal = opposites(cells).begin()->first;
        const bool even = diagonal == EdgeEnds{0, 2};
        // Concave quads have one diagonal alone.
        PolygonSplitter splitter(points);
        const std::array<Index, 4> corners{0, 1, 2, 3};
        const std::vector<EdgeEnds> avoided{diagonal};
        splitter.split(corners, avoided);
        if (splitter.diagonals()[0].ends != diagonal) {
            EXPECT_LT(sum(even ? 1 : 0), sum(even ? 0 : 1));
        }
    }
}

TEST(SplitPolygons, TiesGoToTheShorterDiagonalAndThenToTheSmallestVertex) {
    const Points kite{{0, 0}, {1.6, -0.8}, {2, 0}, {1.6, 0.8}}; // on a circle around (1, 0)
    EXPECT_EQ(sorted(split(kite, {{0, 1, 2, 3}})), (Cells{{0, 1, 3}, {1, 2, 3}}));
    const Points square{{1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (const double angle : {0.0, 0.1, 1.0, 2.0}) {
        Eigen::Matrix2d rotation;
        rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        const Points turned = square * rotation;
        const Points far = turned.array() + 1e3;
        for (const Points& points : {turned, far})
            EXPECT_EQ(sorted(split(points, {{2, 3, 0, 1}})), (Cells{{0, 1, 2}, {0, 2, 3}}));
    }
}

TEST(SplitPolygons, TwoQuadsThatShareTwoEdgesDoNotBecomeTheSameTriangleTwice) {
    for (std::size_t first = 0; first < 4; ++first)
        for (std::size_t second = 0; second < 4; ++second) {
            Faces faces = closed;
            std::rotate(faces[0].begin(), faces[0].begin() + static_cast<std::ptrdiff_t>(first),
                        faces[0].end());
            std::rotate(faces[1].begin(), faces[1].begin() + static_cast<std::ptrdiff_t>(second),
                        faces[1].end());
            const Mesh mesh = split_polygons(mesh_of(five, faces));
            const FacetTally facets = tally_facets(mesh);
            EXPECT_EQ(mesh.simplices.rows(), 6);
            EXPECT_EQ(euler_characteristic(mesh), 2);
            EXPECT_EQ(facets.coherent, 9);
            EXPECT_EQ(facets.boundary + facets.branching + facets.clashing, 0);
        }
}

TEST(SplitPolygons, TheQuadKeepsADiagonalThatLosesMoreWithoutIt) {
    Points points = five;
    points.row(3) = Eigen::RowVector3d(0, 1.5, 1); // its quad is better off with 0-2 than the other
    const Cells cells = sorted(split(points, closed));
    EXPECT_EQ(cells, (Cells{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}}));
    Points mirrored = five;
    mirrored.row(4) = Eigen::RowVector3d(0, -1.5, 1);
    EXPECT_EQ(sorted(split(mirrored, closed)),
              (Cells{{0, 1, 3}, {0, 2, 1}, {0, 3, 4}, {0, 4, 2}, {1, 2, 3}, {2, 4, 3}}));
}

TEST(SplitPolygons, NoDiagonalIsAnEdgeOfAnotherFace) {
    // The quad would take 0-2, which a triangle in another plane has.
    const Points points{{0, 0, 0}, {1, -0.5, 0}, {2, 0, 0}, {1, 0.5, 0}, {1, 0, 3}};
    EXPECT_EQ(sorted(split(points, {{0, 1, 2, 3}})), (Cells{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(sorted(split(points, {{0, 1, 2, 3}, {1, 3, 4}})),
              (Cells{{0, 1, 2}, {0, 2, 3}, {1, 3, 4}}));
    // Where all diagonals are taken, the best is left for the checks of the complex.
    EXPECT_EQ(sorted(split(points, {{0, 1, 2, 3}, {1, 3, 4}, {0, 2, 4}})),
              (Cells{{0, 1, 3}, {0, 2, 4}, {1, 2, 3}, {1, 3, 4}}));
}

TEST(SplitPolygons, EqualPolygonsStayEqual) {
    Random random(8);
    const Points points = star(random, 9, 3, 0.1);
    std::vector<Index> face(9);
    std::iota(face.begin(), face.end(), 0);
    std::vector<Index> turned(face.rbegin(), face.rend());
    const Cells once = split(points, {face});
    Cells twice = split(points, {face, turned});
    ASSERT_EQ(twice.size(), 2 * once.size());
    for (std::size_t i = once.size(); i < twice.size(); ++i)
        std::swap(twice[i][1], twice[i][2]);
    EXPECT_EQ(Cells(twice.begin(), twice.begin() + 7), once);
    EXPECT_EQ(Cells(twice.begin() + 7, twice.end()), once);
}

TEST(SplitPolygons, CornersHaveOneCanonicalOrder) {
    Random random(9);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Index> corners(3 + below(random, 8));
        for (Index& corner : corners)
            corner = static_cast<Index>(below(random, 4));
        std::vector<Index> first = corners;
        const bool turned = make_canonical(first);
        const auto is_rotation = [&](const std::vector<Index>& of) {
            std::vector<Index> twice = of;
            twice.insert(twice.end(), of.begin(), of.end());
            return std::search(twice.begin(), twice.end(), first.begin(), first.end()) !=
                   twice.end();
        };
        EXPECT_TRUE(
            is_rotation(turned ? std::vector<Index>(corners.rbegin(), corners.rend()) : corners));
        std::vector<Index> other(corners.rbegin(), corners.rend());
        std::rotate(other.begin(), other.begin() + 1, other.end());
        make_canonical(other);
        EXPECT_EQ(other, first);
        std::vector<Index> back(first.rbegin(), first.rend());
        make_canonical(back);
        EXPECT_EQ(back, first);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            EXPECT_LE(first, corners);
            const std::vector<Index> reversed(corners.rbegin(), corners.rend());
            EXPECT_LE(first, reversed);
        }
    }
}

} // namespace polydec::test::in_split_polygons
