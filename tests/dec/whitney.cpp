// SPDX-License-Identifier: MIT
#include "dec/metric/whitney.h"

#include "dec/metric/subsets.h"
#include "tests/support/test.h"

namespace polydec::test::in_whitney {

/// One m-simplex at random in R^N, and its mass matrix of Whitney j-forms.
struct Simplex {
    Points points;
    std::vector<Index> vertices;
    SimplicialComplex complex;

    Simplex(int m, int N, unsigned seed)
        : points(random_vector((m + 1) * N, seed).reshaped<Eigen::RowMajor>(m + 1, N)),
          vertices(m + 1),
          complex(Simplices(Simplices::NullaryExpr(1, m + 1, [](Index, Index i) { return i; }))) {
        std::iota(vertices.begin(), vertices.end(), 0);
    }

    DenseMatrix mass(int j) const { return whitney_mass(points, vertices, j); }
    double volume() const {
        const int m = complex.dimension();
        return multivectors(complex, points, m).norm();
    }
};

/// Calls law(simplex, m, j) for simplices of every dimension and degree.
template <class Law>
void for_every_degree(int extra_coordinates, Law law) {
    for (int m = 1; m <= 5; ++m)
        for (int j = 0; j <= m; ++j) {
            SCOPED_TRACE(fmt::format("m = {}, j = {}", m, j));
            law(Simplex(m, m + extra_coordinates, static_cast<unsigned>(10 * m + j)), m, j);
        }
}

/// Relative error of x^T mass y = |t| a . b, x and y being the integrals of constant forms a, b.
double constant_defect(const Simplex& simplex, const DenseMatrix& mass, int m, int j) {
    const Vector a = random_vector(coefficients(m, j), 5), b = random_vector(coefficients(m, j), 6);
    const DenseMatrix faces = multivectors(simplex.complex, simplex.points, j);
    const Vector x = faces * a, y = faces * b;
    const double size = simplex.volume() * a.norm() * b.norm();
    return std::abs(x.dot(mass * y) - simplex.volume() * a.dot(b)) / size;
}

TEST(WhitneyMass, gives_the_inner_products_of_constant_forms) {
    for_every_degree(0, [](const Simplex& simplex, int m, int j) {
        EXPECT_LE(constant_defect(simplex, simplex.mass(j), m, j), 1e-9);
    });
}

TEST(WhitneyMass, gives_other_products_without_the_factor_of_the_degree) {
    for_every_degree(0, [](const Simplex& simplex, int m, int j) {
        const double factorial = std::tgamma(j + 1.0);
        const DenseMatrix wrong = simplex.mass(j) / (factorial * factorial);
        EXPECT_EQ(constant_defect(simplex, wrong, m, j) > 1e-6, j >= 2);
    });
}

TEST(WhitneyMass, is_symmetric_and_positive_definite) {
    for_every_degree(2, [](const Simplex& simplex, int, int j) {
        const DenseMatrix mass = simplex.mass(j);
        EXPECT_WITHIN(mass, mass.transpose(), 1e-12 * mass.cwiseAbs().maxCoeff());
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<DenseMatrix>(mass).eigenvalues()[0], 0);
    });
}

TEST(WhitneyMass, depends_on_edge_lengths_only) {
    for_every_degree(1, [](const Simplex& simplex, int, int j) {
        const DenseMatrix A = random_isometry(static_cast<Index>(simplex.points.cols()), 8);
        Points moved = simplex.points * A.transpose();
        moved.array() += 0.3;
        const DenseMatrix mass = simplex.mass(j), other = whitney_mass(moved, simplex.vertices, j);
        EXPECT_WITHIN(mass, other, 1e-9 * mass.cwiseAbs().maxCoeff());
    });
}

TEST(WhitneyMass, scales_by_powers_of_the_length) {
    for_every_degree(1, [](const Simplex& simplex, int m, int j) {
        const Points scaled = 1e-8 * simplex.points;
        const DenseMatrix mass = simplex.mass(j), other = whitney_mass(scaled, simplex.vertices, j);
        EXPECT_WITHIN(mass, std::pow(1e8, m - 2 * j) * other, 1e-9 * mass.cwiseAbs().maxCoeff());
    });
}

TEST(WhitneyMass, of_functions_and_top_forms_is_the_textbook_one) {
    for (int m = 1; m <= 5; ++m) {
        const Simplex simplex(m, m, static_cast<unsigned>(m));
        const double V = simplex.volume();
        const DenseMatrix expected =
            V / ((m + 1) * (m + 2)) *
            (DenseMatrix::Ones(m + 1, m + 1) + DenseMatrix::Identity(m + 1, m + 1));
        EXPECT_TRUE(simplex.mass(0).isApprox(expected, 1e-10));
        EXPECT_NEAR(simplex.mass(m)(0, 0) * V, 1, 1e-9);
    }
}

TEST(WhitneyMass, is_refused_where_there_are_fewer_coordinates_than_dimensions) {
    const std::vector<Index> corners{0, 1, 2};
    for (const int coordinates : {0, 1})
        EXPECT_REFUSED(whitney_mass(Points::Random(3, coordinates), corners, 1), "simplex",
                       "dimension 2", "0", std::to_string(coordinates));
}

TEST(Subsets, are_all_and_in_lexicographic_order) {
    EXPECT_EQ(subsets(4, 2),
              (std::vector<std::vector<int>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
    EXPECT_EQ(subsets(3, 0), (std::vector<std::vector<int>>{{}}));
    EXPECT_TRUE(subsets(2, 3).empty());
}

} // namespace polydec::test::in_whitney
