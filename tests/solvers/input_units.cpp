// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"
#include "tests/support/all_sizes.h"

namespace polydec::test::in_input_units {

Cochain any_form(const Discretization& mesh, Side side, int degree) {
    const Index size = mesh.complex().size(cell_degree(mesh.complex(), side, degree));
    return {side, degree, random_vector(size, 5)};
}

Vector slopes(const Discretization& mesh, double size) {
    return random_vector(mesh.complex().size(mesh.dimension() - 1), 7) / size;
}

/// Robin's condition, which n-forms do not have.
BoundaryConditions leaky(const Discretization& mesh, int degree, double size) {
    return degree < mesh.dimension() ? robin(1.5 / size) : BoundaryCondition::essential;
}

TEST(InputUnits, are_those_of_heat) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int degree) {
        const double step = 0.05 * size * size;
        const Cochain start = any_form(mesh, side, degree);
        const FormSpace held(mesh, side, degree, leaky(mesh, degree, size));
        return joined(
            {heated({mesh, side, degree}, start, step).values, heated(held, start, step).values});
    });
}

// Diffusion by the square of the size in the time 1, or by 1 in the time that this takes.
TEST(InputUnits, are_those_of_evolutions) {
    for (const bool is_fast : {false, true})
        expect_no_unit({}, [=](const Discretization& mesh, double size, Side side, int degree) {
            const double time = is_fast ? 1 : size * size;
            Unknown unknown{.space = {mesh, side, degree, leaky(mesh, degree, size)},
                            .start = any_form(mesh, side, degree).values,
                            .diffusion = size * size / time};
            if (degree == 0)
                unknown.boundary = [&](double t) {
                    const Vector given = std::cos(t / time) * slopes(mesh, size);
                    return BoundaryForms{.derivative_flow = outward_flow(mesh, side, given)};
                };
            Evolution run({unknown},
                          [=](double t, const std::vector<Cochain>& forms) {
                              const double rate = (2 + std::cos(t / time)) / time;
                              return std::vector{Vector(rate * forms[0].values)};
                          },
                          {.steps = {.fixed_step = time / 16}});
            run.march(time / 4);
            return joined({run.form(0).values,
                           Vector{{run.time() / time, 16 * run.report().last_step / time}}});
        });
}

// Where the absolute tolerance is what counts.
TEST(InputUnits, are_those_of_tolerances) {
    expect_no_unit({.names = {"grid4", "kuhn3"}}, [](const Discretization& mesh, double size,
                                                     Side side, int degree) {
        const Cochain start = any_form(mesh, side, degree);
        Evolution run({{.space = {mesh, start.side, start.degree},
                        .start = start.values,
                        .diffusion = size * size}},
                      {},
                      {.steps = {.relative_tolerance = 1e-12,
                                 .absolute_tolerance = 1e-3 * std::pow(size, -start.degree)}});
        run.march(0.01);
        return joined(
            {run.form(0).values, Vector{{run.report().last_step, double(run.report().steps)}}});
    });
}

TEST(InputUnits, are_those_of_forms_with_sources) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int degree) {
        const PoissonSolver solver({mesh, side, degree, leaky(mesh, degree, size)});
        const Cochain f = 1 / (size * size) * any_form(mesh, side, degree);
        BoundaryForms data;
        if (degree == 0)
            data.derivative_flow = outward_flow(mesh, side, slopes(mesh, size));
        const auto found = solver.solve(f, data);
        const int power = side == Side::primal ? 2 : 2 + 2 * degree - mesh.dimension();
        return joined({found.form.values, size * size * found.removed.values,
                       std::pow(size, power) * found.flux.values});
    });
}

TEST(InputUnits, are_those_of_currents) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side, int) {
        const PoissonSolver solver({mesh, Side::primal, 1, {}});
        const Cochain j = 1 / (size * size) * any_form(mesh, Side::primal, 1);
        const auto found = solve_curl_curl(solver, j);
        return joined({found.potential.values, size * size * found.removed.values});
    });
}

Vector norms(const Discretization& mesh, const Spectrum& found) {
    Vector result(found.modes.cols());
    for (Eigen::Index i = 0; i < result.size(); ++i)
        result[i] = norm(mesh, {found.side, found.degree, found.modes.col(i)});
    return result;
}

TEST(InputUnits, are_those_of_spectra) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int degree) {
        const auto found = spectrum({mesh, side, degree, leaky(mesh, degree, size)}, {.count = 5});
        return joined({size * size * found.eigenvalues, norms(mesh, found)});
    });
}

TEST(Spectra, have_no_modes_where_these_are_out_of_range) {
    Mesh mesh = kuhn(5, 1);
    mesh.points *= 1e140;
    const auto found = spectrum({discretize(mesh), Side::primal, 0}, {.count = 1});
    EXPECT_EQ(found.eigenvalues.size(), 1);
    EXPECT_EQ(found.modes.cols(), 0);
    ASSERT_FALSE(found.warnings.empty());
    EXPECT_SAYS(found.warnings.back(), "modes of norm 1", "range");
}

TEST(InputUnits, are_those_of_coexact_spectra) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int degree) {
        if (side == Side::dual || degree == mesh.dimension())
            return Vector();
        const auto found = coexact_spectrum({mesh, Side::primal, degree}, {.count = 3});
        return joined({size * size * joined({found.eigenvalues, found.radii}), norms(mesh, found)});
    });
}

// Of the star of a coexact form, and of the norm of harmonic ones.
TEST(InputUnits, are_those_of_hodge_decompositions) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int degree) {
        const int power = mesh.dimension() - 2 * degree;
        const DenseMatrix harmonic = harmonic_forms({mesh, side, degree}),
                          of_sources = PoissonSolver({mesh, side, degree}).harmonic_forms();
        const Vector copotential =
            hodge_decomposition({mesh, side, degree}, any_form(mesh, side, degree))
                .copotential.values;
        if (power == 0 || copotential.size() + harmonic.size() == 0)
            return Vector();
        return joined({std::pow(size, -power) * copotential,
                       std::pow(size, power / 2.0) * harmonic.reshaped(),
                       std::pow(size, power / 2.0) * of_sources.reshaped()});
    });
}

TEST(InputUnits, are_those_of_waves) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side side, int) {
        const FormSpace space(mesh, side, 0);
        const double stable = stable_step(space) / size;
        WaveOptions options{.time_step = 0.3 * stable * size};
        const Cochain E = any_form(mesh, side, 0), B = any_form(mesh, side, 1);
        options.loss = Vector::Constant(E.values.size(), 0.5 / size);
        options.upper_loss = Vector::Constant(B.values.size(), 0.25 / size);
        if (mesh.points().cols() == mesh.dimension())
            options.layer = {mesh, 0.2 * size, LayerKind::conducting};
        options.B = size * B.values;
        options.source = [&](double) { return Vector(E.values / size); };
        options.upper_source = [&](double) { return B.values; };
        Waves waves(space, E.values, options);
        waves.advance(3);
        return joined({waves.form(0).values, waves.form(1).values / size,
                       Vector{{waves.time_step() / size,
                               waves.energy() / std::pow(size, mesh.dimension())}}});
    });
}

} // namespace polydec::test::in_input_units
