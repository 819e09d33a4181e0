// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_operator {

/// That what an operator does to values is the product with its matrix, and so is its diagonal, and
/// that this can be told from another one.
void expect_two_ways_to_look_at(const Operator& A) {
    const SparseMatrix M = A.matrix();
    ASSERT_EQ(M.rows(), A.rows());
    ASSERT_EQ(M.cols(), A.cols());
    const Vector x = random_vector(A.cols(), 7), y = random_vector(A.rows(), 8);
    const Vector applied = A * x, product = M * x, sizes = M.cwiseAbs() * x.cwiseAbs();
    const double rounding = sizes.size() == 0 ? 0 : 1e-13 * sizes.maxCoeff();
    ASSERT_EQ(applied.size(), product.size());
    EXPECT_TRUE(((applied - product).cwiseAbs().array() <= rounding).all());
    if (!product.isZero(0)) {
        EXPECT_FALSE(((A * Vector(2 * x) - product).cwiseAbs().array() <= rounding).all());
    }
    EXPECT_NEAR(y.dot(applied), x.dot(A.transposed() * y), 1e-12 * sizes.dot(y.cwiseAbs()));

    const Vector diagonal = A.diagonal(), expected = M.diagonal();
    ASSERT_EQ(diagonal.size(), expected.size());
    const Vector terms = (A.matrix().cwiseAbs() * Vector::Ones(A.cols())).head(expected.size());
    EXPECT_TRUE(((diagonal - expected).cwiseAbs().array() <= 1e-13 * terms.array()).all());
    EXPECT_REFUSED(A * Vector::Zero(A.cols() + 1), std::to_string(A.cols() + 1), "values",
                   "operator", std::to_string(A.cols()));
}

class OperatorValues : public OverMeshes {
protected:
    /// Looks at those that there are; how many that were.
    static int look_at(const std::vector<std::function<Operator()>>& made) {
        int there_are = 0;
        for (const auto& make : made)
            if (refusal([&] { make(); }) == "accepted") {
                expect_two_ways_to_look_at(make());
                ++there_are;
            }
        return there_are;
    }
};

TEST_P(OperatorValues, act_on_values_as_their_matrices_do) {
    const CellComplex& P = mesh().P();
    const CellVolumes& V = mesh().volumes;
    const auto cells = [&] { return Cells(P, V); };
    for (int k = 0; k <= mesh().n(); ++k) {
        SCOPED_TRACE(k);
        EXPECT_GT(look_at({[&] { return Operator::derivative(P, k); },
                           [&] { return Operator::derivative(P, k - 1).transposed(); },
                           [&] { return Operator::weights(star(V, k).diagonal()); },
                           [&] { return codifferential(cells(), k); },
                           [&] { return dual_codifferential(cells(), k); },
                           [&] { return laplacian(cells(), k); },
                           [&] { return symmetric_laplacian(cells(), k); },
                           [&] { return dual_laplacian(cells(), k); }}),
                  2);
    }
}

TEST_P(OperatorValues, of_the_derivative_have_its_matrix) {
    for (const CellComplex* complex : {static_cast<const CellComplex*>(&mesh().K()), &mesh().P()})
        for (int k = -1; k <= mesh().n(); ++k) {
            const SparseMatrix d = derivative(*complex, k), transposed = d.transpose();
            const Operator D = Operator::derivative(*complex, k);
            EXPECT_EQ(largest(D.matrix() - d), 0);
            EXPECT_EQ(largest(D.transposed().matrix() - transposed), 0);
            if (k >= 0) {
                EXPECT_EQ(largest((D * Operator::derivative(*complex, k - 1)).matrix()), 0);
            }
        }
}

POLYDEC_OVER_MESHES(OperatorValues);

TEST(OperatorValuesRefuse, what_does_not_fit) {
    const auto& P = merged("grid4").P();
    const Operator d0 = Operator::derivative(P, 0), d1 = Operator::derivative(P, 1);
    EXPECT_REFUSED(d0 * d1, "40 x 25", "multiplied", "16 x 40");
    EXPECT_REFUSED(d0 + d1, "40 x 25", "added", "16 x 40");
    EXPECT_THROW(Operator::derivative(P, 3), InvalidInput);
}

/// What inverts a matrix acts by solving and has no sparse matrix, and so no diagonal; all else has
/// both.
TEST(OperatorsByStars, have_a_matrix_and_a_diagonal_where_no_matrix_is_inverted) {
    for (const Mesh& input : {shaken(grid(4, 4), 0.42, 3), shaken(kuhn(3, 2), 0.3, 3)}) {
        const auto mesh = circumcentric(input);
        const auto& complex = mesh.complex();
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        const int n = mesh.dimension();
        for (int k = 0; k <= n; ++k) {
            const Vector x = random_vector(complex.size(k), 1);
            for (const auto& [A, inverts] :
                 {std::pair{symmetric_laplacian({complex, stars}, k), k > 0},
                  std::pair{laplacian({complex, stars}, k), true},
                  std::pair{Operator::star(stars[k]), false},
                  std::pair{dual_laplacian({complex, stars}, n - k), true}}) {
                const Vector y = A * x;
                EXPECT_TRUE(y.allFinite());
                if (inverts) {
                    EXPECT_SAYS(refusal([&A = A] { A.matrix(); }), "inverts", "star");
                    EXPECT_SAYS(refusal([&A = A] { A.diagonal(); }), "inverts", "star");
                    continue;
                }
                EXPECT_CLOSE(y, Vector(A.matrix() * x), 1e-13) << "k = " << k;
                EXPECT_CLOSE(A.diagonal(), Vector(A.matrix().diagonal()), 1e-13);
            }
            // columns of the operator, which is dense
            const Operator A = symmetric_laplacian({complex, stars}, k);
            DenseMatrix columns(complex.size(k), complex.size(k));
            for (Index i = 0; i < columns.cols(); ++i)
                columns.col(i) = A * Vector::Unit(columns.cols(), i);
            EXPECT_LE((columns - columns.transpose()).norm(), 1e-11 * columns.norm());
            EXPECT_GT((columns + columns.transpose()).norm(), columns.norm());
        }
    }
}

} // namespace polydec::test::in_operator
