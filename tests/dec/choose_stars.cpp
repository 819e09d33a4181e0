// SPDX-License-Identifier: MIT

#include "tests/dec/discretized.h"
#include "tests/support/slivers.h"

namespace polydec::test::in_choose_stars {

constexpr double rounding = 1e-10;
constexpr std::array consistent{StarKind::galerkin, StarKind::hybrid, StarKind::automatic};

DenseMatrix dense(const HodgeStar& star) {
    return DenseMatrix(star.matrix());
}

/// Of the cells of a mesh and, as they are, of its simplices.
class StarsOf : public testing::TestWithParam<std::string> {
protected:
    static std::vector<Discretization> both(const Mesh& mesh) {
        return {discretize(mesh, {.tolerance = tolerance}),
                discretize(mesh, {.criterion = MergeCriterion::none})};
    }
    std::vector<Discretization> both() const { return both(mesh_named(GetParam())); }

    static bool small(const Discretization& mesh) {
        Index largest = 0;
        for (int k = 0; k <= mesh.dimension(); ++k)
            largest = std::max(largest, mesh.complex().size(k));
        return largest <= 400;
    }
    static bool exists(const Discretization& mesh, StarKind kind) {
        return kind != StarKind::hybrid || mesh.dimension() == 2;
    }
};

TEST_P(StarsOf, galerkin_are_exact_for_constant_forms) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    for (const auto& mesh : both()) {
        const int n = mesh.dimension();
        const double volume = mesh.volumes().primal(n).sum();
        for (const StarKind kind : consistent) {
            if (!exists(mesh, kind))
                continue;
            const auto chosen = mesh.with_stars(kind).chosen_stars();
            for (int k = 0; k <= n; ++k) {
                if (chosen.kind == StarKind::circumcentric && k > 0)
                    continue; // exact as a sum over all cells around, not at the boundary
                const Vector a = random_vector(coefficients(n, k), 1),
                             b = random_vector(coefficients(n, k), 2);
                const auto of = [&](const Vector& c) -> Vector {
                    return mesh.merging().diamond(k).cast<double>() *
                           integrate(mesh.input(), mesh.points(), k, constant_form(c));
                };
                const double expected = a.dot(b) * volume;
                EXPECT_NEAR(of(a).dot(chosen.stars[k] * of(b)), expected,
                            rounding * a.norm() * b.norm() * volume)
                    << name(kind) << ", k = " << k;
            }
        }
    }
}

TEST(ChosenStars, between_centroids_are_wrong_for_constant_one_forms) {
    const auto mesh = discretize(mesh_named("obtuse_planar"), {.criterion = MergeCriterion::none});
    const Vector a =
        integrate(mesh.input(), mesh.points(), 1, constant_form(Eigen::Vector2d(1, 0)));
    const auto defect = [&](StarKind kind) {
        return std::abs(
            a.dot(mesh.with_stars(kind).stars()[1] * a) / mesh.volumes().primal(2).sum() - 1);
    };
    EXPECT_LE(defect(StarKind::galerkin), rounding);
    EXPECT_GT(defect(StarKind::barycentric), 1e-3);
}

TEST_P(StarsOf, all_kinds_but_circumcentric_ones_are_positive_definite) {
    for (const auto& mesh : both())
        for (const StarKind kind :
             {StarKind::galerkin, StarKind::hybrid, StarKind::barycentric, StarKind::automatic}) {
            if (!exists(mesh, kind) || !small(mesh))
                continue;
            const auto stars = mesh.with_stars(kind).stars();
            for (int k = 0; k <= mesh.dimension(); ++k) {
                const DenseMatrix M = dense(stars[k]);
                EXPECT_WITHIN(M, M.transpose(), 1e-13 * M.cwiseAbs().maxCoeff());
                EXPECT_EQ(M.llt().info(), Eigen::Success) << name(kind) << ", k = " << k;
            }
        }
}

/// On surfaces any star of 1-forms has the cotangent Laplacian: closed forms do not see the choice.
TEST_P(StarsOf, surfaces_have_one_laplacian_of_functions) {
    for (const auto& mesh : both()) {
        if (mesh.dimension() != 2)
            continue;
        const SparseMatrix d = derivative(mesh.complex(), 0), d_transposed = d.transpose();
        const SparseMatrix expected = d_transposed * mesh.stars()[1].matrix() * d;
        for (const StarKind kind : consistent) {
            const SparseMatrix A = d_transposed * mesh.with_stars(kind).stars()[1].matrix() * d;
            EXPECT_CLOSE(A, expected, rounding) << name(kind);
        }
        const SparseMatrix other =
            d_transposed * mesh.with_stars(StarKind::barycentric).stars()[1].matrix() * d;
        if (GetParam() == "obtuse_planar") {
            EXPECT_GT(relative_difference(other, expected), 1e-2);
        }
    }
}

