// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec::test::in_level_sets {

/// Cubes of the unit cube in R^n, split, and moved a little unless it is to stay as it is.
Mesh cubes(int n, double jitter) {
    Mesh mesh = kuhn(n, 2);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        for (int c = 0; c < n; ++c) {
            double& x = mesh.points(v, c);
            if (x > 0 && x < 1)
                x += jitter * std::sin(7 * v + 3 * c);
        }
    return mesh;
}

class LevelSetsOf : public testing::TestWithParam<int> {};

TEST_P(LevelSetsOf, ALinearFunctionAreFlatAndWhole) {
    const int n = GetParam();
    for (const double jitter : {0.0, 0.05}) {
        const Mesh mesh = cubes(n, jitter);
        const Vector x = mesh.points.col(0);
        // 0.5 is the value of vertices; 1, of a whole side, bounds where x is less
        const Vector levels{{0.25, 0.5, 0.6, 1}};
        const auto found = level_sets(mesh, x, levels);
        EXPECT_EQ(found.mesh.dimension(), n - 1);
        for (Index i = 0; i < found.mesh.simplices.rows(); ++i)
            for (const Index v : found.mesh.simplices.row(i))
                EXPECT_NEAR(found.mesh.points(v, 0), levels[found.levels[i]], 1e-15);
        // the area of the unit cube's section, once for each level
        EXPECT_NEAR(n == 1 ? found.mesh.simplices.rows() : total_volume(found.mesh), 4, 1e-12);
        if (n > 1) {
            EXPECT_GT(cell_volumes(found.mesh).minCoeff(), 0);
        }
    }
}

TEST_P(LevelSetsOf, AnyFunctionAreBoundariesTurnedUpwards) {
    const int n = GetParam();
    const Mesh mesh = cubes(n, 0.05);
    Vector f(mesh.points.rows());
    for (Index v = 0; v < f.size(); ++v)
        f[v] = mesh.points.row(v).squaredNorm() + 0.3 * std::sin(11 * v);
    auto found = level_sets(mesh, f, equal_levels(f, 5));
    for (Index i = 0; i < found.mesh.simplices.rows(); ++i) {
        // the step from a simplex to the corner of its owner with the largest value leads upwards
        const auto owner = mesh.simplices.row(found.owners[i]);
        Index top = owner[0];
        for (const Index v : owner)
            top = f[v] > f[top] ? v : top;
        const auto own = found.mesh.simplices.row(i);
        DenseMatrix edges(n, n);
        edges.col(0) = (mesh.points.row(top) - found.mesh.points.row(own[0])).transpose();
        for (int k = 1; k < n; ++k)
            edges.col(k) =
                (found.mesh.points.row(own[k]) - found.mesh.points.row(own[0])).transpose();
        if (n > 1) {
            EXPECT_GT(edges.determinant(), 0) << i;
        }
    }
    if (n < 2)
        return;
    const auto tally = tally_facets(found.mesh);
    EXPECT_GT(tally.coherent, 0);
    EXPECT_EQ(tally.clashing, 0);
    EXPECT_EQ(tally.branching, 0);
    // the twin: a simplex turned around clashes with its neighbors
    std::swap(found.mesh.simplices(0, 0), found.mesh.simplices(0, 1));
    EXPECT_GT(tally_facets(found.mesh).clashing, 0);
}

