// SPDX-License-Identifier: MIT
#include "dec/metric/circumsphere.h"
#include "dec/metric/rounding.h"
#include "tests/support/test.h"

namespace polydec::test::in_volumes {

class Volumes : public OverMeshes {};

/// Relative defect of sum |s||*s| = C(n,k) |K|.
double identity_defect(const CellVolumes& volumes, int k) {
    const int n = volumes.dimension();
    const double expected = binomial(n, k) * volumes.primal(n).sum();
    return std::abs(volumes.primal(k).dot(volumes.dual(k)) - expected) / expected;
}

TEST_P(Volumes, of_cells_times_their_duals_fill_the_complex_binomially_often) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k)
            EXPECT_LE(identity_defect(volumes, k), 1e-12) << name << ", k = " << k;
}

/// Duals as unsigned distances with one sign: that of the top simplex. What a widespread reading
/// of the definition gives.
CellVolumes signed_by_top_simplex(const SimplicialComplex& K, const Points& points) {
    CellVolumes volumes = circumcentric_volumes(K, points);
    const int n = K.dimension();
    std::vector<Vector> duals;
    for (int k = 0; k < n; ++k)
        duals.emplace_back(Vector::Zero(K.size(k)));
    Circumsphere sphere;
    const auto height = [&](int k, Index t, int omitted) {
        EXPECT_TRUE(sphere.look_at({points, vertices(K.simplices(k), t)}));
        return sphere.height(omitted, volumes.primal(k - 1)[K.face(k, t, omitted)]);
    };
    const auto descend = [&](const auto& self, int k, Index t, double product) -> void {
        for (int omitted = 0; omitted <= k && k > 0; ++omitted) {
            const double h = height(k, t, omitted);
            const double next = product * (k == n ? h : std::abs(h)) / (n - k + 1);
            duals[k - 1][K.face(k, t, omitted)] += next;
            self(self, k - 1, K.face(k, t, omitted), next);
        }
    };
    for (Index t = 0; t < K.size(n); ++t)
        descend(descend, n, t, 1.0);
    for (int k = 0; k < n; ++k)
        volumes = volumes.with_dual(k, duals[k]);
    return volumes;
}

TEST(VolumesBroken, by_the_sign_of_the_top_simplex_do_not_fill_an_obtuse_solid) {
    for (const char* name : {"obtuse_solid", "obtuse4"}) {
        const auto& mesh = merged(name);
        const auto wrong = signed_by_top_simplex(mesh.K(), mesh.points);
        EXPECT_GT(identity_defect(wrong, 0), 1e-4) << name;
        EXPECT_GT(identity_defect(wrong, 1), 1e-4) << name;
        EXPECT_LE(identity_defect(wrong, mesh.n() - 1), 1e-12) << name;
    }
}

TEST(VolumesBroken, by_the_sign_of_the_top_simplex_pass_unseen_on_acute_meshes) {
    const auto& mesh = merged("kuhn3");
    const auto wrong = signed_by_top_simplex(mesh.K(), mesh.points);
    for (int k = 0; k <= 3; ++k)
        EXPECT_CLOSE(wrong.dual(k), mesh.input_volumes.dual(k), 1e-12);
}

TEST(VolumesBroken, without_signs_do_not_fill_an_obtuse_surface) {
    const CellVolumes& volumes = merged("obtuse_planar").input_volumes;
    EXPECT_GT(identity_defect(volumes.with_dual(1, volumes.dual(1).cwiseAbs()), 1), 1e-2);
}

