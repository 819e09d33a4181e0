// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_waves_in_cavities {

/// Forms that vanish on the boundary of n^3 cubes, or of as many along each axis of another space.
FormSpace cavity(int cells, int degree = 1, int n = 3) {
    return {circumcentric(kuhn(n, cells)), Side::primal, degree, BoundaryCondition::essential};
}

Vector cavity_eigenvalues(int cells, Index count) {
    const auto modes = coexact_spectrum(cavity(cells), {.count = count});
    EXPECT_TRUE(modes.certificate.complete);
    EXPECT_LE(modes.residuals.maxCoeff(), 1e-6);
    return modes.eigenvalues / (M_PI * M_PI);
}

TEST(CavityModes, of_the_cube_are_those_of_an_independent_program) {
    const Vector values = cavity_eigenvalues(12, 17);
    for (Index i = 0; i < 3; ++i)
        EXPECT_NEAR(values[i], 1.9886, 1e-4);
    for (Index i = 3; i < 5; ++i)
        EXPECT_NEAR(values[i], 2.9829, 1e-4);
    for (Index i = 5; i < 11; ++i)
        EXPECT_NEAR(values[i], 4.9037, 1e-4);
    for (Index i = 11; i < 17; ++i)
        EXPECT_NEAR(values[i], 5.898, 1e-3);
}

TEST(CavityModes, converge_with_order_2) {
    const double exact[] = {2, 2, 2, 3, 3};
    const Vector coarse = cavity_eigenvalues(4, 5), fine = cavity_eigenvalues(8, 5);
    for (Index i = 0; i < 5; ++i)
        EXPECT_NEAR(std::log2((exact[i] - coarse[i]) / (exact[i] - fine[i])), 2.0, 0.15);
}

TEST(CavityModes, are_divergence_free_and_no_gradients) {
    const FormSpace space = cavity(4);
    const auto modes = coexact_spectrum(space, {.count = 8});
    const HodgeSolver hodge(space);
    for (Index i = 0; i < 8; ++i) {
        const auto parts = hodge.decompose({Side::primal, 1, modes.modes.col(i)});
        EXPECT_LE(parts.exact.values.norm(), 1e-7 * modes.modes.col(i).norm());
    }
    // the plain spectrum has gradients among them: 3 pi^2 of the Dirichlet Laplacian
    const auto plain = spectrum(space, {.count = 8});
    EXPECT_GT((plain.eigenvalues - modes.eigenvalues).cwiseAbs().maxCoeff(), 1);
}

/// Yee's scheme on n^3 cubes of side h in a conducting box, written out index by index.
class Yee {
public:
    using Place = std::array<int, 3>;

    explicit Yee(int n) : n_(n) {
        for (int axis = 0; axis < 3; ++axis)
            E_[axis].resize((n + 1) * (n + 1) * (n + 1)), B_[axis] = E_[axis];
    }

    double& E(int axis, Place p) { return E_[axis][(p[0] * (n_ + 1) + p[1]) * (n_ + 1) + p[2]]; }
    double& B(int axis, Place p) { return B_[axis][(p[0] * (n_ + 1) + p[1]) * (n_ + 1) + p[2]]; }

    void step(double dt) {
        for_all([&](Place p, int a, int b, int c) {
            if (p[b] < n_ && p[c] < n_)
                B(a, p) -=
                    dt * n_ * (E(c, moved(p, b, 1)) - E(c, p) - E(b, moved(p, c, 1)) + E(b, p));
        });
        for_all([&](Place p, int a, int b, int c) {
            if (p[a] < n_ && p[b] > 0 && p[b] < n_ && p[c] > 0 && p[c] < n_)
                E(a, p) +=
                    dt * n_ * (B(c, p) - B(c, moved(p, b, -1)) - B(b, p) + B(b, moved(p, c, -1)));
        });
    }

private:
    static Place moved(Place p, int axis, int by) {
        p[axis] += by;
        return p;
    }

    /// visit(place, axis, the two after it)
    template <class Visit>
    void for_all(Visit visit) const {
        for (int a = 0; a < 3; ++a)
            for (int i = 0; i <= n_; ++i)
                for (int j = 0; j <= n_; ++j)
                    for (int k = 0; k <= n_; ++k)
                        visit(Place{i, j, k}, a, (a + 1) % 3, (a + 2) % 3);
    }

    int n_;
    std::array<std::vector<double>, 3> E_, B_;
};

