// SPDX-License-Identifier: MIT
//
// Distances on surfaces where more than two triangles meet at edges.
#include "tests/solvers/heat_distance.h"

namespace polydec::test::in_branching_geodesics {

/// Pages of a book, unit squares of n x n cells along one spine, the second axis. Row 0 of
/// `places` are the distances from the spine, row 1 heights; the pages of vertices are numbered.
struct Book {
    Mesh mesh;
    DenseMatrix places;
    std::vector<int> page;
};

Book book(int pages, int n, double shake) {
    Book result;
    const Index inside = n * (n + 1); // vertices of a page that are not on the spine
    const auto number = [&](int page, int i, int j) {
        return static_cast<Index>(i == 0 ? j : n + 1 + page * inside + (i - 1) * (n + 1) + j);
    };
    const Index size = n + 1 + pages * inside;
    result.mesh.points.resize(size, 3);
    result.mesh.simplices.resize(pages * 2 * n * n, 3);
    result.places.resize(2, size);
    result.page.resize(size);
    Index t = 0;
    for (int page = 0; page < pages; ++page) {
        Random random(7); // all pages alike
        const double angle = 2 * M_PI * page / pages;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j) {
                const bool moves = i > 0 && i < n && j > 0 && j < n;
                const Vector by = random.direction(2) * (moves ? shake / n : 0);
                const Index v = number(page, i, j);
                const double x = double(i) / n + by[0], y = double(j) / n + by[1];
                result.places.col(v) << x, y;
                result.page[v] = page;
                result.mesh.points.row(v) << x * std::cos(angle), y, x * std::sin(angle);
                if (i == n || j == n)
                    continue;
                const Index a = v, b = number(page, i + 1, j), c = number(page, i + 1, j + 1),
                            d = number(page, i, j + 1);
                result.mesh.simplices.row(t++) << a, b, c;
                result.mesh.simplices.row(t++) << a, c, d;
            }
    }
    return result;
}

struct Errors {
    double across, within; ///< means over the other pages and the source's own
    double as_on_one_page; ///< of the other pages, if these were the source's own
};

Errors errors(const Book& book, const GeodesicOptions& options = {}) {
    const auto mesh = circumcentric(book.mesh);
    const int n = static_cast<int>(std::lround(std::sqrt(book.mesh.simplices.rows() / 6)));
    const Index source[] = {static_cast<Index>(n + 1 + (n / 2 - 1) * (n + 1) + n / 4)};
    const Vector d = heat_distance(mesh, source, options);
    const Eigen::Vector2d from = book.places.col(source[0]);
    Errors result{};
    double others = 0, own = 0;
    for (Index v = 0; v < d.size(); ++v) {
        const double along = book.places(1, v) - from[1], x = book.places(0, v);
        const double across = std::hypot(along, x + from[0]),
                     within = std::hypot(along, x - from[0]);
        if (book.page[v] != book.page[source[0]]) {
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
    ASSERT_NE(refusal([] { GluedSurface(circumcentric(book(3, 4, 0.2).mesh).pieces()); }),
              "accepted");
    const auto coarse = errors(book(3, 24, 0.25)), fine = errors(book(3, 48, 0.25));
    EXPECT_LT(fine.across, 0.03);
    EXPECT_LT(fine.within, 0.01);
    EXPECT_GT(std::log2(coarse.across / fine.across), 0.8);
    EXPECT_GT(std::log2(coarse.within / fine.within), 0.8);
    EXPECT_GT(fine.as_on_one_page, 10 * fine.across);
}

TEST(BranchingGeodesics, are_equal_on_equal_pages) {
    const auto pages = book(4, 12, 0.25);
    const auto mesh = circumcentric(pages.mesh);
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
    const auto mesh = circumcentric(book(2, 8, 0.25).mesh);
    const Index source[] = {3};
    const Vector glued =
        heat_distance(GluedSurface(mesh.pieces()), mesh.geometry().volumes().primal(1), source);
    EXPECT_EQ(heat_distance(mesh, source), glued);
    EXPECT_REFUSED(GeodesicDistance solver(circumcentric(mesh_named("kuhn3"))), "dimension 3",
                   "surface");
}

} // namespace polydec::test::in_branching_geodesics
