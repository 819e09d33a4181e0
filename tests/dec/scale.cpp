// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_scale {

/// 1e-150 .. 1e150 as even powers of two, and two that need no other unit.
constexpr int exponents[] = {-500, -332, -26, 26, 332, 500};

Mesh scaled(Mesh mesh, double size) {
    mesh.points *= size;
    return mesh;
}

LengthMesh scaled(LengthMesh mesh, double size) {
    mesh.lengths *= size;
    return mesh;
}

/// The volumes of both, equal bit by bit once each number has its power of `size`.
void expect_scaled(const CellVolumes& volumes, const CellVolumes& original, double size) {
    const int n = original.dimension();
    ASSERT_EQ(volumes.dimension(), n);
    for (int k = 0; k <= n; ++k) {
        ASSERT_EQ(volumes.primal(k).size(), original.primal(k).size());
        EXPECT_EQ(volumes.primal(k), std::pow(size, k) * original.primal(k)) << "degree " << k;
        EXPECT_EQ(volumes.dual(k), std::pow(size, n - k) * original.dual(k)) << "degree " << k;
    }
}

/// What `mesh` becomes at every size is what it is at size 1, in other units.
template <class AnyMesh>
void expect_equal_at_all_sizes(const AnyMesh& mesh, const DiscretizeOptions& options) {
    const auto original = discretize(mesh, options);
    ASSERT_EQ(original.unit(), 1);
    for (const int exponent : exponents) {
        const double size = std::exp2(exponent);
        const auto found = discretize(scaled(mesh, size), options);
        const double rest = size / found.unit();
        EXPECT_EQ(found.unit() != 1, std::abs(exponent) > 40);
        EXPECT_EQ(found.warnings().size(),
                  original.warnings().size() + (found.unit() != 1 ? 1 : 0));
        EXPECT_EQ(found.points(), size * original.points());
        expect_scaled(found.volumes(), original.volumes(), rest);
        expect_scaled(found.input_geometry().volumes(), original.input_geometry().volumes(), rest);
        EXPECT_EQ(found.degenerate().interior, original.degenerate().interior);
    }
}

class AtAllSizes : public OverMeshes {};

TEST_P(AtAllSizes, meshes_have_the_same_cells_and_volumes_in_their_units) {
    expect_equal_at_all_sizes(mesh_named(GetParam()), {});
}

TEST_P(AtAllSizes, lengths_alone_give_them_too) {
    expect_equal_at_all_sizes(length_mesh(mesh_named(GetParam())), {});
}

POLYDEC_OVER_MESHES(AtAllSizes);

// Of coefficients by lengths of the input. The twin: of others.
TEST_P(AtAllSizes, weights_of_robins_condition_are_in_their_units) {
    const Mesh& mesh = mesh_named(GetParam());
    const auto original = discretize(mesh, {.star = StarKind::circumcentric});
    const int n = mesh.dimension();
    for (const int exponent : exponents) {
        const double size = std::exp2(exponent);
        const auto found = discretize(scaled(mesh, size), {.star = StarKind::circumcentric});
        const auto weights = [&](const Discretization& of, double coefficient) {
            const BoundaryConditions robin{BoundaryCondition::robin, {}, {coefficient}};
            return FormSpace(of, Side::primal, 0, robin).robin_weights();
        };
        const SparseMatrix expected = std::pow(size / found.unit(), n - 2) * weights(original, 3);
        EXPECT_CLOSE(weights(found, 3 / size), expected, 1e-12) << exponent;
        if (expected.nonZeros() > 0) {
            EXPECT_GT(relative_difference(weights(found, 4 / size), expected), 0.1) << exponent;
        }
    }
}

class FlippedAtAllSizes : public testing::TestWithParam<std::string> {};

TEST_P(FlippedAtAllSizes, surfaces_are_flipped_and_split_alike) {
    const Mesh mesh = shaken(mesh_named(GetParam()), 0.25, 7);
    for (const Delaunay delaunay : {Delaunay::flips, Delaunay::flips_and_splits}) {
        expect_equal_at_all_sizes(mesh, {.delaunay = delaunay});
        expect_equal_at_all_sizes(length_mesh(mesh), {.delaunay = delaunay});
    }
}

INSTANTIATE_TEST_SUITE_P(Family, FlippedAtAllSizes,
                         testing::Values("uv_sphere7x5", "torus9x5", "annulus9", "moebius12x2",
                                         "grid4", "hexagons5"),
                         parameter_name);

TEST(AtAllSizes, flips_by_themselves_lead_to_the_same_surface) {
    const Mesh mesh = shaken(icosphere(4), 0.25, 7);
    const SimplicialComplex K(mesh.simplices);
    const Vector lengths = edge_lengths(K, mesh.points);
    const auto original = intrinsic_delaunay(GluedSurface(K), lengths);
    ASSERT_GT(original.statistics.flips, 0);
    for (const int exponent : exponents) {
        const double size = std::exp2(exponent);
        const auto found = intrinsic_delaunay(GluedSurface(K), size * lengths);
        EXPECT_EQ(found.lengths, size * original.lengths);
        EXPECT_EQ(found.statistics.flips, original.statistics.flips);
    }
}

TEST(Units, are_told_in_a_warning) {
    EXPECT_EACH_SAYS(discretize(scaled(grid(1, 1), std::exp2(500))).warnings(),
                     {"units", "2^500", "3.27e+150"});
    EXPECT_EACH_SAYS(discretize(scaled(length_mesh(grid(1, 1)), std::exp2(-333))).warnings(),
                     {"units", "2^-334", "2.86e-101"});
}

TEST(Units, without_numbers_of_double_precision_are_told_of_a_diagnosis) {
    for (const double size : {1.0, 1e120}) { // whose cube is no double
        Mesh mesh = kuhn(3, 1);
        mesh.points *= size;
        const auto told = diagnose(discretize(mesh));
        EXPECT_EQ(told.volume.has_value(), size == 1);
        EXPECT_TRUE(each_says(told.warnings, size == 1
                                                 ? std::vector<Words>{}
                                                 : std::vector<Words>{{"volumes", "double"}}));
    }
}

TEST(MixedSizes, are_right_or_refused_by_name) {
    // a square of size 1 and one that is far smaller
    const auto both = [](double size) {
        return united(grid(2, 2), transformed(grid(2, 2), DenseMatrix::Identity(2, 2), size, 3));
    };
    const auto flat = discretize(both(1e-3));
    EXPECT_EQ(flat.unit(), 1);
    const auto apart = [](double size) {
        Mesh mesh = kuhn(1, 1);
        mesh.points.conservativeResize(4, Eigen::NoChange);
        mesh.points.col(0) << 2, 3, 0, size;
        mesh.simplices.resize(2, 2);
        mesh.simplices << 0, 1, 2, 3;
        return mesh;
    };
    EXPECT_EQ(star(discretize(apart(1e-90)).volumes(), 1).diagonal()[1], 1 / 1e-90);
    EXPECT_REFUSED(discretize(apart(1e-150)), "1-simplex", "vertices 2, 3", "edges", "1e-150",
                   "volume", "1e-150");
}

} // namespace polydec::test::in_scale
