// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_corners {

class Polygons : public OverMeshes {};

using Boundary = std::map<Index, int>; // merged edges and their coefficients

/// The boundary of a merged 2-cell from d^P; edges with the cell on both sides have no entry.
Boundary boundary(const Merged& mesh, Index cell) {
    Boundary result;
    for (IncidenceMatrix::InnerIterator e(mesh.P().coboundary(1), cell); e; ++e)
        result[static_cast<Index>(e.col())] = e.value();
    return result;
}

/// The sum of the edges that a closed walk over vertices passes; nothing if two neighbors in it are
/// not joined by a kept edge.
std::optional<Boundary> walked(const Merged& mesh, const std::vector<Index>& walk) {
    Boundary result;
    for (std::size_t i = 0; i < walk.size(); ++i) {
        const Index a = walk[i], b = walk[(i + 1) % walk.size()];
        bool found = false;
        for (Index e = 0; e < mesh.K().size(1); ++e) {
            const auto ends = mesh.K().simplices(1).row(e);
            const auto& carrier = mesh.merging().carriers(1)[e];
            if (carrier.dimension == 1 && ends[0] == std::min(a, b) && ends[1] == std::max(a, b)) {
                result[carrier.cell] += a < b ? 1 : -1;
                found = true;
            }
        }
        if (!found)
            return std::nullopt;
    }
    std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
    return result;
}

TEST_P(Polygons, corners_walk_along_the_boundary) {
    // edges of surfaces never merge, so a walk over them passes vertices
    for (Index F = 0; mesh().n() == 2 && F < mesh().P().size(2); ++F) {
        const auto walk = corners(mesh().merging(), F);
        EXPECT_EQ(walked(mesh(), walk), boundary(mesh(), F)) << "cell " << F;
    }
}

TEST_P(Polygons, corners_are_the_vertices_each_once_unless_the_cell_touches_itself) {
    for (Index F = 0; mesh().n() >= 2 && F < mesh().P().size(2); ++F) {
        auto walk = corners(mesh().merging(), F);
        std::sort(walk.begin(), walk.end());
        const bool repeats = std::adjacent_find(walk.begin(), walk.end()) != walk.end();
        walk.erase(std::unique(walk.begin(), walk.end()), walk.end());
        EXPECT_EQ(walk, mesh().merging().vertices(2, F)) << "cell " << F;
        EXPECT_EQ(repeats, GetParam() == "spike" && walk.size() == 4) << "cell " << F;
    }
}

TEST_P(Polygons, ascending_vertices_are_no_walk_around_most_merged_polygons) {
    if (GetParam() != "hex4" && GetParam() != "goldberg2" && GetParam() != "grid4")
        return;
    Index failed = 0;
    for (Index F = 0; F < mesh().P().size(2); ++F)
        failed += walked(mesh(), mesh().merging().vertices(2, F)) != boundary(mesh(), F);
    EXPECT_GT(2 * failed, mesh().P().size(2));
}

/// The walk without the ways there and back along an edge.
std::vector<Index> without_spikes(std::vector<Index> walk) {
    for (std::size_t i = 0; i < walk.size();) {
        const std::size_t m = walk.size(), after = (i + 1) % m;
        if (m > 2 && walk[(i + m - 1) % m] == walk[after]) {
            walk.erase(walk.begin() + std::max(i, after));
            walk.erase(walk.begin() + std::min(i, after));
            i = 0;
        } else {
            ++i;
        }
    }
    return walk;
}

/// Both begin with the smallest edge and run as the boundary does, so they are equal as they are.
TEST_P(Polygons, corners_of_a_complex_of_any_cells_are_those_of_the_merging) {
    for (Index F = 0; mesh().n() >= 2 && F < mesh().P().size(2); ++F) {
        const auto known = without_spikes(corners(mesh().merging(), F));
        auto walk = corners(mesh().P(), F);
        EXPECT_EQ(walk, known) << "cell " << F;
        std::swap(walk[0], walk[1]);
        EXPECT_NE(walk, known) << "cell " << F;
    }
}

TEST_P(Polygons, corners_of_simplices_are_their_vertices) {
    for (Index F = 0; mesh().n() >= 2 && F < mesh().K().size(2); ++F) {
        auto walk = corners(mesh().K(), F);
        std::sort(walk.begin(), walk.end());
        const auto row = mesh().K().simplices(2).row(F);
        EXPECT_EQ(walk, std::vector<Index>(row.begin(), row.end())) << "triangle " << F;
    }
}

POLYDEC_OVER_MESHES(Polygons);

/// One cell whose boundary passes edges, given by their ends, in the direction that they have.
CellComplex one_cell(Index vertices, const std::vector<std::pair<Index, Index>>& edges) {
    const auto count = static_cast<Index>(edges.size());
    IncidenceMatrix ends(count, vertices), sides(1, count);
    for (Index e = 0; e < count; ++e) {
        ends.insert(e, edges[e].first) = -1;
        ends.insert(e, edges[e].second) = 1;
        sides.insert(0, e) = 1;
    }
    return CellComplex({ends, sides});
}

