// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test {

ExtendedVector extended_eigenvalues(const Extended& A) {
    const long double scale = A.size() == 0 ? 0 : A.cwiseAbs().maxCoeff();
    if (A.rows() < 2 || scale == 0)
        return A.diagonal();
    const Eigen::Tridiagonalization<Extended> T(A / scale); // it converges for values of about 1
    Eigen::SelfAdjointEigenSolver<Extended> solver;
    solver.computeFromTridiagonal(T.diagonal(), T.subDiagonal(), Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success)
        throw std::runtime_error("extended_eigenvalues: no convergence");
    return scale * solver.eigenvalues();
}

ExtendedVector extended_eigenvalues(const Extended& A, const Extended& M) {
    const Eigen::LLT<Extended> factors(M);
    const Extended half = factors.matrixL().solve(A);
    return extended_eigenvalues(Extended(factors.matrixL().solve(half.transpose())));
}

ExtendedSolution solve_extended(const Extended& A, const Extended& B) {
    const Eigen::PartialPivLU<Extended> lu(A);
    return {lu.solve(B), lu.rcond()};
}

} // namespace polydec::test
