// SPDX-License-Identifier: MIT
//
// Distances on surfaces where more than two triangles meet at edges.
#include "tests/solvers/glued_samples.h"

namespace polydec::test::in_branching_geodesics {

/// Pages of a book, unit squares of n x n cells shaken alike, whose spine is the third axis.
Mesh book(int pages, int n, double shake) {
    std::vector<double> angles;
    for (int page = 0; page < pages; ++page)
        angles.push_back(2 * M_PI * page / pages);
    return book_of(shaken_inside(grid(n, n), shake / n), angles);
}

struct Errors {
    double across, within; ///< means over the other pages and the source's own
    double as_on_one_page; ///< of the other pages, if these were the source's own
};

Errors errors(const Mesh& book, int n, const GeodesicOptions& options = {}) {
    const Index inside =
        n * (n + 1); // vertices of a page that are not on the spine; those are first
    const Index source[] = {static_cast<Index>(n + 1 + (n / 2 - 1) * (n + 1) + n / 4)};
    const Vector d = heat_distance(circumcentric(book), source, options);
    const Vector from_spine = book.points.leftCols(2).rowwise().norm();
    Errors result{};
    double others = 0, own = 0;
    for (Index v = 0; v < d.size(); ++v) {
        const double along = book.points(v, 2) - book.points(source[0], 2);
        const double across = std::hypot(along, from_spine[v] + from_spine[source[0]]),
                     within = std::hypot(along, from_spine[v] - from_spine[source[0]]);
        if (v > n + inside) { // on the other pages
            result.across += std::abs(d[v] - across);
            result.as_on_one_page += std::abs(d[v] - within);
            others += 1;
        } else {
            result.within += std::abs(d[v] - within);
            own += 1;
        }
    }
    return {result.across / others, result.within / own, result.as_on_one_page / others};
}

TEST(BranchingGeodesics, cross_the_spine_of_a_book_straight) {
    ASSERT_NE(refusal([] { GluedSurface(circumcentric(book(3, 4, 0.2)).pieces()); }), "accepted");
    const auto coarse = errors(book(3, 24, 0.25), 24), fine = errors(book(3, 48, 0.25), 48);
    EXPECT_LT(fine.across, 0.03);
    EXPECT_LT(fine.within, 0.01);
    EXPECT_GT(std::log2(coarse.across / fine.across), 0.8);
    EXPECT_GT(std::log2(coarse.within / fine.within), 0.8);
    EXPECT_GT(fine.as_on_one_page, 10 * fine.across);
}

TEST(BranchingGeodesics, are_equal_on_equal_pages) {
    const auto mesh = circumcentric(book(4, 12, 0.25));
    const Index source[] = {static_cast<Index>(13 + 5)};
    const Vector d = heat_distance(mesh, source);
    const Index inside = 12 * 13;
    for (Index i = 0; i < inside; ++i) {
        EXPECT_NEAR(d[13 + inside + i], d[13 + 3 * inside + i], 1e-9);
        EXPECT_NEAR(d[13 + inside + i], d[13 + 2 * inside + i], 1e-9);
    }
    EXPECT_GT(std::abs(d[13 + inside] - d[13]), 1e-3);
}

/// Where no edge has more than two triangles, nothing changes.
TEST(BranchingGeodesics, are_those_of_glued_triangles_where_these_can_be_glued) {
    const auto mesh = circumcentric(book(2, 8, 0.25));
    const Index source[] = {3};
    const Vector glued =
        heat_distance(GluedSurface(mesh.pieces()), mesh.geometry().volumes().primal(1), source);
    EXPECT_EQ(heat_distance(mesh, source), glued);
    EXPECT_REFUSED(GeodesicDistance solver(circumcentric(mesh_named("kuhn3"))), "dimension 3",
                   "surface");
}

} // namespace polydec::test::in_branching_geodesics