/// How far fluxes of a linear function p are from its differences between sites, and between these
/// and midpoints of edges on the boundary.
double flux_defect(const Discretization& mesh, const HodgeStars& stars, const Points& places) {
    const Eigen::Vector2d slope(0.7, -0.4);
    const Vector flux = mesh.merging().diamond(1).cast<double>() *
                        integrate(mesh.input(), mesh.points(), 1,
                                  constant_form(Eigen::Vector2d(-slope[1], slope[0])));
    const Vector p = places * slope;
    const Points middles = cell_centers(mesh, 1);
    const SparseMatrix cofaces = SparseMatrix(derivative(mesh.complex(), 1).transpose());
    const Vector of_orientation = cofaces * Vector::Ones(cofaces.cols());
    Vector differences = cofaces * p;
    for (Index e = 0; e < differences.size(); ++e)
        if (mesh.complex().coface_counts(1)[e] == 1)
            differences[e] -= of_orientation[e] * middles.row(e).dot(slope);
    const Vector measured = stars[1] * flux;
    return std::min((measured - differences).cwiseAbs().maxCoeff(),
                    (measured + differences).cwiseAbs().maxCoeff());
}

TEST_P(StarsOf, planar_pass_the_patch_test_of_fluxes) {
    const Mesh& input = mesh_named(GetParam());
    if (input.simplices.cols() != 3 || !is_flat(input))
        return;
    for (const auto& mesh : both(shaken(input, 0.15, 5))) {
        if (turn(mesh) == 0)
            continue;
        for (const StarKind kind : consistent) {
            const auto chosen = mesh.with_stars(kind);
            EXPECT_LE(flux_defect(chosen, chosen.stars(), dual_sites(chosen)), 1e-9) << name(kind);
        }
        const auto barycentric = mesh.with_stars(StarKind::barycentric).chosen_stars();
        if (mesh.complex().size(2) > 2) {
            EXPECT_GT(flux_defect(mesh, barycentric.stars, cell_centroids(mesh, 2)), 1e-4);
        }
    }
}

