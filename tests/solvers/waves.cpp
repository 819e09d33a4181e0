// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_waves {

constexpr BoundaryCondition kinds[] = {BoundaryCondition::essential, BoundaryCondition::natural};

/// Waves of one side and degree, with all that their laws speak of as matrices.
struct WaveSample {
    Discretization mesh;
    Side side;
    int degree;
    BoundaryConditions conditions;
    int e = side == Side::primal ? degree : mesh.dimension() - degree;
    int b = side == Side::primal ? e + 1 : e - 1;
    FormSpace space{mesh, side, degree, conditions};

    SparseMatrix d() const {
        const SparseMatrix of_lower =
            space.relative().complex.coboundary(std::min(e, b)).cast<double>();
        return side == Side::primal ? of_lower
                                    : SparseMatrix((e % 2 == 0 ? 1 : -1) * of_lower.transpose());
    }
    Vector mass(int k) const {
        const Vector star = space.inside().stars()[k].diagonal();
        return side == Side::primal ? star : star.cwiseInverse();
    }
    Vector random(int k, unsigned seed) const {
        const Index kept = space.relative().complex.size(k);
        return space.relative().extend(k, random_vector(kept, seed));
    }
    Vector kept(int k, const Vector& values) const { return space.relative().restrict(k, values); }

    /// From random values, or a B that is given.
    Waves wave(WaveOptions options) const {
        if (options.B.size() == 0)
            options.B = random(b, 2);
        return {space, random(e, 1), options};
    }
};

/// Grids of every kind of cell, under both conditions, of every degree and side.
std::vector<WaveSample> samples() {
    std::vector<WaveSample> result;
    const Mesh meshes[] = {well_centered(4), grid(4, 4), hexagons(4), kuhn(3, 3),
                           fcc(2),           bcc(2),     torus(8, 6), kuhn(1, 5)};
    for (const Mesh& mesh : meshes) {
        const auto cells = circumcentric(mesh);
        for (const Side side : {Side::primal, Side::dual})
            for (int degree = 0; degree < cells.dimension(); ++degree)
                for (const auto kind : kinds) {
                    WaveSample waves{cells, side, degree, {kind}};
                    const auto bad = [&](int k) {
                        return !waves.space.inside().stars()[k].zeros().empty() ||
                               !waves.space.inside().stars()[k].negatives().empty() ||
                               waves.space.relative().complex.size(k) == 0;
                    };
                    if (!bad(waves.e) && !bad(waves.b))
                        result.push_back(std::move(waves));
                }
    }
    return result;
}

std::string in_words(const WaveSample& waves) {
    return std::string(name(waves.side)) + " " + std::to_string(waves.degree) + "-forms in " +
           std::to_string(waves.mesh.dimension()) + " dimensions, " + waves.space.in_words();
}

double half_stable(const WaveSample& waves) {
    return stable_step({waves.mesh, waves.side, waves.degree, waves.conditions}) / 2;
}

TEST(WavesOfBothSides, are_on_every_mesh_and_degree) {
    int dual = 0;
    for (const WaveSample& waves : samples())
        dual += waves.side == Side::dual;
    EXPECT_GE(dual, 20);
    EXPECT_GE(std::ssize(samples()), 50);
}

TEST(WavesOfBothSides, have_minus_delta_d_as_their_second_difference) {
    for (const WaveSample& waves : samples()) {
        const double dt = half_stable(waves);
        Waves run = waves.wave({.time_step = dt});
        const Vector before = run.form(0).values;
        run.advance();
        const Vector now = run.form(0).values;
        run.advance();
        const Vector difference = waves.kept(waves.e, run.form(0).values - 2 * now + before);
        const SparseMatrix d = waves.d();
        const Vector flow = waves.mass(waves.b).cwiseProduct(d * waves.kept(waves.e, now));
        const Vector expected =
            -dt * dt * (d.transpose() * flow).cwiseQuotient(waves.mass(waves.e));
        EXPECT_CLOSE(difference, expected, 1e-12) << in_words(waves);
        EXPECT_GT(relative_difference(difference, 1.01 * expected), 1e-3) << "of another speed";
    }
}

