// SPDX-License-Identifier: MIT
#include "tests/shape/known_shapes.h"
#include "tests/solvers/glued_samples.h"

namespace polydec::test::in_exact_distance {

Vector from(const MeasuredSurface& shape, std::vector<Index> sources) {
    return exact_distance(shape.surface, shape.lengths, sources);
}

Vector from(const GluedSample& sample, std::vector<Index> sources) {
    return exact_distance(sample.surface, sample.lengths, sources);
}

/// Points in the plane and their distances from all images of another one, the least.
double from_images(const Eigen::Vector2d& x, const std::vector<Eigen::Vector2d>& images) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& image : images)
        least = std::min(least, (x - image).norm());
    return least;
}

TEST(ExactDistance, on_flat_tori_is_the_shortest_to_an_image) {
    for (const Index n : {1, 2, 3, 7, 12})
        for (const Closing closing : {Closing::torus, Closing::klein_bottle}) {
            const auto torus = flat(n, closing);
            const Index source = n * n / 3;
            const Vector d = from(torus, {source});
            std::vector<Eigen::Vector2d> images;
            for (int i = -2; i <= 2; ++i)
                for (int j = -2; j <= 2; ++j) {
                    const bool turns = closing == Closing::klein_bottle && i % 2 != 0;
                    images.emplace_back(torus.points(source, 0) + i,
                                        (turns ? -1 : 1) * torus.points(source, 1) + j);
                }
            for (Index v = 0; v < d.size(); ++v)
                EXPECT_NEAR(d[v], from_images(torus.points.row(v).transpose(), images), 1e-14);
        }
}

TEST(ExactDistance, between_opposite_corners_of_a_cube_is_the_root_of_5) {
    for (const int n : {1, 2, 5}) {
        const Mesh mesh = cube_surface(n);
        const MeasuredSurface shape = test::measured(mesh);
        const Index corner = vertex_at(shape, mesh, Eigen::Vector3d::Zero());
        EXPECT_NEAR(from(shape, {corner})[vertex_at(shape, mesh, Eigen::Vector3d::Ones())],
                    std::sqrt(5.0), 1e-14)
            << n;
    }
}

/// The plane folded onto a regular tetrahedron by half turns about the points of a lattice.
TEST(ExactDistance, on_the_regular_tetrahedron_is_that_in_the_plane_folded_onto_it) {
    const Eigen::Vector2d a(1, 0), b(0.5, std::sqrt(0.75));
    const double s = 1 / std::sqrt(8.0);
    const DenseMatrix corners{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
    const Mesh mesh = tetrahedron_surface(6);
    const MeasuredSurface shape = test::measured(mesh);
    // a place of each vertex by barycentric coordinates, of the corners 0, a, b, a + b: on two of
    // the faces the first one is at 2 a or 2 b
    std::vector<Eigen::Vector2d> places;
    for (Index v = 0; v < shape.surface.vertices(); ++v) {
        const Vector w = (2 * corners * place(shape, mesh, v)).array() + 0.25;
        const Eigen::Vector2d first = w[1] < 1e-9   ? 2 * b
                                      : w[2] < 1e-9 ? 2 * a
                                                    : Eigen::Vector2d(0 * a);
        places.push_back(w[0] * first + w[1] * a + w[2] * b + w[3] * (a + b));
    }
    for (Index source = 0; source < shape.surface.vertices(); source += 5) {
        std::vector<Eigen::Vector2d> images;
        for (int i = -4; i <= 4; ++i)
            for (int j = -4; j <= 4; ++j)
                for (const int sign : {1, -1})
                    images.push_back(sign * places[source] + 2 * i * a + 2 * j * b);
        const Vector d = from(shape, {source});
        for (Index v = 0; v < d.size(); ++v)
            EXPECT_NEAR(d[v], from_images(places[v], images), 1e-13);
    }
}

TEST(ExactDistance, on_cones_is_straight_or_through_the_tip) {
    constexpr double pi = std::numbers::pi;
    constexpr Index sectors = 12, rings = 5;
    for (const double angle : {0.01, 1.0, pi, 1.9 * pi, 2 * pi, 2.1 * pi, 3 * pi, 7 * pi}) {
        const MeasuredSurface shape = cone(angle, sectors, rings);
        for (const Index source : {Index(0), Index(1 + 2 * sectors), 4 * sectors}) {
            const Vector d = from(shape, {source});
            const auto radius = [](Index v) { return v == 0 ? 0 : 1 + (v - 1) / sectors; };
            for (Index v = 0; v < d.size(); ++v) {
                const Index steps = std::abs((v - 1) % sectors - (source - 1) % sectors);
                const double between =
                    double(std::min(steps, sectors - steps)) * angle / double(sectors);
                const double r = double(radius(v)), s = double(radius(source));
                const double exact =
                    between >= pi ? r + s
                                  : std::hypot(r - s, 2 * std::sin(between / 2) * std::sqrt(r * s));
                EXPECT_NEAR(d[v], exact, 1e-13) << angle << " " << source << " " << v;
            }
        }
    }
}

TEST(ExactDistance, crosses_the_spine_of_a_book_straight_into_every_page) {
    const Mesh mesh = book_of(grid(4, 4), {0.1, 1.5, 4.0, 5.0});
    const MeasuredSurface shape = test::measured(mesh);
    for (Index source = 0; source < shape.surface.vertices(); source += 7) {
        const Vector d = from(shape, {source});
        const Eigen::Vector3d p = mesh.points.row(shape.vertices[source]).transpose();
        for (Index v = 0; v < d.size(); ++v) {
            const Eigen::Vector3d q = mesh.points.row(shape.vertices[v]).transpose();
            const double r = p.head<2>().norm(), s = q.head<2>().norm();
            const bool same_page = (s * p.head<2>() - r * q.head<2>()).norm() < 1e-12;
            EXPECT_NEAR(d[v], std::hypot(p[2] - q[2], same_page ? r - s : r + s), 1e-14);
        }
    }
}

TEST(ExactDistance, from_all_the_boundary_of_a_square_is_that_to_the_nearest_side) {
    const auto square = glued(grid(4, 4));
    std::vector<Index> boundary;
    const auto to_side = [&](Index v) {
        return std::min(square.points.row(v).minCoeff(), 1 - square.points.row(v).maxCoeff());
    };
    for (Index v = 0; v < square.surface.vertices(); ++v)
        if (to_side(v) == 0)
            boundary.push_back(v);
    const Vector d = from(square, boundary);
    for (Index v = 0; v < d.size(); ++v)
        EXPECT_NEAR(d[v], to_side(v), 1e-15);
}

TEST(ExactDistance, in_the_plane_is_straight_on_any_triangles_and_bends_around_holes) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto plane = glued(shaken_inside(grid(14, 9), 0.03, seed)); // its boundary is convex
        for (const Index source : {0, 71}) {
            const Vector d = from(plane, {source});
            for (Index v = 0; v < d.size(); ++v)
                EXPECT_NEAR(d[v], (plane.points.row(v) - plane.points.row(source)).norm(), 1e-13);
        }
    }
    // a square without its upper right quarter: its corner at (1/2, 1/2) is in the way
    const Mesh mesh = without(grid(8, 8), [](const Vector& x) { return x.minCoeff() > 0.5; });
    const MeasuredSurface shape = test::measured(mesh);
    const auto place = [&](Index v) -> Eigen::RowVector2d {
        return mesh.points.row(shape.vertices[v]);
    };
    const Eigen::RowVector2d corner(0.5, 0.5);
    for (Index source = 0; source < shape.surface.vertices(); source += 11) {
        const Vector d = from(shape, {source});
        for (Index v = 0; v < d.size(); ++v) {
            const Eigen::RowVector2d p = place(source) - corner, q = place(v) - corner;
            // one is above, one to the right, and the line between them passes through what lacks
            const double turn = p[0] * q[1] - p[1] * q[0];
            const bool in_the_way =
                (p[1] > 0 && q[0] > 0 && turn < 0) || (q[1] > 0 && p[0] > 0 && turn > 0);
            EXPECT_NEAR(d[v], in_the_way ? p.norm() + q.norm() : (p - q).norm(), 1e-14);
        }
    }
}

