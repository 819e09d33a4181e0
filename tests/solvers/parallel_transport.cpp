// SPDX-License-Identifier: MIT
#include "tests/solvers/glued_samples.h"

namespace polydec::test::in_parallel_transport {

using Complex = std::complex<double>;

constexpr Index from_0[] = {0};
constexpr double pi = std::numbers::pi;

/// Two triangles that meet at a vertex.
Mesh pinched() {
    return made_of({{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0, 1, 2}, {0, 3, 4}});
}

TangentVectors one_vector(Complex z) {
    return TangentVectors::Constant(1, z);
}

/// The step in the plane along a half-edge; on the unit torus, the short way around.
Complex step(const GluedSample& sample, Index h) {
    Eigen::RowVectorXd d =
        sample.points.row(sample.surface.head(h)) - sample.points.row(sample.surface.tail(h));
    const double length = sample.lengths[sample.surface.edge(h)];
    for (int i = 0; i < 2; ++i)
        if (std::abs(d[i]) > length + 1e-9)
            d[i] -= std::copysign(1.0, d[i]);
    return {d[0], d[1]};
}

/// What the vectors are in the plane.
TangentVectors in_the_plane(const GluedSample& sample, const TangentFrames& frames,
                            const TangentVectors& vectors) {
    TangentVectors result(vectors.size());
    for (Index v = 0; v < vectors.size(); ++v) {
        const Complex along = step(sample, frames.reference[v]);
        result[v] = vectors[v] * along / std::abs(along);
    }
    return result;
}

double spread(const TangentVectors& vectors) {
    return (vectors.array() - vectors[0]).abs().maxCoeff();
}

TEST(TangentFrames, of_flat_surfaces_are_angles_in_the_plane) {
    for (const auto& sample : {flat(5), glued(perturbed(grid(6, 5), 0.3 / 6, 3))}) {
        const auto frames = tangent_frames(sample.surface, sample.lengths);
        for (Index h = 0; h < 3 * sample.surface.triangles(); ++h) {
            const Complex at_tail = step(sample, frames.reference[sample.surface.tail(h)]);
            const Complex at_head = step(sample, frames.reference[sample.surface.head(h)]);
            const Complex along = step(sample, h) / std::abs(step(sample, h));
            EXPECT_LT(std::abs(frames.direction(h) * at_tail / std::abs(at_tail) - along), 1e-12);
            EXPECT_LT(
                std::abs(std::polar(1.0, frames.at_head[h]) * at_head / std::abs(at_head) + along),
                1e-12);
        }
    }
}

/// The sum over the triangles of the angle by which vectors come back turned from around them.
double total_turn(const GluedSample& sample) {
    const auto frames = tangent_frames(sample.surface, sample.lengths);
    double sum = 0;
    for (Index h = 0; h < 3 * sample.surface.triangles(); h += 3)
        sum += std::arg(frames.carried(h) * frames.carried(h + 1) * frames.carried(h + 2));
    return sum;
}

TEST(TangentFrames, turn_vectors_around_triangles_by_the_curvature_of_gauss_and_bonnet) {
    EXPECT_NEAR(total_turn(glued(icosphere(5))), 4 * pi, 1e-11);
    EXPECT_NEAR(total_turn(glued(torus(24, 12))), 0, 1e-11);
    EXPECT_NEAR(total_turn(flat(4)), 0, 1e-11);
    EXPECT_NEAR(total_turn(glued(grid(4, 4))), 0, 1e-11);
    const auto sphere = glued(icosphere(5));
    const auto frames = tangent_frames(sphere.surface, sphere.lengths);
    EXPECT_NEAR((2 * pi - frames.sums.array()).sum(), 4 * pi, 1e-11);
    // carried the wrong way around, they turn the other way
    EXPECT_GT(
        std::abs(std::arg(std::conj(frames.carried(0)) * frames.carried(1) * frames.carried(2))),
        0.1);
}

/// A square grid after x += 2 y: far from Delaunay, with heat below 0.
GluedSample sheared(Index cells) {
    Mesh mesh = grid(cells, cells);
    mesh.points.col(0) += 2 * mesh.points.col(1);
    return glued(mesh);
}

TEST(ParallelTransport, on_flat_surfaces_is_exact) {
    for (const auto& sample : {flat(24), flat(3), glued(perturbed(grid(24, 24), 0.3 / 24, 5)),
                               sheared(10), sheared(30)}) {
        ParallelTransport transport(sample.surface, sample.lengths);
        const TangentVectors vectors = transport.extend(from_0, one_vector({2, -1}));
        EXPECT_LT(spread(in_the_plane(sample, transport.frames(), vectors)), 1e-9);
    }
    // the numbers alone are not the same everywhere: frames differ at the boundary
    const auto square = glued(grid(6, 6));
    EXPECT_GT(
        spread(ParallelTransport(square.surface, square.lengths).extend(from_0, one_vector(1))),
        0.5);
}

/// Mean error on the unit sphere of the vector that is the first reference direction at the vertex
/// 0, against rotation along great circles, except near the antipode.
double error_on_the_sphere(int frequency, double time_scale) {
    const auto sphere = glued(icosphere(frequency));
    ParallelTransport transport(sphere.surface, sphere.lengths, {.time_scale = time_scale});
    const TangentVectors vectors = transport.extend(from_0, one_vector(1));
    const auto point = [&](Index v) { return Eigen::Vector3d(sphere.points.row(v)); };
    const auto reference = [&](Index v) {
        const Eigen::Vector3d p = point(v);
        const Eigen::Vector3d along =
            point(sphere.surface.head(transport.frames().reference[v])) - p;
        return (along - along.dot(p) * p).normalized().eval();
    };
    const Eigen::Vector3d pole = point(0), vector = reference(0);
    double sum = 0;
    int count = 0;
    for (Index v = 0; v < vectors.size(); ++v) {
        const Eigen::Vector3d p = point(v), e = reference(v);
        if (pole.dot(p) < -0.8)
            continue;
        // turned around the axis that turns the pole to p
        const Eigen::Vector3d both = pole + p;
        const Eigen::Vector3d exact =
            vector - vector.dot(both) / (1 + pole.dot(p)) * both + 2 * vector.dot(pole) * p;
        const Eigen::Vector3d found = vectors[v].real() * e + vectors[v].imag() * p.cross(e);
        sum += (found - exact).norm();
        ++count;
    }
    return sum / count;
}

TEST(ParallelTransport, from_a_pole_of_the_sphere_converges_to_that_along_great_circles) {
    // times like the edge length, not like its square, so that waves of the mesh die out
    const double coarse = error_on_the_sphere(8, 4), fine = error_on_the_sphere(32, 16);
    EXPECT_LT(fine, 1e-4);
    EXPECT_GT(std::log2(coarse / fine) / 2, 1.2);
}

TEST(ParallelTransport, with_the_shortest_time_is_near_but_does_not_converge) {
    const double coarse = error_on_the_sphere(8, 1), fine = error_on_the_sphere(32, 1);
    EXPECT_LT(std::max(coarse, fine), 0.002);
    EXPECT_GT(fine, coarse);
}

TEST(ParallelTransport, keeps_the_magnitude_from_one_source) {
    const auto sphere = glued(torus(24, 12));
    const TangentVectors vectors =
        ParallelTransport(sphere.surface, sphere.lengths).extend(from_0, one_vector({3, -4}));
    for (const Complex& vector : vectors)
        EXPECT_NEAR(std::abs(vector), 5, 1e-12);
}

TEST(ParallelTransport, takes_the_magnitude_of_the_nearest_source) {
    const auto square = glued(grid(40, 40));
    ParallelTransport transport(square.surface, square.lengths, {.time_scale = 1});
    // in the same direction, once in the corner of each end of a side
    const Index a = 0;
    Index b = 0;
    for (Index v = 0; v < square.surface.vertices(); ++v)
        if (square.points(v, 0) == 1 && square.points(v, 1) == 0)
            b = v;
    const TangentVectors from_a = transport.extend(from_0, one_vector(1));
    const Index both[] = {a, b};
    const TangentVectors vectors =
        transport.extend(both, TangentVectors{{from_a[a], 3.0 * from_a[b]}});
    for (Index v = 0; v < vectors.size(); ++v) {
        const double x = square.points(v, 0), size = std::abs(vectors[v]);
        EXPECT_GE(size, 1 - 1e-12);
        EXPECT_LE(size, 3 + 1e-12);
        if (x < 0.3) {
            EXPECT_LT(size, 1.01);
        }
        if (x > 0.7) {
            EXPECT_GT(size, 2.99);
        }
        EXPECT_LT(std::abs(vectors[v] / size - from_a[v]), 1e-9);
    }
}

TEST(ParallelTransport, is_linear_in_complex_factors_and_does_not_depend_on_the_unit) {
    const auto sphere = glued(icosphere(6));
    const Index sources[] = {0, 100};
    const TangentVectors given{{Complex(1, 2), Complex(-0.5, 0.25)}};
    const TangentVectors vectors =
        ParallelTransport(sphere.surface, sphere.lengths).extend(sources, given);
    for (const Complex factor : {Complex(0, 1), Complex(1e-150, 1e-150), Complex(3e150, 0)}) {
        const TangentVectors other =
            ParallelTransport(sphere.surface, sphere.lengths).extend(sources, factor * given);
        EXPECT_LT((other / factor - vectors).cwiseAbs().maxCoeff(), 1e-12);
    }
    for (const double scale : {1e-150, 1e-8, 1e8, 1e150}) {
        const TangentVectors other =
            ParallelTransport(sphere.surface, scale * sphere.lengths).extend(sources, given);
        EXPECT_LT((other - vectors).cwiseAbs().maxCoeff(), 1e-12);
    }
    // the other source is no copy of the first
    const TangentVectors swapped =
        ParallelTransport(sphere.surface, sphere.lengths).extend(sources, given.reverse());
    EXPECT_GT((swapped - vectors).cwiseAbs().maxCoeff(), 0.1);
}

TEST(ParallelTransport, is_exact_where_the_heat_is_too_faint_for_numbers) {
    const auto strip = glued(grid(2000, 1, 2000.0, 1.0));
    ParallelTransport transport(strip.surface, strip.lengths);
    const TangentVectors vectors = transport.extend(from_0, one_vector({2, -1}));
    EXPECT_LT(spread(in_the_plane(strip, transport.frames(), vectors)), 1e-6);
}

TEST(ParallelTransport, is_0_where_vectors_cancel_and_where_all_are_0) {
    const auto torus = flat(8);
    ParallelTransport transport(torus.surface, torus.lengths);
    const Index a = torus.surface.tail(0), b = torus.surface.tail(6 * 4 * 8);
    const TangentVectors from_a = transport.extend(from_0, one_vector(1));
    const Index both[] = {a, b};
    const TangentVectors vectors = transport.extend(both, TangentVectors{{from_a[a], -from_a[b]}});
    for (Index v = 0; v < vectors.size(); ++v) {
        EXPECT_TRUE(std::isfinite(std::abs(vectors[v])));
        // the rotation of the torus about this point exchanges both sources
        if (torus.points(v, 0) == 0.25 && torus.points(v, 1) == 0) {
            EXPECT_EQ(vectors[v], Complex(0));
        }
    }
    EXPECT_NEAR(std::abs(vectors[a]), 1, 1e-12);
    EXPECT_EQ(transport.extend(both, TangentVectors::Zero(2)), TangentVectors::Zero(64));
}

TEST(ParallelTransport, refuses_surfaces_without_angles) {
    const auto refused = [](const GluedSample& sample) {
        return refusal([&] {
            ParallelTransport(sample.surface, sample.lengths).extend(from_0, one_vector(1));
        });
    };
    EXPECT_SAYS(refused(flat(2, Closing::klein_bottle)), "one-sided", "edge 8", "vertex 1", "3");
    EXPECT_SAYS(refused(glued(moebius(9, 2))), "one-sided");
    GluedSample turned = flat(2);
    turned.surface.reverse(3);
    EXPECT_SAYS(refused(turned), "triangles 0", "3", "edge 0", "orientations");
    EXPECT_SAYS(refused(glued(pinched())), "vertex 0", "fans", "1 of 2 corners");
    EXPECT_EQ(refused(flat(2)), "accepted");
}

TEST(ParallelTransport, refuses_vectors_that_make_no_sense) {
    const auto torus = flat(3);
    const auto refused = [&](std::vector<Index> sources, const TangentVectors& vectors) {
        return refusal(
            [&] { ParallelTransport(torus.surface, torus.lengths).extend(sources, vectors); });
    };
    EXPECT_SAYS(refused({0, 1}, one_vector(1)), "1 vectors", "2 sources");
    EXPECT_SAYS(refused({4, 4}, TangentVectors::Ones(2)), "vertex 4", "source", "twice");
    EXPECT_SAYS(refused({4}, one_vector({1, NAN})), "vector", "vertex 4", "(1, nan)");
    EXPECT_SAYS(refused({9}, one_vector(1)), "vertex 9", "source", "0", "8");
    EXPECT_SAYS(refused({}, TangentVectors(0)), "source", "vertex 0");
    EXPECT_REFUSED(ParallelTransport(torus.surface, torus.lengths, {.time_scale = 0}), "time scale",
                   "0", "1e-6", "1e6");
    EXPECT_EQ(refused({8}, one_vector(1)), "accepted");
}

TEST(ParallelTransport, names_vertices_by_their_numbers_in_the_mesh) {
    const auto refused = [](const Mesh& mesh, const std::vector<Index>& sources, Index named) {
        const SimplicialComplex complex(Simplices(mesh.simplices.array() + 10)); // 0 to 9 unused
        const Vector lengths = edge_lengths(complex, mesh.points);
        try {
            ParallelTransport(GluedSurface(complex), lengths)
                .extend(sources, TangentVectors::Ones(static_cast<Index>(sources.size())));
        } catch (const InvalidInput& error) {
            EXPECT_EQ(error.place().vertices.front(), named);
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_SAYS(refused(pinched(), {0}, 10), "vertex 10", "fans");
    EXPECT_SAYS(refused(grid(2, 2), {4, 4}, 14), "vertex 14", "source", "twice");
    EXPECT_SAYS(refused(grid(2, 2), {}, 10), "source", "vertex 10");
    EXPECT_SAYS(refused(moebius(24, 2), {0}, 79), "one-sided", "vertex 79 to 80");
}

} // namespace polydec::test::in_parallel_transport