TEST(WavesOfBothSides, keep_their_energy) {
    for (const WaveSample& waves : samples()) {
        Waves run = waves.wave({.time_step = 1.9 * half_stable(waves)});
        const double begin = run.energy();
        const auto squares_now = [&] {
            const Vector b = waves.kept(waves.b, run.form(1).values);
            return b.dot(waves.mass(waves.b).cwiseProduct(b));
        };
        run.advance();
        const double first = squares_now();
        run.advance(199);
        const double squares = squares_now();
        EXPECT_NEAR(run.energy(), begin, 1e-11 * begin) << in_words(waves);
        EXPECT_GT(std::abs(squares - first), 1e-6 * first) << "a part of it is kept alone";
    }
}

TEST(WavesOfBothSides, are_stars_of_each_other) {
    // with H = star B and D = star E a primal wave of degree k - 1 is a dual one of degree n - k
    const auto mesh = circumcentric(kuhn(3, 3));
    const int n = 3;
    for (int k = 1; k <= n; ++k) {
        const WaveSample dual{mesh, Side::dual, n - k, {BoundaryCondition::essential}};
        const WaveSample primal{mesh, Side::primal, k - 1, {BoundaryCondition::natural}};
        EXPECT_NEAR(half_stable(dual), half_stable(primal), 1e-6 * half_stable(primal));
    }
}

/// The energy that a step finds, by the B half a step before and after.
double energy(const WaveSample& waves, const Vector& E, const Vector& before, const Vector& after) {
    const Vector e = waves.kept(waves.e, E);
    return (e.dot(waves.mass(waves.e).cwiseProduct(e)) +
            waves.kept(waves.b, before)
                .dot(waves.mass(waves.b).cwiseProduct(waves.kept(waves.b, after)))) /
           2;
}

/// What is missing in the balance of energy of a step in the middle of others, of what flows in
/// one; losses as the balance believes them are those given times `believed`.
double imbalance(const WaveSample& waves, double believed) {
    const double dt = half_stable(waves);
    WaveOptions options{.time_step = dt};
    options.loss = random_vector(waves.mesh.complex().size(waves.e), 5).cwiseAbs() / dt;
    const Vector source = waves.random(waves.e, 6) / dt, upper = waves.random(waves.b, 7) / dt;
    options.source = [=](double) { return source; };
    options.upper_source = [=](double) { return upper; };
    Waves run = waves.wave(options);
    const Vector B0 = run.form(1).values, E0 = run.form(0).values;
    run.advance();
    const Vector B1 = run.form(1).values, E1 = run.form(0).values;
    run.advance();
    const Vector B2 = run.form(1).values;
    const Vector mean = waves.kept(waves.e, E0 + E1) / 2;
    const Vector loss = waves.kept(waves.e, options.loss);
    const double flow =
        mean.dot(waves.mass(waves.e).cwiseProduct(waves.kept(waves.e, source) -
                                                  believed * loss.cwiseProduct(mean))) +
        waves.kept(waves.b, B1).dot(waves.mass(waves.b).cwiseProduct(waves.kept(waves.b, upper)));
    const double change = energy(waves, E1, B1, B2) - energy(waves, E0, B0, B1);
    return std::abs(change - dt * flow) / (std::abs(dt * flow) + energy(waves, E0, B0, B0));
}

TEST(WavesWithLosses, balance_their_energy_to_rounding) {
    for (const WaveSample& waves : samples()) {
        EXPECT_LE(imbalance(waves, 1), 1e-11) << in_words(waves);
        EXPECT_GT(imbalance(waves, 0.9), 1e-5) << "with other losses";
    }
}

/// The energy after 20 steps as a part of that before; each value of E decays at this rate.
double energy_left(const WaveSample& waves, double loss) {
    WaveOptions options{.time_step = half_stable(waves)};
    options.loss = Vector::Constant(waves.mesh.complex().size(waves.e), loss / options.time_step);
    options.B = Vector::Zero(waves.mesh.complex().size(waves.b));
    Waves run = waves.wave(options);
    run.advance(20);
    return run.relative_energy().value();
}