/// Largest difference after some steps from random fields, over the largest field.
double difference_from_yee(int n, int steps, double factor) {
    const FormSpace space = cavity(n);
    const auto mesh = circumcentric(kuhn(3, n));
    const double dt = 0.5 / n;
    const Vector start = space.extend(random_vector(space.size(), 1));
    Waves waves(space, start, {.time_step = dt, .B = Vector::Zero(mesh.size(2))});

    Yee yee(n);
    const auto field_at = [&](Index edge) -> double& {
        const auto ends = mesh.merging().vertices(1, edge);
        const Eigen::RowVector3d a = mesh.points().row(ends[0]), b = mesh.points().row(ends[1]);
        int axis = 0;
        (b - a).cwiseAbs().maxCoeff(&axis);
        const Eigen::RowVector3d low = a.cwiseMin(b) * n;
        return yee.E(
            axis, {int(std::lround(low[0])), int(std::lround(low[1])), int(std::lround(low[2]))});
    };
    for (const Index edge : space.free())
        field_at(edge) = start[edge] * n; // values along an edge are field times length
    waves.advance(steps);
    for (int step = 0; step < steps; ++step)
        yee.step(factor * dt);
    const Vector E = waves.form(0).values;
    double worst = 0;
    for (const Index edge : space.free())
        worst = std::max(worst, std::abs(field_at(edge) - E[edge] * n));
    return worst / (E.cwiseAbs().maxCoeff() * n);
}

TEST(Maxwell, leapfrog_on_a_merged_kuhn_grid_is_the_scheme_of_yee) {
    EXPECT_LE(difference_from_yee(6, 1000, 1), 1e-11);
    EXPECT_GT(difference_from_yee(6, 100, 1.01), 1e-3) << "with another time step";
}

TEST(Maxwell, energy_is_conserved_over_ten_thousand_steps) {
    const FormSpace space = cavity(4);
    const Cells cells = space.inside();
    const auto random = [&](int k, unsigned seed) {
        return space.relative().extend(k, random_vector(cells.complex().size(k), seed));
    };
    Waves waves(space, random(1, 3), {.time_step = 0.99 * stable_step(space), .B = random(2, 4)});
    waves.advance(10000);
    EXPECT_NEAR(waves.relative_energy().value(), 1, 1e-10);
    // the sum of the squares alone swings
    const HodgeStars stars = space.cells().stars();
    const auto squares = [&] {
        const Vector E = waves.form(0).values, B = waves.form(1).values;
        return E.dot(stars[1] * E) + B.dot(stars[2] * B);
    };
    const double before = squares();
    waves.advance();
    EXPECT_GT(std::abs(squares() - before), 1e-6 * before);
}

TEST(Waves, of_functions_swing_with_their_frequency_in_any_dimension) {
    for (const int n : {1, 2, 3, 4}) {
        const FormSpace space = cavity(4, 0, n);
        const auto mode = spectrum(space, {.count = 1});
        const double frequency = std::sqrt(mode.eigenvalues[0]);
        const int steps = 2000;
        const Vector begin = mode.modes.col(0);
        Waves waves(space, begin, {.time_step = 2 * M_PI / frequency / steps});
        waves.advance(steps);
        EXPECT_LE((waves.form(0).values - begin).norm(), 1e-4 * begin.norm()) << "n = " << n;
    }
}

TEST(WaveErrors, name_what_is_wrong) {
    const auto mesh = circumcentric(grid(4, 4));
    const auto refused = [&](int degree, double step) {
        const Cochain form{Side::primal, degree, Vector::Zero(mesh.complex().size(degree))};
        return refusal([&] {
            Waves({{mesh.complex(), mesh.volumes()}, form.side, form.degree}, form.values,
                  {.time_step = step});
        });
    };
    EXPECT_SAYS(refused(2, 0.1), "waves", "2-forms", "dimension 2", "0", "1");
    EXPECT_SAYS(refused(0, 1), "time step is 1");
    const auto refused_heat = [&](double step) {
        const Cochain form{Side::dual, 0, Vector::Zero(mesh.complex().size(2))};
        return refusal([&] {
            heated({{mesh.complex(), mesh.volumes()}, form.side, form.degree}, form, step);
        });
    };
    EXPECT_SAYS(refused_heat(0), "backward-euler", "fixed_step above 0");
    EXPECT_SAYS(refused_heat(-1), "backward-euler", "fixed_step is -1");
    EXPECT_REFUSED(coexact_spectrum({{mesh.complex(), mesh.volumes()}, Side::dual, 0}),
                   "forms are dual", "primal forms", "coexact dual forms");
    const Cells cells(mesh.complex(), mesh.stars());
    EXPECT_REFUSED(coexact_spectrum({cells, Side::primal, 2}, {.count = 1}), "coexact 2-forms",
                   "there are none", "smaller degree");
    EXPECT_REFUSED(coexact_spectrum({cells, Side::primal, 0}, {.count = 25}), "coexact 0-forms",
                   "expected 1 to 24");
}

} // namespace polydec::test::in_waves_in_cavities
