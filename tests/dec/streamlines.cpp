// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_streamlines {

std::vector<Mesh> flat_meshes() {
    return {grid(9, 7), hexagons(6), well_centered(4), kuhn(3, 4), bcc(3), fcc(2)};
}

/// A field at the centroids of the merged cells.
DenseMatrix sampled(const Discretization& mesh,
                    const std::function<Vector(const Eigen::RowVectorXd&)>& field) {
    const Points sites = cell_centroids(mesh, mesh.dimension());
    DenseMatrix vectors(sites.rows(), sites.cols());
    for (Index i = 0; i < sites.rows(); ++i)
        vectors.row(i) = field(sites.row(i)).transpose();
    return vectors;
}

Vector constant(Index coordinates) {
    return Vector{{1, 0.37, -0.21}}.head(coordinates);
}

/// The largest sine between a segment and a vector; 2 for one that points back.
double worst_angle(const Mesh& lines, const Vector& along) {
    double worst = 0;
    for (const auto& ends : lines.simplices.rowwise()) {
        const Vector step = (lines.points.row(ends[1]) - lines.points.row(ends[0])).transpose();
        const double cosine = step.dot(along) / step.norm() / along.norm();
        worst = std::max(worst, cosine < 0 ? 2 : std::sqrt(std::max(0.0, 1 - cosine * cosine)));
    }
    return worst;
}

/// The length of each line.
std::vector<double> lengths_of(const Mesh& lines) {
    std::vector<double> result;
    Index last = -1;
    for (const auto& ends : lines.simplices.rowwise()) {
        if (ends[0] != last)
            result.push_back(0);
        result.back() += (lines.points.row(ends[1]) - lines.points.row(ends[0])).norm();
        last = ends[1];
    }
    return result;
}

/// The largest change of the radius along lines around an axis, per length.
double drift(int cells) {
    const auto mesh = discretize(grid(cells, cells));
    const auto turning = sampled(mesh, [](const auto& x) {
        return Vector{{0.5 - x[1], x[0] - 0.5}};
    });
    const auto lines = streamlines(mesh, turning, {.spacing = 0.02});
    const auto radius = [&](Index point) {
        return std::hypot(lines.points(point, 0) - 0.5, lines.points(point, 1) - 0.5);
    };
    double worst = 0, change = 0, length = 0;
    Index last = -1;
    for (const auto& ends : lines.simplices.rowwise()) {
        if (ends[0] != last)
            change = length = 0;
        last = ends[1];
        change += radius(ends[1]) - radius(ends[0]);
        length += (lines.points.row(ends[1]) - lines.points.row(ends[0])).norm();
        if (radius(ends[0]) > 0.1 && radius(ends[0]) < 0.4 && length > 0.2) // away from the rim
            worst = std::max(worst, std::abs(change) / length);
    }
    EXPECT_GT(worst, 0);
    return worst;
}

TEST(Streamlines, DoNotDependOnTheUnitOfTheVectors) {
    for (const Mesh& input : flat_meshes()) {
        const auto mesh = discretize(input);
        const auto vectors = sampled(
            mesh, [&](const auto& x) { return Vector(constant(x.size()) + x.transpose()); });
        const Mesh lines = streamlines(mesh, vectors);
        ASSERT_GT(lines.points.rows(), 0);
        for (const int exponent : {-1000, 1000})
            EXPECT_EQ(streamlines(mesh, std::ldexp(1, exponent) * vectors).points, lines.points)
                << exponent;
    }
}

