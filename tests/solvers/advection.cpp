// SPDX-License-Identifier: MIT
#include "dec/metric/exterior_product.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_advection {

constexpr double rounding = 1e-11;

/// The advection of a mesh of the family; none where there can be none, and then it is refused.
std::optional<Advection> advection_of(const Discretization& mesh) {
    const int n = mesh.dimension();
    if (n >= 2 && is_two_sided(mesh) && mesh.complex().canceled(n - 1).empty())
        return Advection(mesh);
    EXPECT_THROW(Advection{mesh}, InvalidInput);
    return std::nullopt;
}

class Advections : public OverMeshes {};

TEST_P(Advections, do_no_work) {
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        const auto advection = advection_of(mesh);
        if (!advection)
            return;
        const int n = mesh.dimension();
        const Vector z = random_vector(mesh.complex().size(n - 2), 1);
        const Vector w = random_vector(mesh.complex().size(n - 1), 2);
        const Vector force = (*advection)(z, w);
        const double size = w.cwiseAbs().dot(force.cwiseAbs());
        EXPECT_LE(std::abs(w.dot(force)), rounding * size);
        const SparseMatrix A = advection->matrix(z);
        EXPECT_LE(largest(SparseMatrix(A.transpose()) + A), rounding * largest(A));
        EXPECT_CLOSE(force, A * w, rounding);
        // of one side alone it would
        const SparseMatrix half = A.triangularView<Eigen::Upper>();
        EXPECT_GT(std::abs(w.dot(half * w)), 1e-6 * w.cwiseAbs().dot((half * w).cwiseAbs()));
    });
}

/// z ^ u ^ x for a constant (n-2)-form z, as a number at dx_1 ^ .. ^ dx_n.
double triple(const Vector& z, const Vector& u, const Eigen::RowVectorXd& x) {
    const auto n = static_cast<Index>(u.size());
    DenseMatrix vectors(2, n);
    vectors << u.transpose(), x;
    const Vector plane = ExteriorProduct(static_cast<int>(n), 2)(vectors);
    double sum = 0;
    Index i = 0;
    for (int a = 0; a < n; ++a)
        for (int b = a + 1; b < n; ++b, ++i) {
            // subsets are in lexicographic order, so their complements are in the opposite one
            const int sign = (a + b) % 2 == 1 ? 1 : -1;
            sum += sign * plane[i] * z[z.size() - 1 - i];
        }
    return sum;
}

TEST_P(Advections, of_constant_flows_in_constant_vorticity_are_exact_on_flat_meshes) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        const auto advection = advection_of(mesh);
        if (!advection)
            return;
        const int n = mesh.dimension();
        const Vector z = random_vector(coefficients(n, n - 2), 3), u = random_vector(n, 4);
        const Vector vorticity = de_rham(mesh, n - 2, [&](const Vector&) { return z; }).values;
        const Vector flux =
            de_rham(mesh, n - 1, flux_form([&](const Vector&) { return u; })).values;
        const Vector found = (*advection)(vorticity, flux);
        // from the centroid on one side to that on the other
        const SparseMatrix sides = derivative(mesh.complex(), n - 1).transpose();
        const DenseMatrix across = -(sides * cell_centroids(mesh, n));
        const auto& cofaces = mesh.complex().coface_counts(n - 1);
        Vector inside = found, exact = found;
        for (Index f = 0; f < found.size(); ++f)
            if (cofaces[f] == 2)
                exact[f] = triple(z, u, across.row(f));
            else
                exact[f] = inside[f] = 0;
        if (exact.norm() == 0)
            return;
        EXPECT_WITHIN(inside, exact, 1e-10 * exact.cwiseAbs().maxCoeff());
        EXPECT_GT((inside + exact).cwiseAbs().maxCoeff(), exact.cwiseAbs().maxCoeff());
    });
}

TEST_P(Advections, need_no_points) {
    const auto& whole = discretized(GetParam());
    if (whole.dimension() < 2 || is_flat(mesh_named(GetParam())))
        return;
    const auto advection = advection_of(whole);
    if (!advection)
        return;
    const int n = whole.dimension();
    const auto other = circumcentric(length_mesh(mesh_named(GetParam())),
                                     {MergeCriterion::dual_length, tolerance});
    const Vector z = random_vector(whole.complex().size(n - 2), 1);
    const Vector w = random_vector(whole.complex().size(n - 1), 2);
    EXPECT_CLOSE(Advection(other)(z, w), (*advection)(z, w), 1e-8);
}

POLYDEC_OVER_MESHES(Advections);

TEST(AdvectionErrors, name_the_dimension_and_the_facet) {
    EXPECT_REFUSED(Advection{discretized("segments4")}, "dimension 1", "2", "vorticity");
    const Advection advection(discretized("grid4"));
    EXPECT_REFUSED(advection(Vector::Ones(3), Vector::Ones(3)), "3 values", "vorticity", "25");
}

} // namespace polydec::test::in_advection