TEST_P(StarsOf, codifferentials_are_adjoint_and_laplacians_are_those_of_the_masses) {
    for (const auto& mesh : both()) {
        if (!small(mesh))
            continue;
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        for (int k = 0; k <= mesh.dimension(); ++k) {
            const Vector a = random_vector(mesh.complex().size(k), 3);
            const Operator A = symmetric_laplacian({mesh.complex(), stars}, k);
            const Vector expected = dense_laplacian_of(mesh.complex(), stars, k, a);
            EXPECT_CLOSE(A * a, expected, 1e-8) << "k = " << k;
            EXPECT_CLOSE(stars[k] * (laplacian({mesh.complex(), stars}, k) * a), expected, 1e-8)
                << "k = " << k;
            if (k > 0) {
                const Vector b = random_vector(mesh.complex().size(k - 1), 4);
                const double there = a.dot(stars[k] * (derivative(mesh.complex(), k - 1) * b));
                const Vector delta = codifferential({mesh.complex(), stars}, k) * a;
                EXPECT_NEAR(b.dot(stars[k - 1] * delta), there,
                            1e-9 * std::sqrt(a.dot(stars[k] * a) * b.dot(stars[k - 1] * b)) /
                                mesh.volumes().primal(1).minCoeff());
                EXPECT_REFUSED(A.matrix(), "star", "matrix", "dense");
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Family, StarsOf, testing::ValuesIn(names_of_meshes()), parameter_name);

TEST(ChosenStars, are_an_option_of_discretize) {
    const Mesh input = shaken(grid(6, 6), 0.42, 3);
    const auto mesh = discretize(input, {.star = StarKind::automatic});
    const auto expected = discretize(input).with_stars(StarKind::automatic).chosen_stars();
    EXPECT_EQ(mesh.chosen_stars().kind, StarKind::hybrid);
    EXPECT_EQ(mesh.chosen_stars().galerkin, expected.galerkin);
    for (int k = 0; k <= 2; ++k)
        EXPECT_EQ(dense(mesh.stars()[k]), dense(expected.stars[k]));
    EXPECT_EQ(discretize(input).chosen_stars().kind, StarKind::hybrid) << "by default";
    EXPECT_EQ(circumcentric(input).chosen_stars().kind, StarKind::circumcentric);
    EXPECT_EQ(mesh.with_stars(HodgeStars(mesh.volumes())).chosen_stars().kind, StarKind::own);
    EXPECT_REFUSED(mesh.with_stars(StarKind::own).chosen_stars(), "own", "pass your stars");
}

/// Smallest and largest eigenvalue of star_1: an independent reference in numpy.
TEST(ChosenStars, of_a_mesh_with_a_negative_dual_have_known_eigenvalues) {
    const auto mesh = discretize(mesh_named("star_negative"), {.criterion = MergeCriterion::none});
    const auto ends = [&](StarKind kind) {
        const DenseMatrix M = dense(mesh.with_stars(kind).stars()[1]);
        const Vector all = dense_values(M, DenseMatrix::Identity(M.rows(), M.cols()));
        return Eigen::Vector2d(all[0], all[all.size() - 1]);
    };
    EXPECT_LE((ends(StarKind::circumcentric) - Eigen::Vector2d(-0.3024215696, 4.2723919920)).norm(),
              1e-9);
    EXPECT_LE((ends(StarKind::galerkin) - Eigen::Vector2d(0.0779644155, 2.6172780486)).norm(),
              1e-9);
    EXPECT_LE((ends(StarKind::hybrid) - ends(StarKind::galerkin)).norm(), 1e-12);
    EXPECT_EQ(mesh.with_stars(StarKind::hybrid).chosen_stars().galerkin_share(), 1);
}

/// The first eigenvalues with all masses Galerkin's, of the simplices: the same reference.
TEST(ChosenStars, by_galerkin_have_known_spectra) {
    struct Known {
        const char* mesh;
        int degree;
        std::vector<double> values;
    };
    for (const auto& [title, k, values] :
         {Known{"torus8x6", 1, {0, 0, 1.0974662552, 1.0974662552, 1.1822376741, 1.1822376741}},
          Known{"ring6", 1, {0, .20134008193, .20182179506, .54617326016, 1.0715937102}},
          Known{"solid_torus3", 1, {0, .88310083608, .88370374909, 2.3536436337, 5.2806815885}},
          Known{"solid_torus3", 2, {5.2806815885, 5.6437309026, 6.5032900069}},
          Known{"kuhn3", 1, {11.4687669178, 11.4989561344, 11.4989561344, 20.7306862326}},
          Known{"kuhn3", 3, {30.3132883229, 48.2709931715, 48.2709931715, 57.3481861183}}}) {
        const auto mesh = discretize(mesh_named(title), {.criterion = MergeCriterion::none});
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        const Vector found = extended_eigenvalues(mesh.complex(), stars, k).cast<double>();
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(found[static_cast<Index>(i)], values[i], 1e-8) << title << ", k = " << k;
    }
}

TEST(ChosenStars, hybrid_are_definite_on_shaken_meshes_where_circumcentric_ones_are_not) {
    int indefinite = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const auto mesh = circumcentric(shaken(grid(5, 5), 0.42, seed));
        const auto chosen = mesh.with_stars(StarKind::automatic).chosen_stars();
        EXPECT_EQ(chosen.kind == StarKind::hybrid,
                  !mesh.stars()[1].negatives().empty() || !mesh.stars()[0].negatives().empty());
        EXPECT_EQ(dense(chosen.stars[1]).llt().info(), Eigen::Success) << seed;
        EXPECT_GT(chosen.stars[0].diagonal().minCoeff(), 0) << seed;
        indefinite += mesh.stars()[1].negatives().empty() ? 0 : 1;
    }
    EXPECT_GT(indefinite, 900);
}

TEST(ChosenStars, hybrid_take_no_cell_by_the_sign_of_a_rounding) {
    // beside a triangle with a negative dual one whose part of the dual between them is 0
    const Points corners{{0.3, 0.7}, {1, 0.7}, {0.3, 1.8}, {3.7, 2.1}};
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.1 + 0.37 * i;
        const DenseMatrix turn{{std::cos(angle), std::sin(angle)},
                               {-std::sin(angle), std::cos(angle)}};
        const auto mesh = discretize(Mesh{corners * turn, Simplices{{0, 1, 2}, {1, 3, 2}}, {}});
        EXPECT_EQ(mesh.with_stars(StarKind::hybrid).chosen_stars().galerkin,
                  (std::vector{false, true}))
            << i;
    }
}

TEST(ChosenStars, hybrid_mix_both_kinds_and_pass_the_patch_test) {
    int mixed = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const auto mesh = discretize(shaken(grid(6, 6), 0.2, seed), {.tolerance = tolerance});
        const auto chosen = mesh.with_stars(StarKind::hybrid);
        const double share = chosen.chosen_stars().galerkin_share();
        if (turn(mesh) == 0 || share == 0 || share == 1)
            continue;
        ++mixed;
        EXPECT_LE(flux_defect(mesh, chosen.stars(), dual_sites(chosen)), 1e-12);
        EXPECT_GT(flux_defect(mesh, chosen.stars(), cell_centers(mesh, 2)), 1e-3);
    }
    EXPECT_GT(mixed, 800);
}