TEST(Streamlines, OfAConstantFieldAreStraight) {
    for (const Mesh& input : flat_meshes()) {
        const auto mesh = discretize(input);
        const Vector wind = constant(mesh.points().cols());
        const auto lines = streamlines(mesh, sampled(mesh, [&](const auto&) { return wind; }));
        ASSERT_GT(lines.simplices.rows(), 10);
        EXPECT_LE(worst_angle(lines, wind), 1e-6);
        EXPECT_GT(worst_angle(lines, Vector(wind.reverse())), 0.1);
        const Eigen::RowVectorXd low = mesh.points().colwise().minCoeff().array() - 1e-9;
        const Eigen::RowVectorXd high = mesh.points().colwise().maxCoeff().array() + 1e-9;
        for (const auto& point : lines.points.rowwise())
            EXPECT_TRUE((point.array() >= low.array() && point.array() <= high.array()).all());
    }
}

TEST(Streamlines, OfAConstantFieldReachFromSideToSideOnCellsOfAnySize) {
    for (const Index cells : {1, 3, 12})
        for (const double spacing : {4.0 / cells, 1.0 / cells, 0.3 / cells, 0.01 / cells})
            for (const int axis : {0, 1})
                for (const double sign : {1.0, -1.0}) {
                    const auto mesh = discretize(grid(cells, cells));
                    const Vector wind = sign * Vector::Unit(2, axis);
                    const auto lines =
                        streamlines(mesh, sampled(mesh, [&](auto&) { return wind; }),
                                    {.spacing = spacing, .longest = 1e4, .shortest = 0});
                    Index ends = 0;
                    for (const double at : lines.points.col(axis))
                        ends += std::abs(at - 0.5) > 0.5 - 1e-9 ? 1 : 0;
                    EXPECT_GT(ends, 0);
                    EXPECT_NEAR(total_volume(lines), ends / 2.0, 1e-9)
                        << cells << " cells, " << spacing;
                }
}

TEST(Streamlines, OfARotationAreCirclesToSecondOrder) {
    for (const int cells : {12, 24, 48, 96})
        EXPECT_LT(drift(cells) * cells * cells, 0.2) << cells;
}

TEST(Streamlines, OnASphereStayAtTheirHeight) {
    const auto mesh = discretize(icosphere(24));
    const auto lines = streamlines(mesh, sampled(mesh, [](const auto& x) {
                                       return Vector{{-x[1], x[0], 0}};
                                   }));
    ASSERT_GT(lines.simplices.rows(), 1000);
    double worst = 0;
    for (const auto& ends : lines.simplices.rowwise()) {
        const auto step = lines.points.row(ends[1]) - lines.points.row(ends[0]);
        worst = std::max(worst, std::abs(step[2]) / (step.norm() + 1e-6));
        for (const Index end : ends) {
            EXPECT_LE(lines.points.row(end).norm(), 1 + 1e-12);
            EXPECT_GE(lines.points.row(end).norm(), 0.99);
        }
    }
    EXPECT_LT(worst, 0.2);
}

TEST(Streamlines, KeepAway) {
    const auto mesh = discretize(grid(40, 40));
    const DenseMatrix wind = sampled(mesh, [](const auto&) { return Vector{{1, 0}}; });
    for (const double spacing : {0.05, 0.1, 0.2}) {
        const auto lines = streamlines(mesh, wind, {.spacing = spacing});
        EXPECT_NEAR(total_volume(lines) * spacing, 1, 0.3) << "an area of 1, lines this far apart";
    }
    EXPECT_EQ(streamlines(mesh, 0 * wind).simplices.rows(), 0);
    EXPECT_EQ(streamlines(mesh, wind).points, streamlines(mesh, wind).points);
}

TEST(Streamlines, AreNotShorterThanAsked) {
    const auto mesh = discretize(grid(12, 12));
    const auto turning = sampled(mesh, [](const auto& x) {
        return Vector{{0.5 - x[1], x[0] - 0.5}};
    });
    const auto shortest = [&](double asked) {
        const auto lines = streamlines(mesh, turning, {.spacing = 0.05, .shortest = asked});
        const auto lengths = lengths_of(lines);
        return *std::min_element(lengths.begin(), lengths.end()) / 0.05;
    };
    EXPECT_LT(shortest(0), 1);
    for (const double asked : {1, 2, 5})
        EXPECT_GE(shortest(asked), asked);
}

