// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_harmonic {

class HarmonicForms : public OverMeshes {};

bool positive(const CellVolumes& volumes, int k) {
    return star(volumes, k).zeros().empty() && star(volumes, k).negatives().empty();
}

/// Eigenvalues of Delta_k, ascending, by the symmetric form on both sides of which stands
/// star^(-1/2).
Vector eigenvalues(const Metric& m, int k) {
    const Vector root = star(m.volumes, k).diagonal().cwiseSqrt().cwiseInverse();
    const DenseMatrix A = root.asDiagonal() *
                          DenseMatrix(symmetric_laplacian({m.complex, m.volumes}, k).matrix()) *
                          root.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<DenseMatrix>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

TEST_P(HarmonicForms, are_as_many_as_betti_numbers_say_and_no_eigenvalue_is_negative) {
    for (const auto& m : both(mesh())) {
        const auto betti = betti_numbers(m.complex);
        for (int k = 0; k <= mesh().n(); ++k) {
            bool usable = m.complex.size(k) <= 160;
            for (int j = std::max(k - 1, 0); j <= std::min(k + 1, mesh().n()); ++j)
                usable = usable && positive(m.volumes, j);
            if (!usable)
                continue;
            const Vector lambda = eigenvalues(m, k);
            const double zero = 1e-9 * lambda.cwiseAbs().maxCoeff();
            EXPECT_GE(lambda[0], -zero) << m.name << ", k = " << k;
            EXPECT_EQ((lambda.array() <= zero).count(), betti[k]) << m.name << ", k = " << k;
        }
    }
}

POLYDEC_OVER_MESHES(HarmonicForms);

TEST(HarmonicFormsBroken, one_coefficient_of_d_less_changes_their_number) {
    // a torus whose d_0 lacks an entry is no complex, and its Laplacian shows it
    const auto& torus = merged("torus8x6");
    std::vector<IncidenceMatrix> d{torus.P().coboundary(0), torus.P().coboundary(1)};
    d[0].coeffRef(5, IncidenceMatrix::InnerIterator(d[0], 5).col()) = 0;
    const CellComplex broken(CellComplex::Unchecked{},
                             {{Incidences(std::move(d[0])), torus.P().coface_counts(0)},
                              {Incidences(std::move(d[1])), torus.P().coface_counts(1)}});
    const Vector lambda = eigenvalues({"broken", broken, torus.volumes}, 1);
    EXPECT_NE((lambda.array() <= 1e-9 * lambda.maxCoeff()).count(), 2);
}

} // namespace polydec::test::in_harmonic