TEST(ExactDistance, does_not_mind_needles) {
    for (const double width : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const auto thin = glued(with_needle(width));
        const Vector d = from(thin, {0});
        for (Index v = 0; v < d.size(); ++v)
            EXPECT_NEAR(d[v], thin.points.row(v).norm(), 1e-12) << width << " " << v;
    }
}

/// Strips in a circle, a hundred thousand times as long as wide.
TEST(ExactDistance, is_no_longer_than_ways_along_edges_where_all_triangles_are_needles) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    int answered = 0;
    for (int trial = 0; trial < 50; ++trial) {
        Mesh strip{Points(9, 2), Simplices(9, 3), {}};
        for (Index v = 0; v < 9; ++v) {
            strip.points.row(v) << 1e-6 * (v % 3 + number(random)),
                std::round(3 * number(random)) + 1e-5 * number(random);
            strip.simplices.row(v) << v, (v + 1) % 9, (v + 2) % 9;
        }
        const MeasuredSurface surface = measured(divided(divided(strip)));
        Vector d;
        if (refusal([&] { d = from(surface, {0}); }) != "accepted")
            continue; // by chance a triangle has no area
        ++answered;
        for (Index h = 0; h < 3 * surface.surface.triangles(); ++h) {
            const Index v = surface.surface.tail(h), w = surface.surface.tail(Triangles::next(h));
            EXPECT_LE(std::abs(d[v] - d[w]),
                      surface.lengths[surface.surface.edge(h)] * (1 + 1e-9) + 1e-12);
        }
    }
    EXPECT_GT(answered, 25);
}

TEST(ExactDistance, is_kept_by_intrinsic_flips) {
    for (const Mesh& mesh : {perturbed(torus(14, 8), 0.15, 1), perturbed(uv_sphere(9, 12), 0.05, 3),
                             perturbed(moebius(12, 2), 0.1, 4), perturbed(grid(9, 9), 0.05, 2)}) {
        const auto sample = glued(mesh);
        const auto flipped = intrinsic_delaunay(sample.surface, sample.lengths);
        EXPECT_GT(flipped.statistics.flips, 0);
        for (const Index source : {0, 13}) {
            const Vector d = from(sample, {source});
            const Vector e =
                exact_distance(flipped.surface, flipped.lengths, std::vector<Index>{source});
            EXPECT_LT((d - e).cwiseAbs().maxCoeff(), 1e-12);
        }
    }
}

} // namespace polydec::test::in_exact_distance
