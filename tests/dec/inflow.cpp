// SPDX-License-Identifier: MIT
#include "dec/metric/subsets.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_inflow {

/// Of functions, by a field that flows in and out wherever it likes.
class Inflow : public OverMeshes {
protected:
    Points field() const { return random_field(simplices(), 7); }
    const Discretization& simplices() const {
        return discretized(GetParam(), MergeCriterion::none);
    }
    SparseMatrix L() const { return lie_derivative(simplices(), field(), 0, Sampling::upwind); }
    SparseMatrix rates() const { return inflow(simplices(), field(), 0); }
};

/// The largest size of values that begin with sizes up to 1, carried for many steps at the limit,
/// with the same values outside all the time.
double largest_ever(const SparseMatrix& L, const SparseMatrix& rates, const Vector& outside) {
    const double time = 1 / std::max(Vector(L.diagonal()).maxCoeff(), 1e-300);
    Vector u = random_vector(static_cast<Index>(L.rows()), 3);
    double result = 0;
    for (int step = 0; step < 300; ++step) {
        u -= time * (L * u - rates * outside);
        result = std::max(result, u.cwiseAbs().maxCoeff());
    }
    return result;
}

TEST_P(Inflow, brings_nothing_where_nothing_is_given_and_else_what_is_given) {
    const Vector zero = Vector::Zero(L().rows());
    for (const double g : {0.0, 0.5, 1.0})
        EXPECT_LE(largest_ever(L(), rates(), zero.array() + g), 1 + 1e-12) << g;
    if (largest(rates()) > 0) {
        EXPECT_GT(largest_ever(L(), rates(), zero.array() + 3), 1.1);
        EXPECT_LE(largest_ever(L(), rates(), zero.array() + 3), 3 + 1e-12);
    }
}

TEST_P(Inflow, keeps_what_is_the_same_inside_and_outside) {
    const Vector ones = Vector::Ones(L().rows());
    EXPECT_WITHIN(L() * ones, rates() * ones, 1e-12 * largest(L()));
}

TEST_P(Inflow, is_on_the_boundary_alone) {
    const auto boundary = boundary_cells(mesh().K());
    for (int k = 0; k <= mesh().n(); ++k) {
        const Vector rate = inflow(simplices(), field(), k).diagonal();
        for (Index s = 0; s < rate.size(); ++s)
            EXPECT_TRUE(rate[s] == 0 || (rate[s] > 0 && boundary[k][s]));
    }
}

/// Of n-forms that are nowhere negative, on coherently oriented cells.
TEST_P(Inflow, never_makes_more_of_a_density) {
    const int n = mesh().n();
    const SparseMatrix L = lie_derivative(simplices(), field(), n, Sampling::upwind);
    const Vector gain = -(Eigen::RowVectorXd::Ones(L.rows()) * L).transpose();
    if (mesh().K().orientable() && is_flat(mesh_named(GetParam()))) {
        EXPECT_LE(gain.maxCoeff(), 1e-12 * largest(L));
    }
}

/// The inflow rates of functions along the same vector everywhere.
Vector rates_along(const Mesh& mesh, const Vector& X) {
    const auto made = circumcentric(mesh, {MergeCriterion::none});
    return inflow(made, X.transpose().replicate(made.points().rows(), 1), 0).diagonal();
}

TEST_P(Inflow, does_not_depend_on_numbers_or_the_unit_of_length) {
    const Mesh usual = mesh_named(GetParam());
    const auto N = static_cast<Index>(usual.points.cols());
    for (const Vector& X : {Vector(Vector::Unit(N, 0)), random_vector(N, 7)}) {
        const Vector expected = rates_along(usual, X);
        if (expected.size() < usual.points.rows())
            continue; // no cell uses some vertex
        Renumbered other = shuffled(usual, 5);
        other.mesh.points *= 0.3;
        const Vector rates = rates_along(other.mesh, X);
        EXPECT_CLOSE(rates, expected(other.vertices) / 0.3, 1e-9);
    }
}

POLYDEC_OVER_MESHES(Inflow);

