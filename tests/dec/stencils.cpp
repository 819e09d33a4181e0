// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_stencils {

/// Kuhn grids of 4^n cubes.
class Stencils : public testing::TestWithParam<int> {
protected:
    int n() const { return GetParam(); }
    static int side() { return 4; }
    Merged mesh() const { return make_merged(kuhn(n(), side())); }
};

TEST_P(Stencils, are_those_of_finite_differences_inside_merged_kuhn_grids) {
    const auto grid = mesh();
    const SparseMatrix L = laplacian({grid.P(), grid.volumes}, 0);
    const auto boundary = boundary_cells(grid.P())[0];
    const double h = 1.0 / side();
    Index inner = 0;
    for (Index v = 0; v < grid.P().size(0); ++v) {
        if (boundary[v])
            continue;
        ++inner;
        EXPECT_NEAR(L.row(v).sum() * h * h, 0, 1e-10) << "as many neighbors as the diagonal says";
        for (SparseMatrix::InnerIterator entry(L, v); entry; ++entry) {
            const double distance = (grid.points.row(v) - grid.points.row(entry.col())).norm() / h;
            const double expected = entry.col() == v                ? 2 * n()
                                    : std::abs(distance - 1) < 1e-9 ? -1
                                                                    : 0;
            EXPECT_NEAR(entry.value() * h * h, expected, 1e-11);
        }
    }
    EXPECT_EQ(inner, std::lround(std::pow(side() - 1, n())));
}

TEST_P(Stencils, unmerged_have_zero_stars_in_all_degrees_between_the_ends) {
    const auto grid = mesh();
    for (int k = 1; k < n(); ++k)
        EXPECT_FALSE(star(grid.input_volumes, k).zeros().empty()) << "k = " << k;
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Stencils, testing::Values(1, 2, 3, 4));

} // namespace polydec::test::in_stencils