TEST_P(Volumes, of_merged_cells_are_sums_over_their_pieces) {
    for (int k = 0; k <= mesh().n(); ++k) {
        const auto& dia = mesh().merging().diamond(k);
        for (Index F = 0; F < mesh().P().size(k); ++F) {
            double volume = 0, product = 0;
            for (IncidenceMatrix::InnerIterator s(dia, F); s; ++s) {
                const auto [primal, dual] = std::pair(mesh().input_volumes.primal(k)[s.col()],
                                                      mesh().input_volumes.dual(k)[s.col()]);
                volume += primal;
                product += primal * dual;
            }
            EXPECT_NEAR(mesh().volumes.primal(k)[F], volume, 1e-14 * volume);
            EXPECT_NEAR(mesh().volumes.dual(k)[F] * volume, product,
                        1e-13 * (volume + std::abs(product)));
        }
    }
}

TEST_P(Volumes, pieces_of_a_cell_have_the_same_dual) {
    for (int k = 0; k <= mesh().n(); ++k) {
        const double scale = mesh().volumes.dual(k).cwiseAbs().maxCoeff();
        for (Index s = 0; s < mesh().K().size(k); ++s) {
            const auto& carrier = mesh().merging().carriers(k)[s];
            if (carrier.dimension == k) {
                EXPECT_NEAR(mesh().input_volumes.dual(k)[s], mesh().volumes.dual(k)[carrier.cell],
                            1e-7 * scale);
            }
        }
    }
}

TEST_P(Volumes, of_duals_of_removed_facets_are_zero) {
    const int n = mesh().n();
    for (Index f = 0; f < mesh().K().size(n - 1); ++f)
        if (mesh().merging().carriers(n - 1)[f].dimension == n) {
            EXPECT_LE(std::abs(mesh().input_volumes.dual(n - 1)[f]),
                      1e-7 * mesh().input_volumes.dual(n - 1).cwiseAbs().maxCoeff());
        }
}

POLYDEC_OVER_MESHES(Volumes);

TEST(VolumesOf, a_right_triangle_are_the_textbook_ones) {
    const Mesh mesh = made_of({{0, 0}, {4, 0}, {0, 3}}, {{0, 1, 2}});
    const SimplicialComplex K(mesh.simplices);
    const auto volumes = circumcentric_volumes(K, mesh.points);
    EXPECT_NEAR(volumes.primal(2)[0], 6, 1e-14);
    // edges (0,1), (0,2), (1,2); the circumcenter is the middle of the last
    EXPECT_TRUE(volumes.primal(1).isApprox(Eigen::Vector3d(4, 3, 5), 1e-14));
    EXPECT_NEAR(volumes.dual(1)[0], 1.5, 1e-14);
    EXPECT_NEAR(volumes.dual(1)[1], 2, 1e-14);
    EXPECT_NEAR(volumes.dual(1)[2], 0, 1e-14);
    EXPECT_TRUE(volumes.dual(0).isApprox(Eigen::Vector3d(3, 1.5, 1.5), 1e-14));
}

TEST(VolumesOf, an_obtuse_triangle_have_a_negative_dual_edge) {
    const Mesh mesh = made_of({{0, 0}, {2, 0}, {1, 0.5}}, {{0, 1, 2}});
    const auto volumes = circumcentric_volumes(SimplicialComplex(mesh.simplices), mesh.points);
    // the circumcenter (1, -0.75) lies 0.75 beyond the long edge
    EXPECT_NEAR(volumes.dual(1)[0], -0.75, 1e-14);
}

std::string refused_volumes(const Mesh& mesh) {
    return refusal([&] {
        const SimplicialComplex complex(mesh.simplices);
        const Points points = vertex_points(complex, mesh.points);
        circumcentric_volumes(complex, points);
    });
}

TEST(VolumesOf, cells_without_extent_are_refused) {
    EXPECT_SAYS(refused_volumes(made_of({{0, 0}, {1, 1}, {2, 2}}, {{0, 1, 2}})), "2-simplex",
                "vertices 0, 1, 2", "volume");
    EXPECT_SAYS(refused_volumes(made_of({{0, 0}, {1, 1}, {1, 1}}, {{0, 1, 2}})), "1-simplex",
                "vertices 1, 2", "volume");
}