// A loss that is the same everywhere commutes with every star, so a matrix that is a diagonal one
// but for rounding must lose as that does.
TEST(WavesWithLosses, die_away_alike_where_stars_are_matrices) {
    const auto diagonal = circumcentric(kuhn(3, 2));
    const Vector ones = Vector::Ones(diagonal.complex().size(3));
    for (const Side side : {Side::primal, Side::dual})
        for (int degree = 0; degree < 3; ++degree) {
            const int k = side == Side::primal ? degree : 3 - degree;
            const BoundaryConditions conditions{side == Side::primal ? BoundaryCondition::essential
                                                                     : BoundaryCondition::natural};
            const auto as_matrix = diagonal.with_stars(
                diagonal.stars().with(k, SparseMatrix(diagonal.stars()[k].matrix())));
            const WaveSample one{diagonal, side, degree, conditions};
            const WaveSample other{as_matrix, side, degree, conditions};
            EXPECT_NEAR(energy_left(other, 0), 1, 1e-11) << name(side) << degree;
            EXPECT_NEAR(energy_left(other, 0.1), energy_left(one, 0.1), 1e-9)
                << name(side) << degree;
            EXPECT_LT(energy_left(other, 0.1), 0.5) << name(side) << degree;
        }
    for (const Side side : {Side::primal, Side::dual}) {
        const int k = side == Side::primal ? 1 : 2;
        const auto mesh = diagonal.with_stars(
            diagonal.stars().with(k, material_star(diagonal, k, CellData::on_cells(ones))));
        const WaveSample waves{mesh, side, 1, {BoundaryCondition::essential}};
        EXPECT_NEAR(energy_left(waves, 0), 1, 1e-11) << name(side);
        EXPECT_LT(energy_left(waves, 0.1), 0.5) << name(side);
    }
}

TEST(WavesWithLosses, keep_the_divergence_of_their_fluxes) {
    const auto mesh = circumcentric(kuhn(3, 3));
    const WaveSample waves{mesh, Side::primal, 1, {BoundaryCondition::essential}};
    WaveOptions options{.time_step = half_stable(waves)};
    const SparseMatrix out = mesh.complex().coboundary(2).cast<double>();
    const auto divergence = [&](double magnetic) {
        options.loss = Vector::Constant(mesh.complex().size(1), 0.3);
        options.upper_loss = magnetic * random_vector(mesh.complex().size(2), 3).cwiseAbs();
        options.B = Vector::Zero(mesh.complex().size(2));
        options.source = [source = waves.random(1, 9)](double) { return source; };
        Waves run = waves.wave(options);
        run.advance(100);
        const Vector B = run.form(1).values;
        return (out * B).norm() / B.norm();
    };
    EXPECT_LE(divergence(0), 1e-13);
    EXPECT_GT(divergence(1), 1e-3) << "magnetic losses are sources of B";
}

TEST(WavesWithLosses, warn_of_rates_that_steps_do_not_follow) {
    const auto mesh = circumcentric(grid(3, 3));
    const Vector start = Vector::Ones(mesh.size(0));
    const auto warnings = [&](double rate) {
        return Waves({mesh, Side::primal, 0, BoundaryCondition::natural}, start,
                     {.time_step = 0.01, .loss = Vector::Constant(start.size(), rate)})
            .warnings();
    };
    EXPECT_TRUE(warnings(199).empty());
    ASSERT_EQ(warnings(201).size(), 1u);
    EXPECT_SAYS(warnings(201)[0], "losses of E", "201", "0.01");
    // not of those of values that are fixed
    for (const WaveSample& waves : samples()) {
        const auto losses = [&](int k, double free) {
            const Vector kept = Vector::Constant(waves.space.relative().complex.size(k), free);
            Vector result = Vector::Constant(waves.mesh.complex().size(k), 1e9);
            result(waves.space.relative().cells[k]) = kept;
            return result;
        };
        const auto count = [&](double free) {
            const double dt = half_stable(waves);
            return std::ssize(waves
                                  .wave({.time_step = dt,
                                         .loss = losses(waves.e, free / dt),
                                         .upper_loss = losses(waves.b, free / dt)})
                                  .warnings());
        };
        EXPECT_EQ(count(1.9), 0) << in_words(waves);
        EXPECT_EQ(count(2.1), 2) << in_words(waves);
    }
}