/// Next to an edge whose dual is a million times as long as it is: the same reference.
TEST(ChosenStars, by_galerkin_have_a_positive_spectrum_on_a_sliver) {
    Mesh mesh;
    mesh.points.resize(5, 2);
    mesh.points << 0, 0, 1, 0, .5, -1e-6, .5, 1e-6, .5, -1;
    mesh.simplices.resize(3, 3);
    mesh.simplices << 0, 1, 3, 0, 1, 2, 0, 2, 4;
    const auto three = discretize(mesh, {.criterion = MergeCriterion::none});
    const auto stars = three.with_stars(StarKind::galerkin).stars();
    const Vector found = extended_eigenvalues(three.complex(), stars, 2).cast<double>();
    EXPECT_NEAR(found[0], 57.599677, 1e-6);
    EXPECT_NEAR(found[1], 96, 1e-5);
    EXPECT_NEAR(found[2], 96, 1e-5);
}

/// Flat tetrahedra add nothing to the duals of their vertices.
TEST(ChosenStars, of_vertices_fill_cubes_with_flat_pieces) {
    const auto cubes = discretize(five_to_a_cube(3), {.star = StarKind::barycentric});
    ASSERT_GT(cubes.pieces().size(3), 5 * 27);
    const Vector shares = cubes.stars()[0].diagonal();
    EXPECT_NEAR(shares.sum(), 27, 1e-9);
    EXPECT_GT(shares.minCoeff(), 0);
}

/// The flat one of three tetrahedra, a square, joins a neighbor that covers half of it.
TEST(ChosenStars, that_do_not_exist_are_refused_before_they_are_used) {
    Mesh mesh{Points(6, 3), Simplices(3, 4), {}};
    mesh.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, -0.75, 1, 1;
    mesh.simplices << 0, 4, 3, 1, 0, 2, 3, 1, 0, 2, 5, 1;
    EXPECT_REFUSED(discretize(mesh), "3-cell 0", "flat", "tolerance");
    EXPECT_EQ(discretize(mesh, {.star = StarKind::circumcentric}).complex().size(3), 2);
}

TEST(ChosenStars, by_galerkin_are_there_for_tets_as_flat_as_they_come) {
    for (const int size : {8, 10}) {
        const auto mesh = discretize(shaken(kuhn(3, size), 0.3, 3));
        const auto chosen = mesh.with_stars(StarKind::galerkin).chosen_stars();
        for (int k = 0; k <= 3; ++k) {
            const SparseMatrix M = chosen.stars[k].matrix();
            EXPECT_EQ(SparseMatrix(M - SparseMatrix(M.transpose())).norm(), 0) << k;
        }
    }
}

TEST(ChosenStars, automatic_ones_are_circumcentric_where_these_are_positive) {
    EXPECT_EQ(
        discretize(grid(4, 4)).with_stars(StarKind::automatic).chosen_stars().galerkin_share(), 0);
    EXPECT_EQ(discretize(kuhn(3, 2)).with_stars(StarKind::automatic).chosen_stars().kind,
              StarKind::circumcentric);
    const auto tets = discretize(shaken(kuhn(3, 3), 0.2, 1));
    const auto chosen = tets.with_stars(StarKind::automatic).chosen_stars();
    EXPECT_EQ(chosen.kind, StarKind::galerkin);
    EXPECT_TRUE(chosen.stars[0].is_diagonal());
    EXPECT_FALSE(chosen.stars[1].is_diagonal());
    EXPECT_THROW(tets.with_stars(StarKind::hybrid).chosen_stars(), InvalidInput);
}

} // namespace polydec::test::in_choose_stars