TEST(InflowAlongAVector, is_the_same_at_all_vertices_within_a_side_of_a_grid) {
    for (const int n : {1, 2, 3, 4})
        for (int seed = 0; seed < 10; ++seed) {
            Vector X = random_vector(n, 40 + seed);
            if (seed < 3) // inwards, and along diagonals
                X = X.unaryExpr([&](double x) { return x < 0.9 - 0.6 * seed ? 0.0 : 1.0; });
            X[0] = 1;
            const Mesh mesh = kuhn(n, n < 4 ? 5 : 3);
            const Vector rates = rates_along(mesh, X);
            Index first = -1;
            for (Index v = 0; v < rates.size(); ++v) {
                const auto place = mesh.points.row(v);
                const auto along = place.tail(n - 1);
                if (place[0] > 0 || (along.array() < 1e-9).any() ||
                    (along.array() > 1 - 1e-9).any())
                    continue;
                first = first < 0 ? v : first;
                EXPECT_NEAR(rates[v], rates[first], 1e-9 * rates[first]) << n << ' ' << seed;
            }
            EXPECT_GT(rates[first], 0);
        }
}

/// Distance of v from the cone of the rows, by all of its faces.
double distance_from_cone(const DenseMatrix& rows, const Vector& v) {
    double least = v.norm();
    for (int k = 1; k <= rows.rows(); ++k)
        for (const auto& face : subsets(static_cast<int>(rows.rows()), k)) {
            const DenseMatrix edges = rows(face, Eigen::indexing::all).transpose();
            const Vector weights = edges.colPivHouseholderQr().solve(v);
            if (weights.minCoeff() >= 0)
                least = std::min(least, (edges * weights - v).norm());
        }
    return least;
}

/// A vertex v of an n-simplex: its distance from -X, seen from v, and the slope of f along X there.
struct Seen {
    Index v;
    double distance, volume, slope;
};

std::vector<Seen> seen_along(const Discretization& mesh, const Points& field, const Vector& f) {
    const int n = mesh.dimension();
    std::vector<Seen> result;
    for (Index t = 0; t < mesh.complex().size(n); ++t)
        for (int corner = 0; corner <= n; ++corner) {
            const auto corners = mesh.input().simplices(n).row(t);
            const Index v = corners[corner];
            DenseMatrix edges(n, space(mesh));
            Vector differences(n);
            for (int i = 0; i < n; ++i) {
                const Index q = corners[(corner + i + 1) % (n + 1)];
                edges.row(i) = mesh.points().row(q) - mesh.points().row(v);
                differences[i] = f[q] - f[v];
            }
            const Vector X = field.row(v);
            result.push_back({v, distance_from_cone(edges, -X), mesh.volumes().primal(n)[t],
                              (pseudo_inverse(edges).transpose() * X).dot(differences)});
        }
    return result;
}

TEST(InteriorProductsUpwind, take_the_simplices_nearest_to_the_opposite_of_the_field) {
    for (const char* name : {"segments4", "grid4", "wellcentred4", "obtuse_planar", "bcc2", "kuhn3",
                             "kuhn4", "icosphere3"}) {
        const auto& mesh = discretized(name, MergeCriterion::none);
        const Index vertices = mesh.complex().size(0);
        const Points field = random_field(mesh, 8);
        const Vector f = random_vector(vertices, 9);
        const auto seen = seen_along(mesh, field, f);
        Vector sums = 0 * f, volumes = 0 * f, least = Vector::Constant(vertices, INFINITY);
        for (const Seen& each : seen)
            least[each.v] = std::min(least[each.v], each.distance);
        for (const auto& [v, distance, volume, slope] : seen)
            if (distance <= least[v] + 1e-12) {
                sums[v] += volume * slope;
                volumes[v] += volume;
            }
        const Vector found = interior_product(mesh, field, 1, Sampling::upwind) *
                             (derivative(mesh.complex(), 0) * f);
        EXPECT_CLOSE(found, sums.cwiseQuotient(volumes), 1e-9) << name;
    }
}

/// Taken from the nearest simplex instead of from outside, values grow without bound.
TEST(InflowBroken, by_the_nearest_simplex_grows) {
    for (const char* name : {"segments4", "grid4", "wellcentred4", "kuhn3"}) {
        const auto& mesh = merged(name);
        Points wind = -mesh.points; // inwards from everywhere, and the faster the farther out
        wind.rowwise() += mesh.points.colwise().mean();
        const SparseMatrix L =
            interior_product(discretized(name, MergeCriterion::none), wind, 1, Sampling::upwind) *
            derivative(mesh.K(), 0);
        const SparseMatrix none(L.rows(), L.cols());
        EXPECT_GT(largest_ever(L, none, Vector::Zero(L.rows())), 1e9) << name;
    }
}

} // namespace polydec::test::in_inflow