TEST(WavesOfBothSides, are_0_where_they_are_fixed_whatever_is_given) {
    for (const WaveSample& waves : samples()) {
        const Vector E = random_vector(waves.mesh.complex().size(waves.e), 1);
        Vector B = random_vector(waves.mesh.complex().size(waves.b), 2);
        const double dt = half_stable(waves);
        Waves run(waves.space, E, {.time_step = dt, .B = B});
        const auto kept = [&](int k, const Vector& values) {
            return waves.space.relative().extend(k, waves.kept(k, values));
        };
        EXPECT_EQ(run.form(0).values, kept(waves.e, E)) << in_words(waves);
        EXPECT_EQ(run.form(1).values, kept(waves.b, B)) << in_words(waves);
        B[0] = std::nan("");
        EXPECT_REFUSED(Waves(waves.space, E, {.time_step = dt, .B = B}), "values of B", "nan");
        EXPECT_REFUSED(Waves(waves.space, E, {.time_step = dt, .B = Vector::Ones(1)}),
                       "values of B", "expected");
    }
}

TEST(Materials, weigh_diagonal_stars_by_the_parts_of_duals) {
    for (const Mesh& input : {grid(3, 3), kuhn(3, 2), well_centered(3)}) {
        const auto mesh = circumcentric(input);
        const int n = mesh.dimension();
        for (int k = 0; k <= n; ++k) {
            const Vector two = Vector::Constant(mesh.complex().size(n), 2);
            const Vector twice = weighted_stars(mesh, k, CellData::on_cells(two))[k].diagonal();
            EXPECT_CLOSE(twice, 2 * mesh.stars()[k].diagonal(), 1e-14);
            const Vector weights =
                Vector::Ones(two.size()) + random_vector(two.size(), 3).cwiseAbs();
            const Vector means = cell_means(mesh, k, CellData::on_cells(weights));
            EXPECT_GE(means.minCoeff(), weights.minCoeff() - 1e-14);
            EXPECT_LE(means.maxCoeff(), weights.maxCoeff() + 1e-14);
            // the sums over all of |s||*s| count each n-cell binomial(n, k) times
            const Vector products = mesh.volumes().primal(k).cwiseProduct(mesh.volumes().dual(k));
            const double all = weights.dot(mesh.volumes().primal(n));
            EXPECT_NEAR(products.dot(means) / products.sum(), all / mesh.volumes().primal(n).sum(),
                        1e-12);
        }
    }
}

TEST(Waves, from_rest_are_told_apart_by_their_spaces) {
    const auto mesh = circumcentric(well_centered(4));
    const auto known = [](const FormSpace& space) {
        const Vector rest = Vector::Zero(space.cells().complex().size(0));
        return Waves(space, rest, {.time_step = 1e-3}).fingerprint().value().value();
    };
    const FormSpace space(mesh, Side::primal, 0);
    EXPECT_EQ(known(space), known({mesh, Side::primal, 0}));
    EXPECT_NE(known(space), known({mesh, Side::primal, 0, {BoundaryCondition::essential}}));
    EXPECT_NE(known(space), known({mesh.with_stars(StarKind::barycentric), Side::primal, 0}));
}

TEST(WaveErrors, name_losses_layers_and_sides) {
    const auto mesh = circumcentric(grid(4, 4));
    const BoundaryConditions conditions{BoundaryCondition::natural};
    const double dt = 1e-3;
    const auto made = [&](WaveOptions options, const Discretization& on) {
        options.time_step = dt;
        const Vector u = Vector::Zero(on.complex().size(0));
        return refusal([&] { Waves({on, Side::primal, 0, conditions}, u, options); });
    };
    EXPECT_SAYS(made({.loss = Vector::Constant(25, -1)}, mesh), "loss", "value 0", "E", "-1");
    EXPECT_NE(made({.loss = Vector::Ones(3)}, mesh).find("losses of E"), std::string::npos);
    EXPECT_SAYS(made({.layer = AbsorbingLayer{mesh, 2}}, mesh), "width", "layer", "2", "0", "1");
    EXPECT_SAYS(made({.layer = AbsorbingLayer{.mesh = mesh, .width = 0.2, .reflection = 2}}, mesh),
                "layer", "reflection 2", "power 3");
    EXPECT_SAYS(made({.layer = AbsorbingLayer{circumcentric(grid(5, 4)), 0.2}}, mesh), "30",
                "0-cells", "layer's mesh", "25");
    EXPECT_REFUSED(stable_step({mesh, Side::dual, 2, conditions}), "waves", "2-forms",
                   "dimension 2", "0", "1");
    const auto triangles = circumcentric(well_centered(8));
    EXPECT_SAYS(made({.layer = AbsorbingLayer{triangles, 0.2, LayerKind::stretched}}, triangles),
                "parallel", "axes");
}

} // namespace polydec::test::in_waves