TEST_P(LevelSetsOf, NumbersOfVerticesOnlyRenumberThem) {
    const int n = GetParam();
    const Mesh mesh = cubes(n, 0.05);
    Mesh other = mesh;
    const Index count = static_cast<Index>(mesh.points.rows());
    for (Index v = 0; v < count; ++v)
        other.points.row(count - 1 - v) = mesh.points.row(v);
    other.simplices = count - 1 - mesh.simplices.array();
    const Vector levels{{0.3, 0.5, 0.7}};
    const auto a = level_sets(mesh, mesh.points.col(n - 1), levels);
    const auto b = level_sets(other, other.points.col(n - 1), levels);
    EXPECT_EQ(a.mesh.points.rows(), b.mesh.points.rows());
    EXPECT_EQ(a.owners, b.owners);
    EXPECT_EQ(a.levels, b.levels);
    if (n > 1) {
        EXPECT_NEAR(total_volume(a.mesh), total_volume(b.mesh), 1e-13);
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, LevelSetsOf, testing::Range(1, 6));

TEST(LevelSets, OfValuesThatRoundingMovedHaveTheSameCells) {
    for (int n = 1; n <= 4; ++n) {
        const Mesh mesh = kuhn(n, 2);
        const Vector f = mesh.points.rowwise().sum(), levels{{0.5, 1, 1.25}};
        Vector moved = f;
        for (Index v = 0; v < f.size(); ++v)
            moved[v] += (v % 3 - 1) * 4e-16;
        const auto wanted = level_sets(mesh, f, levels.head(n == 1 ? 1 : 3));
        const auto found = level_sets(mesh, moved, levels.head(n == 1 ? 1 : 3));
        EXPECT_EQ(found.mesh.simplices, wanted.mesh.simplices) << n;
        EXPECT_EQ(found.owners, wanted.owners) << n;
        EXPECT_LE((found.mesh.points - wanted.mesh.points).norm(), 1e-14) << n;
    }
}

TEST(LevelSets, OnClosedSurfacesAreClosed) {
    const Mesh sphere = icosphere(6);
    const auto found =
        level_sets(sphere, sphere.points.col(2), equal_levels(sphere.points.col(2), 7));
    const auto tally = tally_facets(found.mesh);
    EXPECT_EQ(tally.boundary + tally.clashing + tally.branching, 0);
    // circles of latitude
    EXPECT_NEAR(
        total_volume(found.mesh),
        [] {
            double sum = 0;
            for (int i = 1; i <= 7; ++i)
                sum += 2 * std::acos(-1.0) * std::sqrt(1 - std::pow(i / 4.0 - 1, 2));
            return sum;
        }(),
        0.5);
    // the twin: with a triangle left out they are not
    Mesh open = sphere;
    open.simplices.conservativeResize(sphere.simplices.rows() / 2, 3);
    EXPECT_GT(tally_facets(level_sets(open, sphere.points.col(2), Vector{{0.1}}).mesh).boundary, 0);
}

TEST(LevelSets, AreEmptyWhereThereIsNothingBetween) {
    const Mesh mesh = grid(2, 2);
    Vector constant = Vector::Constant(9, 3);
    EXPECT_EQ(equal_levels(constant, 0).size(), 0);
    EXPECT_REFUSED(equal_levels(constant, 2), "all 9 values are 3", "no level sets");
    constant[4] = std::nextafter(3.0, 4.0);
    EXPECT_REFUSED(equal_levels(constant, 2), "all 9 values are 3,", "no level sets");
    EXPECT_EQ(level_sets(mesh, constant, Vector{{3}}).owners.size(), 0U);
    EXPECT_EQ(level_sets(mesh, mesh.points.col(0), Vector(0)).owners.size(), 0U);
    EXPECT_EQ(level_sets(mesh, mesh.points.col(0), Vector{{-1, 2}}).mesh.points.rows(), 0);
    // a single vertex at the top is no set
    EXPECT_EQ(level_sets(mesh, Vector::Unit(9, 4), Vector{{1}}).owners.size(), 0U);
    EXPECT_GT(level_sets(mesh, Vector::Unit(9, 4), Vector{{0.5}}).owners.size(), 0U);
}

TEST(LevelSets, OfExtremeValuesHavePointsOnTheEdges) {
    const Mesh mesh = grid(1, 1);
    const Vector f = 1.7e308 * (2 * mesh.points.col(0).array() - 1);
    const auto found = level_sets(mesh, f, Vector{{-1e308, 1e308}});
    EXPECT_TRUE(found.mesh.points.allFinite());
    EXPECT_NEAR(found.mesh.points(0, 0), (1.7 - 1) / 3.4, 1e-15);
}

TEST(LevelSets, SayWhatTheyCannotCut) {
    const Mesh mesh = grid(1, 1);
    const Vector x = mesh.points.col(0);
    EXPECT_REFUSED(level_sets(mesh, x, Vector{{0.5, 0.5}}), "level sets", "level 1", "0.5", "0.5");
    EXPECT_REFUSED(level_sets(mesh, x, Vector{{std::nan("")}}), "levels", "value 0", "nan");
    EXPECT_REFUSED(level_sets(mesh, x / 0.0, Vector{{0.5}}), "function on vertices", "value", "0");
    EXPECT_THROW(level_sets(mesh, x.head(3), Vector{{0.5}}), InvalidInput);
    EXPECT_THROW(equal_levels(x, -1), InvalidInput);
    EXPECT_THROW(equal_levels(Vector(0), 1), InvalidInput);
    Mesh bad = mesh;
    bad.simplices(0, 0) = 9;
    EXPECT_THROW(level_sets(bad, x, Vector{{0.5}}), InvalidInput);
}

} // namespace polydec::test::in_level_sets
