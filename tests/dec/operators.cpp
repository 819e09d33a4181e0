// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_operators {

class Operators : public OverMeshes {};

constexpr double rounding = 1e-11;

/// Calls law(metric, k) for K and P and every degree for which star_(k-1) .. star_(k+1) can be
/// inverted.
template <class Law>
void for_invertible(const Merged& mesh, Law law) {
    for (const auto& metric : both(mesh))
        for (int k = 0; k <= mesh.n(); ++k) {
            bool all = true;
            for (int j = std::max(k - 1, 0); j <= std::min(k + 1, mesh.n()); ++j)
                all = all && star(metric.volumes, j).zeros().empty();
            if (all) {
                SCOPED_TRACE(fmt::format("{}, k = {}", metric.name, k));
                law(metric, k);
            }
        }
}

TEST_P(Operators, dual_derivative_has_the_sign_of_its_degree) {
    const int n = mesh().n();
    for (const auto& m : both(mesh()))
        for (int k = 0; k < n; ++k) {
            const SparseMatrix expected =
                (k % 2 == 0 ? -1.0 : 1.0) * SparseMatrix(derivative(m.complex, k).transpose());
            EXPECT_EQ(relative_difference(dual_derivative(m.complex, n - k - 1), expected), 0);
        }
}

TEST_P(Operators, laplacians_are_d_delta_plus_delta_d_on_cells_and_on_duals) {
    for_invertible(mesh(), [&](const Metric& m, int k) {
        const Cells cells(m.complex, m.volumes);
        for (const Side side : {Side::primal, Side::dual}) {
            const bool is_primal = side == Side::primal;
            const int n = mesh().n(), degree = is_primal ? k : n - k;
            const auto d = [&](int j) {
                return is_primal ? derivative(m.complex, j) : dual_derivative(m.complex, j);
            };
            const auto delta = [&](int j) -> SparseMatrix {
                return is_primal ? codifferential(cells, j) : dual_codifferential(cells, j);
            };
            SparseMatrix expected(m.complex.size(k), m.complex.size(k));
            if (degree > 0)
                expected += product(d(degree - 1), delta(degree));
            if (degree < n)
                expected += product(delta(degree + 1), d(degree));
            const SparseMatrix L = is_primal ? laplacian(cells, k) : dual_laplacian(cells, degree);
            EXPECT_CLOSE(L, expected, rounding) << name(side);
            if (largest(L) > 0) {
                EXPECT_GT(relative_difference(L, -expected), 1) << "with the sign flipped";
            }
        }
    });
}

TEST_P(Operators, symmetric_laplacian_is_star_times_laplacian_and_symmetric) {
    for_invertible(mesh(), [&](const Metric& m, int k) {
        const SparseMatrix A = symmetric_laplacian({m.complex, m.volumes}, k);
        const SparseMatrix L = laplacian({m.complex, m.volumes}, k);
        EXPECT_CLOSE(A, star(m.volumes, k).diagonal().asDiagonal() * L, rounding);
        EXPECT_CLOSE(A, SparseMatrix(A.transpose()), rounding);
    });
}

TEST_P(Operators, dual_laplacian_is_similar_by_the_star) {
    for_invertible(mesh(), [&](const Metric& m, int k) {
        const SparseMatrix L = laplacian({m.complex, m.volumes}, k);
        const SparseMatrix dual = dual_laplacian({m.complex, m.volumes}, mesh().n() - k);
        const SparseMatrix similar = star(m.volumes, k).diagonal().asDiagonal() * L *
                                     star(m.volumes, k).inverse().asDiagonal();
        EXPECT_CLOSE(dual, similar, rounding);
    });
}

TEST_P(Operators, laplacian_of_functions_kills_constants) {
    for (const auto& [name, complex, volumes] : both(mesh())) {
        if (!star(volumes, 0).zeros().empty())
            continue;
        const SparseMatrix L = laplacian({complex, volumes}, 0);
        const Vector image = L * Vector::Ones(complex.size(0));
        EXPECT_LE(image.cwiseAbs().maxCoeff(), rounding * largest(L)) << name;
        const Vector other = L * random_vector(complex.size(0), 3);
        EXPECT_GT(other.cwiseAbs().maxCoeff(), 1e-3 * largest(L)) << name;
    }
}

TEST_P(Operators, laplacian_of_dual_functions_kills_constants_where_a_closed_complex_is_oriented) {
    const int n = mesh().n();
    for (const auto& [name, complex, volumes] : both(mesh())) {
        const auto& counts = complex.coface_counts(n - 1);
        const bool closed =
            std::all_of(counts.begin(), counts.end(), [](Index c) { return c == 2; });
        if (!closed || !star(volumes, n - 1).zeros().empty())
            continue;
        const SparseMatrix L = dual_laplacian({complex, volumes}, 0);
        const Vector image = L * Vector::Ones(complex.size(n));
        const bool killed = image.cwiseAbs().maxCoeff() <= rounding * largest(L);
        EXPECT_EQ(killed, mesh().K().orientable()) << name;
    }
}

TEST_P(Operators, have_the_ends_of_the_tower_in_their_shapes) {
    const int n = mesh().n();
    const auto& P = mesh().P();
    EXPECT_EQ(codifferential({P, mesh().volumes}, 0).rows(), 0);
    EXPECT_EQ(codifferential({P, mesh().volumes}, 0).cols(), P.size(0));
    EXPECT_EQ(dual_codifferential({P, mesh().volumes}, 0).rows(), 0);
    EXPECT_EQ(dual_codifferential({P, mesh().volumes}, 0).cols(), P.size(n));
    EXPECT_EQ(derivative(P, n).rows(), 0);
    EXPECT_EQ(derivative(P, -1).cols(), 0);
}

POLYDEC_OVER_MESHES(Operators);

TEST(OperatorsBroken, dual_laplacian_is_not_similar_by_the_star_from_the_wrong_side) {
    for (const char* name : {"wellcentred4", "goldberg2", "boxes", "obtuse_solid"}) {
        const auto& m = merged(name);
        for (int k = 0; k < m.n(); ++k) {
            const Vector M = star(m.volumes, k).diagonal(), inverse = star(m.volumes, k).inverse();
            const SparseMatrix L = laplacian({m.P(), m.volumes}, k);
            const SparseMatrix wrong = inverse.asDiagonal() * L * M.asDiagonal();
            EXPECT_GT(relative_difference(dual_laplacian({m.P(), m.volumes}, m.n() - k), wrong),
                      1e-3)
                << name << ", k = " << k;
        }
    }
}

TEST(OperatorErrors, come_where_a_star_must_be_inverted_that_is_zero) {
    const auto& mesh = merged("fcc1");
    EXPECT_THROW(laplacian({mesh.P(), mesh.volumes}, 3), InvalidInput);
    EXPECT_THROW(symmetric_laplacian({mesh.P(), mesh.volumes}, 3), InvalidInput);
    EXPECT_THROW(dual_laplacian({mesh.P(), mesh.volumes}, 0), InvalidInput);
    EXPECT_THROW(codifferential({mesh.P(), mesh.volumes}, 3), InvalidInput);
    EXPECT_THROW(dual_codifferential({mesh.P(), mesh.volumes}, 1), InvalidInput);
    // functions need no inverse but that of their own star
    EXPECT_NO_THROW(laplacian({mesh.P(), mesh.volumes}, 0));
}

} // namespace polydec::test::in_operators