TEST(CornersOfAnyCell, are_refused_by_name_where_the_boundary_is_no_simple_circle) {
    EXPECT_EQ(corners(one_cell(4, {{2, 0}, {3, 1}, {0, 3}, {1, 2}}), 0),
              (std::vector<Index>{2, 0, 3, 1}));
    const auto figure_eight = one_cell(5, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}});
    const auto two_circles = one_cell(6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}});
    const CellComplex point_of_cancelled_edges({IncidenceMatrix(2, 1), IncidenceMatrix(1, 2)},
                                               {{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}});
    for (const auto& complex :
         {figure_eight, two_circles, point_of_cancelled_edges, cell_complex(square_torus()),
          cell_complex(folded_triangle()), cell_complex(moebius_triangle())}) {
        EXPECT_REFUSED(corners(complex, 0), "2-cell 0", "closed path");
        try {
            corners(complex, 0);
        } catch (const InvalidInput& error) {
            EXPECT_EQ(error.place().degree, 2);
            EXPECT_EQ(error.place().cells, std::vector<Index>{0});
        }
    }
}

TEST(Corners, start_with_the_smallest_edge) {
    const auto& mesh = merged("grid4");
    for (Index F = 0; F < mesh.P().size(2); ++F) {
        const auto walk = corners(mesh.merging(), F);
        const Index smallest = IncidenceMatrix::InnerIterator(mesh.P().coboundary(1), F).col();
        const auto ends = mesh.merging().vertices(1, smallest);
        EXPECT_EQ(std::minmax(walk[0], walk[1]), std::minmax(ends[0], ends[1]));
    }
}

TEST(Corners, of_the_spike_pass_the_edge_inside_it_twice) {
    const auto& mesh = merged("spike");
    ASSERT_EQ(mesh.P().size(2), 2);
    std::vector<std::size_t> lengths;
    for (Index F = 0; F < 2; ++F)
        lengths.push_back(corners(mesh.merging(), F).size());
    std::sort(lengths.begin(), lengths.end());
    EXPECT_EQ(lengths, (std::vector<std::size_t>{3, 5}));
}

/// A strip of triangles wound around a tube so thin that flipped edges close to loops. The numbers
/// of vertices are those of `order`.
Mesh thin_tube(const std::vector<Index>& order) {
    const auto vertices = static_cast<Index>(order.size());
    Mesh mesh{Points(vertices, 3), Simplices(2 * (vertices - 3), 3), {}};
    for (Index i = 0; i < vertices; ++i)
        mesh.points.row(order[i]) << std::cos(2.3 * i), std::sin(2.3 * i), 4.0 * i;
    for (Index i = 0; i + 3 < vertices; ++i) {
        mesh.simplices.row(2 * i) << order[i], order[i + 1], order[i + 3];
        mesh.simplices.row(2 * i + 1) << order[i], order[i + 3], order[i + 2];
    }
    return mesh;
}

TEST(Corners, of_triangles_with_loops_are_theirs) {
    Index loops = 0;
    for (const auto& order : {std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                              {4, 1, 2, 3, 0, 5, 6, 7, 8, 9},
                              {9, 3, 5, 1, 8, 0, 2, 7, 6, 4}}) {
        const auto mesh = discretize(thin_tube(order), {.criterion = MergeCriterion::none,
                                                        .delaunay = Delaunay::flips,
                                                        .star = StarKind::circumcentric});
        for (Index t = 0; t < mesh.size(2); ++t) {
            auto walk = corners(mesh.merging(), t);
            const auto row = mesh.pieces().simplices(2).row(t);
            std::vector<Index> known(row.begin(), row.end());
            std::sort(walk.begin(), walk.end());
            std::sort(known.begin(), known.end());
            EXPECT_EQ(walk, known) << "triangle " << t;
            loops += std::adjacent_find(known.begin(), known.end()) != known.end() ? 1 : 0;
        }
    }
    EXPECT_GT(loops, 30);
}

TEST(Corners, of_merged_triangles_with_loops_are_as_many_as_sides) {
    // a flat cylinder of circumference 1 with vertex i at (i/2, i/2): squares i-1, i, i+1, i
    constexpr double rise = 0.50001;
    Index squares = 0;
    for (const std::vector<Index>& order :
         {std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7}, {1, 2, 3, 4, 0, 5, 6, 7}}) {
        LengthMesh tube = length_mesh(thin_tube(order));
        std::vector<Index> place(order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            place[order[i]] = static_cast<Index>(i);
        for (Index e = 0; e < tube.edges.rows(); ++e) {
            const Index steps = std::abs(place[tube.edges(e, 0)] - place[tube.edges(e, 1)]);
            tube.lengths[e] = std::hypot(steps % 2 == 0 ? 0 : 0.5, steps * rise);
        }
        const auto mesh =
            discretize(tube, {.delaunay = Delaunay::flips, .star = StarKind::circumcentric});
        for (Index cell = 0; cell < mesh.size(2); ++cell) {
            std::size_t sides = 0;
            for (const Index piece : mesh.merging().pieces_of(2, cell))
                for (const auto& [edge, sign] : mesh.pieces().incidences(1)[piece])
                    sides += mesh.merging().carriers(1)[edge].dimension == 1 ? 1 : 0;
            EXPECT_EQ(corners(mesh.merging(), cell).size(), sides) << "cell " << cell;
            squares += sides == 4 ? 1 : 0;
        }
    }
    EXPECT_GT(squares, 4);
}

TEST(Spike, has_an_edge_with_two_cofaces_and_no_coefficient) {
    const auto& mesh = merged("spike");
    Index found = 0;
    for (Index e = 0; e < mesh.P().size(1); ++e) {
        if (mesh.merging().vertices(1, e) != std::vector<Index>{2, 3})
            continue;
        ++found;
        EXPECT_EQ(mesh.P().coface_counts(1)[e], 2);
        EXPECT_EQ(IncidenceMatrix(mesh.P().boundary(2).row(e)).nonZeros(), 0);
    }
    EXPECT_EQ(found, 1);
}

} // namespace polydec::test::in_corners
