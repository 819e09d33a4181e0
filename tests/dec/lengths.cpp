// SPDX-License-Identifier: MIT
#include "dec/merging/lift.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/dual_parts.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_lengths {

class Lengths : public OverMeshes {
protected:
    const SimplicialComplex& K() const { return mesh().K(); }
    SimplexMetric metric() const { return {K(), lengths_}; }

private:
    Vector lengths_ = edge_lengths(K(), mesh().points);
};

TEST_P(Lengths, of_edges_are_there_at_extreme_sizes) {
    const Vector usual = edge_lengths(K(), mesh().points);
    for (const int exponent : {-700, 700}) {
        const double size = std::ldexp(1.0, exponent);
        EXPECT_EQ(edge_lengths(K(), size * mesh().points), size * usual);
    }
}

/// The worst ratio of circumradius and shortest edge: lengths with a relative error eps give a
/// direction of the shortest edge with an error eps times this, and duals no better.
double worst_shape(const SimplicialComplex& K, const SimplexMetric& metric) {
    const Vector radii = circumradii(K, metric, K.dimension());
    const Vector lengths = 2 * circumradii(K, metric, 1);
    double worst = 1;
    for (Index t = 0; t < K.size(K.dimension()); ++t)
        for (int i = 0; i <= K.dimension(); ++i)
            for (int j = i + 1; j <= K.dimension(); ++j)
                worst = std::max(
                    worst, radii[t] / lengths[face_at(K, K.dimension(), t, std::array{i, j})]);
    return worst;
}

/// Largest difference in any degree of primal or dual volumes, relative to the largest volume.
double difference(const CellVolumes& a, const CellVolumes& b) {
    double worst = 0;
    for (int k = 0; k <= b.dimension(); ++k)
        worst = std::max({worst, relative_difference(a.primal(k), b.primal(k)),
                          relative_difference(a.dual(k), b.dual(k))});
    return worst;
}

TEST_P(Lengths, give_the_volumes_that_points_give) {
    const double shape = worst_shape(K(), metric());
    EXPECT_LE(difference(circumcentric_volumes(K(), metric()), mesh().input_volumes),
              1e-14 * shape * shape)
        << shape;
}

TEST(Lengths, know_the_planes_of_the_boundary_of_flat_boxes_by_angles) {
    // halves of octahedra meet at the edges of the box, where their triangles' centers coincide
    const auto& box = merged("fcc1");
    const Vector lengths = edge_lengths(box.K(), box.points);
    const auto result = merge_cospherical(
        {box.K(), SimplexMetric(box.K(), lengths), box.input_volumes}, {.tolerance = tolerance});
    EXPECT_EQ(result.merging.merged().size(2), box.P().size(2));
    EXPECT_EQ(result.merging.merged().size(3), box.P().size(3));
}

TEST_P(Lengths, give_the_kinds_of_pairs_that_points_give) {
    const auto ours = facet_kinds({K(), metric(), circumcentric_volumes(K(), metric())});
    EXPECT_EQ(counts(ours), counts(facet_kinds(mesh().geometry())));
}

TEST_P(Lengths, give_the_lift_that_points_give) {
    const auto ours = commuting_lift(mesh().merging(),
                                     {mesh().merging().pieces(), metric(), mesh().input_volumes});
    const auto theirs = commuting_lift(mesh().merging(), mesh().geometry());
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_CLOSE(ours[k], theirs[k], 1e-12) << k;
}

/// By how much inverting amplifies rounding.
double condition(const Vector& values) {
    return values.cwiseAbs().maxCoeff() / values.cwiseAbs().minCoeff();
}

/// The simplices with this metric and these volumes.
Discretization measured(const SimplicialComplex& K, const SimplexMetric& metric,
                        const CellVolumes& volumes) {
    const Geometry geometry(K, metric, volumes);
    return Discretization({.input = geometry,
                           .passage = Passage(K),
                           .merged = {Merging(K), geometry, volumes},
                           .input_points = std::make_shared<const Points>(K.size(0), 0),
                           .options = {.star = StarKind::circumcentric}});
}