TEST(Streamlines, AreNotLongerThanAsked) {
    for (const Mesh& input : {grid(100, 5, 20, 1), grid(7, 2, 20, 1)}) {
        const auto mesh = discretize(shuffled(input, 1).mesh); // lines start in the middle
        const auto wind = sampled(mesh, [](const auto&) { return Vector{{1, 0}}; });
        for (const double asked : {3, 10, 30}) {
            const auto lines = streamlines(mesh, wind, {.spacing = 0.1, .longest = asked});
            const auto lengths = lengths_of(lines);
            const double longest = *std::max_element(lengths.begin(), lengths.end());
            EXPECT_NEAR(longest, 0.1 * asked, 1e-9);
        }
    }
}

TEST(Streamlines, EndWhereFieldsMeetOrTurnAround) {
    auto meshes = flat_meshes();
    meshes.push_back(torus(24, 12));
    meshes.push_back(icosphere(6));
    for (const Mesh& input : meshes) {
        const auto mesh = discretize(input);
        const Eigen::RowVectorXd middle = mesh.points().colwise().mean();
        std::mt19937 random(1);
        const auto any = [&](const auto& x) {
            return Vector::NullaryExpr(x.size(), [&] { return random() / 2147483648.0 - 1; });
        };
        for (const auto& field :
             {sampled(mesh, [&](const auto& x) { return Vector((middle - x).transpose()); }),
              sampled(mesh, [&](const auto& x) { return Vector((x - middle).transpose()); }),
              sampled(mesh, any), sampled(mesh, any),
              sampled(mesh,
                      [&](const auto& x) { // towards a plane, which cuts through simplices
                          Vector v = Vector::Zero(x.size());
                          v[0] = middle[0] + 0.01 - x[0];
                          return v;
                      }),
              sampled(mesh, [&](const auto& x) { // around, and slowly inwards
                  Vector v = 0.02 * (middle - x).transpose();
                  v[0] -= x[1] - middle[1];
                  v[1] += x[0] - middle[0];
                  return v;
              })}) {
            const auto lines = streamlines(mesh, field, {.shortest = 0});
            EXPECT_GT(lines.simplices.rows(), 0);
            EXPECT_LT(lines.points.rows(), 500 * mesh.input().size(mesh.dimension()));
            EXPECT_TRUE(lines.points.allFinite());
        }
    }
}

TEST(Streamlines, RefuseWhatTheyCannotFollow) {
    const auto mesh = discretize(grid(3, 2));
    DenseMatrix wind = DenseMatrix::Ones(6, 2);
    EXPECT_REFUSED(streamlines(mesh, wind.topRows(2)), "2 vectors", "2 coordinates", "6 2-cells");
    EXPECT_REFUSED(streamlines(mesh, wind, {.spacing = -1}), "streamlines", "-1", "200 spacings");
    EXPECT_REFUSED(streamlines(mesh, wind, {.longest = 1}), "streamlines", "2 to 1 spacings");
    EXPECT_REFUSED(streamlines(mesh, wind, {.shortest = -1}), "streamlines", "-1 to 200 spacings");
    EXPECT_REFUSED(streamlines(mesh, wind, {.shortest = NAN}), "streamlines", "nan to 200");
    wind(4, 1) = NAN;
    EXPECT_REFUSED(streamlines(mesh, wind), "vector", "2-cell 4", "finite");

    // cells of glued meshes have other numbers in the box
    const auto glued = discretize(periodic(grid(4, 4), {Vector{{1, 0}}, Vector{{0, 1}}}));
    for (Index cell = 0; cell < 16; ++cell) {
        DenseMatrix vectors = DenseMatrix::Ones(16, 2);
        vectors(cell, 0) = NAN;
        EXPECT_REFUSED(streamlines(glued, vectors), fmt::format("2-cell {} is", cell));
    }
}

} // namespace polydec::test::in_streamlines
