// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_waves_in_cavities {

/// The complex of forms that vanish on the boundary, with its volumes.
struct Cavity {
    RelativeComplex relative;
    CellVolumes volumes;

    explicit Cavity(const Discretization& mesh)
        : relative(relative_to_boundary(mesh.complex())),
          volumes(relative_volumes(relative, mesh.volumes())) {}
};

Vector cavity_eigenvalues(int cells, Index count) {
    const Cavity cavity(circumcentric(kuhn(3, cells)));
    const auto modes = coexact_spectrum(
        {{cavity.relative.complex, cavity.volumes}, Side::primal, 1}, {.count = count});
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
    const Cavity cavity(circumcentric(kuhn(3, 4)));
    const auto modes = coexact_spectrum(
        {{cavity.relative.complex, cavity.volumes}, Side::primal, 1}, {.count = 8});
    HodgeSolver hodge({{cavity.relative.complex, cavity.volumes}, Side::primal, 1});
    for (Index i = 0; i < 8; ++i) {
        const auto parts = hodge.decompose({Side::primal, 1, modes.modes.col(i)});
        EXPECT_LE(parts.exact.values.norm(), 1e-7 * modes.modes.col(i).norm());
    }
    // the plain spectrum has gradients among them: 3 pi^2 of the Dirichlet Laplacian
    const auto plain =
        spectrum({{cavity.relative.complex, cavity.volumes}, Side::primal, 1}, {.count = 8});
    EXPECT_GT((plain.eigenvalues - modes.eigenvalues).cwiseAbs().maxCoeff(), 1);
}

/// Yee's scheme on n^3 cubes of side h in a conducting box, written out index by index.
class Yee {
public:
    explicit Yee(int n) : n_(n), h_(1.0 / n) {}

    double& E(int axis, int i, int j, int k) { return field(E_[axis], i, j, k); }
    double& B(int axis, int i, int j, int k) { return field(B_[axis], i, j, k); }

    void step(double dt) {
        for (int a = 0; a < 3; ++a)
            for_all([&](int i, int j, int k) {
                const int b = (a + 1) % 3, c = (a + 2) % 3;
                int p[3] = {i, j, k}, q[3] = {i, j, k};
                ++p[b], ++q[c];
                if (p[b] > n_ || q[c] > n_)
                    return;
                B(a, i, j, k) -= dt / h_ *
                                 (E(c, p[0], p[1], p[2]) - E(c, i, j, k) - E(b, q[0], q[1], q[2]) +
                                  E(b, i, j, k));
            });
        for (int a = 0; a < 3; ++a)
            for_all([&](int i, int j, int k) {
                const int b = (a + 1) % 3, c = (a + 2) % 3;
                int p[3] = {i, j, k}, q[3] = {i, j, k};
                const bool wall = p[b] == 0 || p[b] == n_ || p[c] == 0 || p[c] == n_;
                if (wall || p[a] == n_)
                    return;
                --p[b], --q[c];
                E(a, i, j, k) += dt / h_ *
                                 (B(c, i, j, k) - B(c, p[0], p[1], p[2]) - B(b, i, j, k) +
                                  B(b, q[0], q[1], q[2]));
            });
    }

private:
    using Field = std::vector<double>;

    double& field(Field& values, int i, int j, int k) {
        values.resize((n_ + 1) * (n_ + 1) * (n_ + 1), 0.0);
        return values[(i * (n_ + 1) + j) * (n_ + 1) + k];
    }

    template <class Visit>
    void for_all(Visit visit) const {
        for (int i = 0; i <= n_; ++i)
            for (int j = 0; j <= n_; ++j)
                for (int k = 0; k <= n_; ++k)
                    visit(i, j, k);
    }

    int n_;
    double h_;
    Field E_[3], B_[3];
};

/// An edge of the merged grid as Yee's code numbers it.
struct GridEdge {
    int axis, i, j, k;
};

GridEdge grid_edge(const Discretization& mesh, Index edge, int n) {
    const auto ends = mesh.merging().vertices(1, edge);
    const Eigen::RowVector3d a = mesh.points().row(ends[0]), b = mesh.points().row(ends[1]);
    int axis = 0;
    (b - a).cwiseAbs().maxCoeff(&axis);
    const Eigen::RowVector3d low = a.cwiseMin(b) * n;
    return {axis, int(std::lround(low[0])), int(std::lround(low[1])), int(std::lround(low[2]))};
}

/// Largest difference after some steps from random fields, over the largest field.
double difference_from_yee(int n, int steps, double factor) {
    const auto mesh = circumcentric(kuhn(3, n));
    const Cavity cavity(mesh);
    const auto& edges = cavity.relative.cells[1];
    const double dt = 0.5 / n;
    Vector E = random_vector(cavity.relative.complex.size(1), 1);
    Waves waves({{cavity.relative.complex, cavity.volumes}, Side::primal, 1}, E,
                {.time_step = dt, .B = Vector::Zero(cavity.relative.complex.size(2))});

    Yee yee(n);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [axis, i, j, k] = grid_edge(mesh, edges[e], n);
        yee.E(axis, i, j, k) = E[Index(e)] * n; // values along an edge are field times length
    }
    waves.advance(steps);
    for (int step = 0; step < steps; ++step)
        yee.step(factor * dt);
    E = waves.form(0).values;
    double worst = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [axis, i, j, k] = grid_edge(mesh, edges[e], n);
        worst = std::max(worst, std::abs(yee.E(axis, i, j, k) - E[Index(e)] * n));
    }
    return worst / (E.cwiseAbs().maxCoeff() * n);
}

TEST(Maxwell, leapfrog_on_a_merged_kuhn_grid_is_the_scheme_of_yee) {
    EXPECT_LE(difference_from_yee(6, 1000, 1), 1e-11);
    EXPECT_GT(difference_from_yee(6, 100, 1.01), 1e-3) << "with another time step";
}

TEST(Maxwell, energy_is_conserved_over_ten_thousand_steps) {
    const Cavity cavity(circumcentric(kuhn(3, 4)));
    const auto& complex = cavity.relative.complex;
    Waves waves({{complex, cavity.volumes}, Side::primal, 1}, random_vector(complex.size(1), 3),
                {.time_step = 0.99 * stable_step({{complex, cavity.volumes}, Side::primal, 1}),
                 .B = random_vector(complex.size(2), 4)});
    waves.advance(10000);
    EXPECT_NEAR(waves.relative_energy().value(), 1, 1e-10);
    // the sum of the squares alone swings
    const auto squares = [&] {
        const Vector E = waves.form(0).values, B = waves.form(1).values;
        return E.dot(star(cavity.volumes, 1).diagonal().cwiseProduct(E)) +
               B.dot(star(cavity.volumes, 2).diagonal().cwiseProduct(B));
    };
    const double before = squares();
    waves.advance();
    EXPECT_GT(std::abs(squares() - before), 1e-6 * before);
}

TEST(Waves, of_functions_swing_with_their_frequency_in_any_dimension) {
    for (const int n : {1, 2, 3, 4}) {
        const Cavity cavity(circumcentric(kuhn(n, 4)));
        const auto& complex = cavity.relative.complex;
        const auto mode = spectrum({{complex, cavity.volumes}, Side::primal, 0}, {.count = 1});
        const double frequency = std::sqrt(mode.eigenvalues[0]);
        const int steps = 2000;
        const double dt = 2 * M_PI / frequency / steps;
        const Vector begin = mode.modes.col(0);
        Waves waves({{complex, cavity.volumes}, Side::primal, 0}, begin, {.time_step = dt});
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