TEST_P(Lengths, give_the_parts_of_duals_and_the_products_that_points_give) {
    const double shape = worst_shape(K(), metric());
    const int n = mesh().n();
    const auto& volumes = mesh().input_volumes;
    for (int k = 0; k <= n; ++k)
        EXPECT_CLOSE(dual_parts({K(), metric(), volumes}, {}, k, n),
                     dual_parts({K(), mesh().points, volumes}, {}, k, n), 2e-14 * n * shape * shape)
            << k;
    const Discretization ours = measured(K(), metric(), volumes),
                         theirs = measured(K(), mesh().points, volumes);
    for (const int k : {0, n - 1}) {
        const Cochain a{Side::primal, k, random_vector(K().size(k), 1)};
        const Cochain b{Side::primal, n - k, random_vector(K().size(n - k), 2)};
        EXPECT_CLOSE(wedge(ours, a, b, WedgeWeights::circumcentric).values,
                     wedge(theirs, a, b, WedgeWeights::circumcentric).values,
                     1e-13 * shape * shape);
    }
    if (!star(volumes, 1).zeros().empty() || !star(volumes, n - 1).zeros().empty())
        return; // no inverse star to make the dual product of
    const Cochain a{Side::dual, 1, random_vector(K().size(n - 1), 3)};
    const Cochain b{Side::dual, n - 1, random_vector(K().size(1), 4)};
    EXPECT_CLOSE(dual_wedge(ours, a, b).values, dual_wedge(theirs, a, b).values,
                 1e-13 * shape * shape * condition(volumes.dual(1)) *
                     condition(volumes.dual(n - 1)));
}

/// Relative defect of sum |s||*s| = C(n,k) |K|, against what is added.
double identity_defect(const Vector& primal, const CellVolumes& volumes, int k) {
    const int n = volumes.dimension();
    const double expected = binomial(n, k) * volumes.primal(n).sum();
    const double added = primal.cwiseProduct(volumes.dual(k)).cwiseAbs().sum();
    return std::abs(primal.dot(volumes.dual(k)) - expected) / (added + expected);
}

/// The lengths changed at random, by one percent unless some simplex cannot bear it.
Vector disturbed(const SimplicialComplex& K, const Vector& lengths) {
    for (double size = 0.01;; size /= 2) {
        const Vector result =
            lengths.cwiseProduct(Vector::Ones(lengths.size()) +
                                 size * random_vector(static_cast<Index>(lengths.size()), 5));
        const auto verdict = refusal([&] { circumcentric_volumes(K, {K, result}); });
        if (verdict == "accepted" || size < 1e-4)
            return result;
    }
}

TEST_P(Lengths, that_come_from_no_points_give_duals_that_fill_the_complex_binomially_often) {
    const Vector lengths = disturbed(K(), *metric().lengths());
    const auto volumes = circumcentric_volumes(K(), {K(), lengths});
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_LE(identity_defect(volumes.primal(k), volumes, k), 1e-13) << k;
}

TEST_P(Lengths, disturbed_give_other_duals_that_do_not_go_with_the_volumes_before) {
    const Vector lengths = disturbed(K(), *metric().lengths());
    const auto volumes = circumcentric_volumes(K(), {K(), lengths});
    EXPECT_GT(difference(volumes, mesh().input_volumes), 1e-5);
    EXPECT_GT(identity_defect(mesh().input_volumes.primal(1), volumes, 1), 1e-7);
}

POLYDEC_OVER_MESHES(Lengths);

/// The n-torus of N^n cubes of side h, each split like Kuhn's: it has no flat place in R^m, m < 2n,
/// but lengths.
LengthMesh flat_torus(int n, int N, double h) {
    std::vector<Vector> steps = unit_translations(n, n);
    for (Vector& step : steps)
        step *= N * h;
    return periodic(kuhn(std::vector(n, N), std::vector(n, N * h)), steps).quotient;
}

/// Eigenvalues of the periodic grid: sums over the axes of (2 - 2 cos(2 pi j / N)) / h^2, each
/// C(n, k) times for k-forms.
Vector eigenvalues_of_grid(int n, int N, double h, int k) {
    std::vector<double> values;
    for (int cell = 0; cell < std::lround(std::pow(N, n)); ++cell) {
        double sum = 0;
        for (int axis = 0, rest = cell; axis < n; ++axis, rest /= N)
            sum += (2 - 2 * std::cos(2 * std::acos(-1.0) * (rest % N) / N)) / (h * h);
        values.insert(values.end(), static_cast<std::size_t>(std::lround(binomial(n, k))), sum);
    }
    std::sort(values.begin(), values.end());
    return Eigen::Map<const Vector>(values.data(), static_cast<Index>(values.size()));
}

TEST(FlatTori, known_by_lengths_alone_merge_to_cubes_with_the_spectrum_of_the_grid) {
    for (const auto& [n, N, h] : {std::tuple{2, 5, 0.5}, {3, 3, 2.0}, {4, 3, 1.0}}) {
        const auto torus = circumcentric(flat_torus(n, N, h));
        for (int k = 0; k <= n; ++k) {
            ASSERT_EQ(torus.size(k), std::lround(binomial(n, k) * std::pow(N, n)));
            const double entry = std::pow(h, n - 2 * k);
            EXPECT_LE((star(torus, k).diagonal().array() / entry - 1).abs().maxCoeff(), 1e-13);
            if (torus.size(k) > 100)
                continue; // dense matrices
            const DenseMatrix A = symmetric_laplacian(torus, k).matrix() / entry;
            const Vector found = Eigen::SelfAdjointEigenSolver<DenseMatrix>(A).eigenvalues();
            const Vector expected = eigenvalues_of_grid(n, N, h, k);
            EXPECT_WITHIN(found, expected, 1e-13 * expected.maxCoeff());
        }
    }
}