TEST(VolumesOf, cells_too_large_or_small_for_products_are_not_called_flat) {
    for (const double size : {1e160, 1e-170})
        EXPECT_SAYS(refused_volumes(made_of({{0, 0}, {size, 0}, {0, size}}, {{0, 1, 2}})),
                    "1-simplex", "vertices 0, 1", "edges", fmt::format("{:.3g}", size), "volume",
                    "0", "scale");
}

TEST(Circumsphere, of_more_vertices_than_a_simplex_can_have_is_refused) {
    std::vector<Index> row(40);
    std::iota(row.begin(), row.end(), 0);
    const Points axes = Points::Identity(40, 40);
    EXPECT_REFUSED(return Circumsphere().look_at({axes, row}), "vertices", "simplex 40");
    // twelve points of the plane are dependent, and so are four
    const Points plane = Points::Random(12, 2);
    for (const std::size_t count : {12, 4})
        EXPECT_FALSE(Circumsphere().look_at({plane, std::span(row).first(count)}));
}

/// How many times its bound the worst circumcenter of random simplices is off over a facet. The
/// reference solves with the Gram matrix and eleven bits more.
double worst_rounding(int k, int N) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    double worst = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        Points points(k + 1, N);
        for (double& x : points.reshaped())
            x = coordinate(random);
        std::vector<Index> corners(k + 1);
        std::iota(corners.begin(), corners.end(), 0);
        Circumsphere sphere;
        constexpr double double_digits = 2; // of what is done with more, growth is nearly 1
        if (!sphere.look_at({points, corners}) || sphere.rounding().growth < double_digits)
            continue;
        const Extended edges =
            points.bottomRows(k).cast<long double>().rowwise() - points.row(0).cast<long double>();
        const Extended gram = edges * edges.transpose();
        const Extended inverse = solve_extended(gram, Extended::Identity(k, k)).X;
        const Extended exact = inverse * gram.diagonal() / 2;
        for (int i = 0; i < k; ++i) {
            const long double altitude = 1 / std::sqrt(inverse(i, i));
            const auto height = static_cast<double>(exact(i) * altitude);
            const auto error =
                static_cast<double>(std::abs(sphere.barycentric(i + 1) - exact(i)) * altitude);
            worst = std::max(worst, error / rounding_of(sphere.rounding().of(height)));
        }
    }
    return worst;
}

TEST(Circumsphere, of_random_simplices_is_within_its_rounding_and_not_within_a_hundredth_of_it) {
    for (int k = 2; k <= 5; ++k)
        for (int N = k; N <= k + 1; ++N) {
            EXPECT_LE(worst_rounding(k, N), 1) << k << " in " << N;
            EXPECT_GT(worst_rounding(k, N), 0.01) << k << " in " << N;
        }
}

/// Two heights of 1e-9 beside edges of length 1: of 32 digits 14 are left.
TEST(Circumsphere, tells_what_flat_simplices_lose) {
    Points flat(4, 3);
    flat << 0, 0, 0, 1, 0, 0, 0.3, 1e-9, 0, 0.6, 2e-9, 1e-9;
    Circumsphere sphere;
    const std::vector<Index> corners{0, 1, 2, 3};
    ASSERT_TRUE(sphere.look_at({flat, corners}));
    EXPECT_GT(sphere.rounding().growth, 100);
    EXPECT_LT(sphere.rounding().growth, 1e4);
}

TEST(VolumesOf, cells_without_place_are_refused) {
    EXPECT_SAYS(refused_volumes(made_of({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 3}})), "cell", "vertex 3",
                "3 points");
    EXPECT_SAYS(refused_volumes(made_of({{0}, {1}, {2}}, {{0, 1, 2}})), "dimension 2",
                "1 coordinates");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_SAYS(refused_volumes(made_of({{0, 0}, {1, nan}, {2, 2}}, {{0, 1, 2}})), "vertex 1",
                "coordinate", "finite");
}

} // namespace polydec::test::in_volumes
