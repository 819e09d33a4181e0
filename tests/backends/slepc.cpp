// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

namespace polydec::test::in_slepc {

/// The smallest eigenvalues of A: the largest of the inverse, which is a solve with that engine.
Vector smallest_by(const std::string& engine, const SparseMatrix& A, Index count) {
    const auto solver = make_linear_solver(engine);
    solver->factorize(A, positive());
    const SymmetricOperator inverse{static_cast<Index>(A.rows()),
                                    [&](const Vector& x, Vector& y) { y = solver->solve(x); }};
    return make_eigen_solver("slepc")->largest(inverse, count).values.cwiseInverse();
}

// Engines of PETSc are called from within SLEPc here.
TEST(slepc, shift_and_invert_goes_through_engines_of_all_kinds) {
    auto A = grid_laplacian(11, 2);
    for (Index i = 0; i < 121; ++i)
        A.coeffRef(i, i) += 0.01 * i; // parts the multiplets
    const Vector expected = dense_eigenvalues(A).head(6);
    for (const char* engine : {"eigen.ldlt", "eigen.cg", "petsc.cg-gamg", "auto"}) {
        const Vector found = smallest_by(engine, A, 6);
        ASSERT_EQ(found.size(), 6) << engine;
        EXPECT_LE((found - expected).norm(), 1e-9) << engine;
    }
}

TEST(slepc, an_engine_that_fails_within_is_heard_and_leaves_slepc_usable) {
    const SymmetricOperator failing{100, [calls = 0](const Vector& x, Vector& y) mutable {
                                        if (++calls == 5)
                                            throw SolverFailure("the fifth call");
                                        y = Vector::LinSpaced(100, 1.0, 2.0).cwiseProduct(x);
                                    }};
    const auto solver = make_eigen_solver("slepc");
    EXPECT_EQ(message_of<SolverFailure>([&] { solver->largest(failing, 3); }), "the fifth call");
    EXPECT_NEAR(smallest_by("eigen.ldlt", grid_laplacian(4), 1)[0],
                4.0 * (1.0 - std::cos(EIGEN_PI / 5.0)), 1e-12);
}

} // namespace polydec::test::in_slepc
