// SPDX-License-Identifier: MIT
//
// Waves by stars that are no diagonal.
#include "tests/solvers/star_samples.h"

namespace polydec::test::in_waves_by_stars {

class WavesByStars : public OverMeshes {
protected:
    /// Calls law(mesh, k) for cells and simplices with stars of every kind and every degree that
    /// has waves, where a star is a matrix and there are few cells.
    template <class Law>
    void for_all(Law law) const {
        for (const auto& [title, mesh, chosen] : with_star_kinds(GetParam()))
            for (int k = 0; k < mesh.dimension(); ++k) {
                const auto& stars = mesh.stars();
                if (derivative(mesh.complex(), k).nonZeros() == 0 || mesh.complex().size(k) > 150 ||
                    (stars[k].is_diagonal() && stars[k + 1].is_diagonal()))
                    continue;
                SCOPED_TRACE(title + ", k = " + std::to_string(k));
                law(mesh, k);
            }
    }
};

TEST_P(WavesByStars, keep_their_energy) {
    for_all([](const Discretization& mesh, int k) {
        Waves waves({mesh, Side::primal, k}, random_vector(mesh.complex().size(k), 1),
                    {.B = random_vector(mesh.complex().size(k + 1), 2)});
        EXPECT_GT(waves.energy(), 0);
        waves.advance(200);
        EXPECT_NEAR(waves.relative_energy().value(), 1, 1e-11);
    });
}

/// Leapfrog steps turn an eigenform of eigenvalue lambda by the angle whose cosine is
/// 1 - lambda dt^2 / 2.
TEST_P(WavesByStars, swing_eigenforms_in_their_frequency_up_to_the_largest_step) {
    for_all([](const Discretization& mesh, int k) {
        const SparseMatrix d = derivative(mesh.complex(), k);
        const auto [values, forms] =
            dense_modes(SparseMatrix(d.transpose() * (mesh.stars()[k + 1].matrix() * d)).toDense(),
                        mesh.stars()[k].matrix().toDense());
        const Index last = static_cast<Index>(values.size()) - 1;
        const double largest = values[last], limit = stable_step({mesh, Side::primal, k});
        EXPECT_NEAR(limit, 2 / std::sqrt(largest), 1e-6 * limit);
        EXPECT_LE(limit, 2 / std::sqrt(largest) * (1 + 1e-9));
        const double dt = 0.7 * limit;
        for (const Index i : {last, last / 2}) {
            const Vector form = forms.col(i);
            Waves waves({mesh, Side::primal, k}, form, {.time_step = dt});
            const double angle = std::acos(1 - values[i] * dt * dt / 2);
            waves.advance(10);
            const Vector E = waves.form(0).values;
            EXPECT_LE((E - std::cos(10 * angle) * form).norm(), 1e-8 * form.norm());
            EXPECT_GT((E - std::cos(10 * angle + 1) * form).norm() +
                          (E - std::cos(10 * angle - 1) * form).norm(),
                      1e-1 * form.norm());
        }
    });
}

POLYDEC_OVER_MESHES(WavesByStars);

/// A torus has many oscillations of nearly the largest frequency.
TEST(StableStep, does_not_depend_on_the_order_of_vertices) {
    Mesh mesh = torus(96, 48);
    const double limit = stable_step({circumcentric(mesh), Side::primal, 0});
    mesh.points = mesh.points.colwise().reverse().eval();
    mesh.simplices = static_cast<Index>(mesh.points.rows()) - 1 - mesh.simplices.array();
    EXPECT_NEAR(stable_step({circumcentric(mesh), Side::primal, 0}), limit, 1e-10 * limit);
}

TEST(WavesByOtherStars, keep_another_energy) {
    const auto mesh = circumcentric(shaken(kuhn(3, 2), 0.3, 3));
    const Cochain E{Side::primal, 1, random_vector(mesh.complex().size(1), 1)};
    EXPECT_THROW(Waves({mesh, E.side, E.degree}, E.values, {.time_step = 1e-3}), InvalidInput);
    const auto by = [&](StarKind kind) { return mesh.with_stars(mesh.with_stars(kind).stars()); };
    const auto galerkin = by(StarKind::galerkin), other = by(StarKind::barycentric);
    const double dt = 0.5 * std::min(stable_step({galerkin, Side::primal, 1}),
                                     stable_step({other, Side::primal, 1}));
    const WaveOptions options{.time_step = dt, .B = random_vector(mesh.complex().size(2), 2)};
    Waves waves({galerkin, E.side, E.degree}, E.values, options),
        twin({other, E.side, E.degree}, E.values, options);
    waves.advance(50);
    twin.resume(waves.time(), waves.state());
    EXPECT_GT(std::abs(twin.relative_energy().value() - 1), 1e-3);
    const double long_step = 1.01 * stable_step({galerkin, Side::primal, 1});
    EXPECT_REFUSED(Waves({galerkin, E.side, E.degree}, E.values, {.time_step = long_step}),
                   "time step", "limit of stability");
}

/// Frequencies of a conducting box that Galerkin's stars find on obtuse tets: pi sqrt 2, thrice.
TEST(WavesByOtherStars, of_a_cavity_have_its_frequency) {
    const auto mesh = circumcentric(shaken(kuhn(3, 4), 0.1, 3));
    const auto relative = relative_to_boundary(mesh.complex());
    const auto stars = relative_stars(relative, mesh.with_stars(StarKind::galerkin).stars());
    const double dt = 0.5 * stable_step({{relative.complex, stars}, Side::primal, 1});
    // sin(pi x) sin(pi y) dz
    const auto form = de_rham(
        mesh, 1, circulation_form([](const Vector& x) {
            return Vector(Eigen::Vector3d(0, 0, std::sin(M_PI * x[0]) * std::sin(M_PI * x[1])));
        }));
    const Vector start = relative.restrict(1, form.values);
    Waves waves({{relative.complex, stars}, Side::primal, 1}, start, {.time_step = dt});
    double before = 1;
    const double square = start.dot(stars[1] * start);
    while (waves.time() < 1) {
        waves.advance();
        const double now = start.dot(stars[1] * waves.form(0).values) / square;
        if (now < 0) { // a quarter of the period
            EXPECT_NEAR(waves.time() - dt * now / (now - before), 0.25 * std::sqrt(2.0), 0.02);
            return;
        }
        before = now;
    }
    FAIL() << "no change of sign";
}

} // namespace polydec::test::in_waves_by_stars
