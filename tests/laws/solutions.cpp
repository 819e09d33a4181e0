// SPDX-License-Identifier: MIT
#include "tests/laws/over_hostile_meshes.h"

namespace polydec::test::in_solutions {

constexpr long double extended_rounding = std::numeric_limits<long double>::epsilon();

Extended dense(const IncidenceMatrix& d) {
    return Extended(d.cast<long double>());
}

ExtendedVector extended_star(const CellVolumes& volumes, int k) {
    return volumes.dual(k).cast<long double>().cwiseQuotient(volumes.primal(k).cast<long double>());
}

/// A_k of the Laplace-de Rham operator, from its definition.
Extended dense_laplacian(const Discretization& mesh, int k) {
    const auto& complex = mesh.complex();
    const ExtendedVector mass = extended_star(mesh.volumes(), k);
    Extended A = Extended::Zero(complex.size(k), complex.size(k));
    if (k < mesh.dimension()) {
        const Extended d = dense(complex.coboundary(k));
        A += d.transpose() * extended_star(mesh.volumes(), k + 1).asDiagonal() * d;
    }
    if (k > 0) {
        const Extended up = mass.asDiagonal() * dense(complex.coboundary(k - 1));
        A += up * extended_star(mesh.volumes(), k - 1).cwiseInverse().asDiagonal() * up.transpose();
    }
    return A;
}

struct DenseSpectrum {
    ExtendedVector values;
    long double error; ///< of each value, by rounding
};

DenseSpectrum dense_spectrum(const Discretization& mesh, int k) {
    const ExtendedVector scaling = extended_star(mesh.volumes(), k).cwiseSqrt().cwiseInverse();
    const Extended B = scaling.asDiagonal() * dense_laplacian(mesh, k) * scaling.asDiagonal();
    return {extended_eigenvalues(Extended((B + B.transpose()) / 2)),
            static_cast<long double>(B.rows() * mesh.dimension()) * 16 * extended_rounding *
                B.norm()};
}

/// Whether each of the smallest eigenvalues lies within its radius, shrunk by the factor.
bool encloses(const Spectrum& spectrum, const DenseSpectrum& exact, double factor = 1) {
    for (Index i = 0; i < spectrum.eigenvalues.size(); ++i)
        if (!(std::abs(spectrum.eigenvalues[i] - exact.values[i]) <=
              factor * spectrum.radii[i] + exact.error))
            return false;
    return true;
}

/// Then n-forms vanish in the cells beside them.
bool has_facets_without_dual(const Discretization& mesh) {
    const auto marks = Cells(mesh.complex(), mesh.volumes()).boundary_facets_without_dual();
    return std::find(marks.begin(), marks.end(), true) != marks.end();
}

TEST(HostileMeshes, have_eigenvalues_within_their_radii) {
    EXPECT_TRUE(holds_on_hostile_discretizations("radii", [](const Discretization& mesh) {
        for (int k = 0; k <= mesh.dimension(); ++k) {
            const SpectrumOptions options{.count = std::min<Index>(4, mesh.complex().size(k))};
            const auto found = unless_refused([&] {
                return spectrum({{mesh.complex(), mesh.volumes()}, Side::primal, k}, options);
            });
            if (!found || (k == mesh.dimension() && has_facets_without_dual(mesh)))
                continue;
            RC_ASSERT(found->eigenvalues.size() == options.count);
            RC_ASSERT(found->eigenvalues.allFinite());
            RC_ASSERT(found->radii.allFinite());
            RC_ASSERT(found->certificate.complete);
            RC_ASSERT(encloses(*found, dense_spectrum(mesh, k)));
        }
    }));
}

TEST(HostileMeshes, would_show_eigenvalues_of_another_mesh) {
    const auto mesh = discretize(mesh_named("torus8x6"));
    auto found = spectrum({mesh, Side::primal, 1}, {.count = 6});
    const auto exact = dense_spectrum(mesh, 1);
    EXPECT_TRUE(encloses(found, exact));
    found.eigenvalues[4] *= 1 + 1e-6;
    EXPECT_FALSE(encloses(found, exact));
}

/// d_0^T star_1 d_0 u = star_0 f with u given on the boundary, or of mean zero where there is none.
struct DensePoisson {
    ExtendedVector solution;
    long double condition;
};

DensePoisson dense_poisson(const Discretization& mesh, const Vector& f) {
    const auto& complex = mesh.complex();
    const Extended d = dense(complex.coboundary(0));
    const Extended A = d.transpose() * extended_star(mesh.volumes(), 1).asDiagonal() * d;
    const auto marks = essential_cells(complex, {});
    std::vector<Index> inside;
    for (Index v = 0; v < complex.size(0); ++v)
        if (!marks[0][v])
            inside.push_back(v);
    const ExtendedVector load =
        extended_star(mesh.volumes(), 0).cwiseProduct(f.cast<long double>());
    const Extended interior = A(inside, inside);
    DensePoisson result{ExtendedVector::Zero(complex.size(0)), 1};
    if (inside.empty())
        return result;
    const auto found = solve_extended(interior, load(inside));
    result.condition = 1 / std::max(found.reciprocal_condition, extended_rounding);
    result.solution(inside) = found.X;
    return result;
}

TEST(HostileMeshes, have_the_solutions_of_Poisson_problems_that_dense_matrices_have) {
    EXPECT_TRUE(holds_on_hostile_discretizations("Poisson", [](const Discretization& mesh) {
        // a component without boundary is free up to a constant: no one solution to compare with
        const Vector f = random_vector(mesh.complex().size(0), 3);
        const Vector zero = Vector::Zero(f.size());
        const auto u = unless_refused([&] {
            const PoissonSolver solver({{mesh.complex(), mesh.volumes()},
                                        Side::primal,
                                        0,
                                        {BoundaryCondition::essential}});
            const auto found = solver.solve({Side::primal, 0, f});
            RC_ASSERT(found.report.residual <= 1e-6);
            return found.compatibility.free_components == 0 ? found.form.values : Vector();
        });
        if (!u || u->size() == 0)
            return;
        RC_ASSERT(u->allFinite());
        const auto exact = dense_poisson(mesh, f);
        if (exact.condition > 1e10L)
            return;
        const long double error = (u->cast<long double>() - exact.solution).norm();
        RC_ASSERT(error <= 1e-13L * exact.condition * exact.solution.norm());
    }));
}

} // namespace polydec::test::in_solutions
