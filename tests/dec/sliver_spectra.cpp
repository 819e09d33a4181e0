// SPDX-License-Identifier: MIT
//
// Laplacians of every degree on cubes that slivers are pieces of: those of a grid whose eigenvalues
// are known.
#include "tests/support/slivers.h"
#include "tests/support/test.h"

namespace polydec::test::in_sliver_spectra {

constexpr int m = 3;
constexpr std::array jitters{0.0, 1e-12, 1e-8, 1e-5, 3e-5};

/// Of k-forms on m^3 cubes of edge 1. Along an axis functions at the points have the eigenvalues
/// 2 (1 - cos(pi i / m)), i = 0 .. m, and forms on the edges those above 0. Products of three of
/// these, k of which are forms, are eigenforms for the sum.
Vector exact_eigenvalues(int k) {
    std::vector<double> sums;
    for (int forms = 0; forms < 8; ++forms) {
        const auto first = [&](int axis) { return forms >> axis & 1; };
        if (first(0) + first(1) + first(2) != k)
            continue;
        const auto of_axis = [](int i) { return 2 * (1 - std::cos(M_PI * i / m)); };
        for (int x = first(0); x <= m; ++x)
            for (int y = first(1); y <= m; ++y)
                for (int z = first(2); z <= m; ++z)
                    sums.push_back(of_axis(x) + of_axis(y) + of_axis(z));
    }
    std::sort(sums.begin(), sums.end());
    return Eigen::Map<Vector>(sums.data(), static_cast<Index>(sums.size()));
}

/// All of them, in units of the edges; dual (3-k)-forms that vanish on the boundary have the same.
Vector eigenvalues(const Discretization& mesh, int k) {
    return extended_eigenvalues(mesh.complex(), mesh.stars(), k).cast<double>() / (m * m);
}

double relative_error(const Vector& found, const Vector& exact) {
    return found.size() == exact.size()
               ? (found - exact).cwiseAbs().cwiseQuotient((exact.array() + 1).matrix()).maxCoeff()
               : INFINITY;
}

TEST(SpectraOfSlivers, are_those_of_cubes_in_every_degree) {
    for (const double jitter : jitters) {
        const auto mesh = discretize(delaunay_grid(m, jitter));
        for (int k = 0; k <= 3; ++k)
            EXPECT_LE(relative_error(eigenvalues(mesh, k), exact_eigenvalues(k)),
                      5 * jitter + 1e-12)
                << k << ' ' << jitter;
        const auto condition = [&](int degree) {
            const Vector star = mesh.stars()[degree].diagonal();
            return star.maxCoeff() / star.minCoeff();
        };
        const double both = 2 * (5 * jitter + 1e-12); // the largest and the smallest entry
        EXPECT_NEAR(condition(3), 1, both) << jitter;
        EXPECT_NEAR(condition(1), 4, 4 * both) << jitter;
    }
}

TEST(SpectraOfSliversBroken, by_jitter_above_the_tolerance_are_others) {
    const auto mesh = discretize(delaunay_grid(m, 1e-3));
    EXPECT_EQ(relative_error(eigenvalues(mesh, 3), exact_eigenvalues(3)), INFINITY);
    EXPECT_GT(relative_error(exact_eigenvalues(1).array() + 1e-2, exact_eigenvalues(1)), 1e-3);
}

} // namespace polydec::test::in_sliver_spectra