TEST(FlatToriBroken, with_one_edge_too_long_keep_simplices_and_lose_the_spectrum) {
    LengthMesh lengths = flat_torus(2, 5, 1);
    Index side = 0;
    lengths.lengths.minCoeff(&side);
    lengths.lengths[side] *= 1.01;
    const auto torus = circumcentric(lengths);
    EXPECT_EQ(torus.size(2), 27); // the two squares beside the edge stay split
    const DenseMatrix A = symmetric_laplacian(torus, 0).matrix();
    const Vector found = Eigen::SelfAdjointEigenSolver<DenseMatrix>(A).eigenvalues();
    EXPECT_GT((found - eigenvalues_of_grid(2, 5, 1, 0)).cwiseAbs().maxCoeff(), 1e-3);
}

/// One simplex with these lengths of edges, in lexicographic order.
std::string refused(int n, const std::vector<double>& lengths) {
    Simplices simplex(1, n + 1);
    std::iota(simplex.data(), simplex.data() + simplex.size(), 3);
    const SimplicialComplex K(simplex);
    const Vector values = Eigen::Map<const Vector>(lengths.data(), Index(lengths.size()));
    return refusal([&] { circumcentric_volumes(K, {K, values}); });
}

TEST(LengthsOf, an_equilateral_simplex_are_accepted) {
    for (int n = 1; n <= 5; ++n)
        EXPECT_EQ(refused(n, std::vector<double>(n * (n + 1) / 2, 1.0)), "accepted");
    EXPECT_EQ(refused(2, {3, 4, 5}), "accepted");
    EXPECT_EQ(refused(2, {1e-5, 1, 1}), "accepted");
}

TEST(LengthsOf, edges_that_none_has_are_refused) {
    EXPECT_SAYS(refused(2, {1, 1}), "2 lengths", "3 edges");
    EXPECT_SAYS(refused(2, {1, 0, 1}), "edge 1", "vertices 3", "5", "length 0");
    EXPECT_SAYS(refused(2, {1, 1, -2.5}), "edge 2", "vertices 4", "5", "length", "-2.5");
    EXPECT_SAYS(refused(2, {1, 1, std::numeric_limits<double>::infinity()}), "edge 2", "vertices 4",
                "5", "length", "inf");
    EXPECT_SAYS(refused(2, {std::numeric_limits<double>::quiet_NaN(), 1, 1}), "edge 0",
                "vertices 3", "4", "length", "nan");
    EXPECT_SAYS(refused(2, {1e-120, 1, 1}), "edge 0", "vertices 3", "4", "length", "1e-120",
                "scale");
}

TEST(LengthsOf, simplices_that_none_has_are_refused_in_the_least_dimension) {
    EXPECT_SAYS(refused(2, {1, 2.5, 1}), "2-simplex 0", "vertices 3, 4, 5", "triangle inequality",
                "2.5", "1", "1");
    EXPECT_SAYS(refused(3, {1, 1, 1, 1, 1, 2.5}), "2-simplex 2", "vertices 3, 5, 6",
                "triangle inequality", "2.5", "1", "1");
    EXPECT_SAYS(refused(2, {1, 2, 1}), "2-simplex 0", "vertices 3, 4, 5", "1, 1 and 2", "area");
    // all triangles exist; two of them unfolded end less than 1.9 apart
    EXPECT_SAYS(refused(3, {1, 1, 1, 1, 1, 1.9}), "3-simplex 0", "vertices 3, 4, 5, 6", "volume");
    EXPECT_SAYS(refused(3, {1, 1, 1, 1, 1, std::sqrt(3.0)}), "3-simplex 0", "vertices 3, 4, 5, 6",
                "volume");
    EXPECT_EQ(refused(3, {1, 1, 1, 1, 1, 1.7}), "accepted");
    // all tetrahedra exist: heights sqrt(2/3) on both sides of one are the most
    EXPECT_SAYS(refused(4, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1.65}), "4-simplex 0",
                "vertices 3, 4, 5, 6, 7", "volume");
    EXPECT_EQ(refused(4, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1.6}), "accepted");
}

TEST(LengthsOf, another_complex_are_refused) {
    const auto& small = merged("grid4");
    const auto& other = merged("hex4");
    const Vector lengths = edge_lengths(small.K(), small.points);
    EXPECT_REFUSED(circumcentric_volumes(other.K(), {small.K(), lengths}), "56 lengths",
                   std::to_string(other.K().size(1)), "edges");
}

} // namespace polydec::test::in_lengths
