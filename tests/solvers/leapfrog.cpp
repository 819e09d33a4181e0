// SPDX-License-Identifier: MIT
#include "solvers/leapfrog.h"

#include "dec/fields/de_rham.h"
#include "dec/forms/boundary_conditions.h"
#include "dec/material_stars.h"
#include "meshes/generate.h"
#include "tests/support/circumcentric.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::test::in_leapfrog {
namespace {

constexpr BoundaryCondition kinds[] = {BoundaryCondition::essential, BoundaryCondition::natural};

/// Waves of one side and degree, with all that their laws speak of as matrices.
struct Waves {
    Discretization mesh;
    Side side;
    int degree;
    BoundaryConditions conditions;
    int e = side == Side::primal ? degree : mesh.dimension() - degree;
    int b = side == Side::primal ? e + 1 : e - 1;
    ConditionedComplex space = conditioned_complex(mesh, side, degree, conditions);

    SparseMatrix d() const {
        const SparseMatrix of_lower =
            space.relative.complex.coboundary(std::min(e, b)).cast<double>();
        return side == Side::primal ? of_lower
                                    : SparseMatrix((e % 2 == 0 ? 1 : -1) * of_lower.transpose());
    }
    Vector mass(int k) const {
        const Vector star = space.stars[k].diagonal();
        return side == Side::primal ? star : star.cwiseInverse();
    }
    Vector random(int k, unsigned seed) const {
        const Index kept = space.relative.complex.size(k);
        return space.relative.extend(k, random_vector(kept, seed));
    }
    Vector kept(int k, const Vector& values) const { return space.relative.restrict(k, values); }
};

/// Grids of every kind of cell, under both conditions, of every degree and side.
std::vector<Waves> samples() {
    std::vector<Waves> result;
    const Mesh meshes[] = {well_centered(4), grid(4, 4), hexagons(4), kuhn(3, 3),
                           fcc(2),           bcc(2),     torus(8, 6), kuhn(1, 5)};
    for (const Mesh& mesh : meshes) {
        const auto cells = circumcentric(mesh);
        for (const Side side : {Side::primal, Side::dual})
            for (int degree = 0; degree < cells.dimension(); ++degree)
                for (const auto kind : kinds) {
                    Waves waves{cells, side, degree, {kind}};
                    const auto bad = [&](int k) {
                        return !waves.space.stars[k].zeros().empty() ||
                               !waves.space.stars[k].negatives().empty() ||
                               waves.space.relative.complex.size(k) == 0;
                    };
                    if (!bad(waves.e) && !bad(waves.b))
                        result.push_back(std::move(waves));
                }
    }
    return result;
}

std::string in_words(const Waves& waves) {
    return std::string(name(waves.side)) + " " + std::to_string(waves.degree) + "-forms in " +
           std::to_string(waves.mesh.dimension()) + " dimensions, " +
           in_words(waves.conditions, waves.mesh.complex(), waves.degree);
}

double half_stable(const Waves& waves) {
    return stable_step(waves.mesh, waves.conditions, waves.side, waves.degree) / 2;
}

TEST(WavesOfBothSides, are_on_every_mesh_and_degree) {
    int dual = 0;
    for (const Waves& waves : samples())
        dual += waves.side == Side::dual;
    EXPECT_GE(dual, 20);
    EXPECT_GE(std::ssize(samples()), 50);
}

TEST(WavesOfBothSides, have_minus_delta_d_as_their_second_difference) {
    for (const Waves& waves : samples()) {
        const double dt = half_stable(waves);
        const Leapfrog leapfrog(waves.mesh, waves.conditions, waves.side, waves.degree,
                                {.time_step = dt});
        WaveState state{waves.random(waves.e, 1), waves.random(waves.b, 2)};
        const Vector before = state.E;
        leapfrog.step(state);
        const Vector now = state.E;
        leapfrog.step(state);
        const Vector difference = waves.kept(waves.e, state.E - 2 * now + before);
        const SparseMatrix d = waves.d();
        const Vector flow = waves.mass(waves.b).cwiseProduct(d * waves.kept(waves.e, now));
        const Vector expected =
            -dt * dt * (d.transpose() * flow).cwiseQuotient(waves.mass(waves.e));
        EXPECT_LE(relative_difference(difference, expected), 1e-12) << in_words(waves);
        EXPECT_GT(relative_difference(difference, 1.01 * expected), 1e-3) << "of another speed";
    }
}

TEST(WavesOfBothSides, keep_their_energy) {
    for (const Waves& waves : samples()) {
        const Leapfrog leapfrog(waves.mesh, waves.conditions, waves.side, waves.degree,
                                {.time_step = 1.9 * half_stable(waves)});
        WaveState state{waves.random(waves.e, 1), waves.random(waves.b, 2)};
        const double begin = leapfrog.energy(state.E, state.B);
        double squares = 0, first = 0;
        for (int i = 0; i < 200; ++i) {
            leapfrog.step(state);
            const Vector b = waves.kept(waves.b, state.B);
            squares = b.dot(waves.mass(waves.b).cwiseProduct(b));
            first = i == 0 ? squares : first;
        }
        EXPECT_NEAR(leapfrog.energy(state.E, state.B), begin, 1e-11 * begin) << in_words(waves);
        EXPECT_GT(std::abs(squares - first), 1e-6 * first) << "a part of it is kept alone";
    }
}

TEST(WavesOfBothSides, are_stars_of_each_other) {
    // with H = star B and D = star E a primal wave of degree k - 1 is a dual one of degree n - k
    const auto mesh = circumcentric(kuhn(3, 3));
    const int n = 3;
    for (int k = 1; k <= n; ++k) {
        const Waves dual{mesh, Side::dual, n - k, {BoundaryCondition::essential}};
        const Waves primal{mesh, Side::primal, k - 1, {BoundaryCondition::natural}};
        EXPECT_NEAR(half_stable(dual), half_stable(primal), 1e-6 * half_stable(primal));
    }
}

/// The energy that a step finds, by the B half a step before and after.
double energy(const Waves& waves, const Vector& E, const Vector& before, const Vector& after) {
    const Vector e = waves.kept(waves.e, E);
    return (e.dot(waves.mass(waves.e).cwiseProduct(e)) +
            waves.kept(waves.b, before)
                .dot(waves.mass(waves.b).cwiseProduct(waves.kept(waves.b, after)))) /
           2;
}

/// What is missing in the balance of energy of a step in the middle of others, of what flows in
/// one; losses as the balance believes them are those given times `believed`.
double imbalance(const Waves& waves, double believed) {
    const double dt = half_stable(waves);
    LeapfrogOptions options{.time_step = dt};
    options.loss = random_vector(waves.mesh.complex().size(waves.e), 5).cwiseAbs() / dt;
    const Leapfrog leapfrog(waves.mesh, waves.conditions, waves.side, waves.degree, options);
    const WaveSources sources{waves.random(waves.e, 6) / dt, waves.random(waves.b, 7) / dt};
    WaveState state{waves.random(waves.e, 1), waves.random(waves.b, 2)};
    const Vector B0 = state.B, E0 = state.E;
    leapfrog.step(state, sources);
    const Vector B1 = state.B, E1 = state.E;
    leapfrog.step(state, sources);
    const Vector B2 = state.B;
    const Vector mean = waves.kept(waves.e, E0 + E1) / 2;
    const Vector loss = waves.kept(waves.e, options.loss);
    const double flow = mean.dot(waves.mass(waves.e).cwiseProduct(
                            waves.kept(waves.e, sources.E) - believed * loss.cwiseProduct(mean))) +
                        waves.kept(waves.b, B1)
                            .dot(waves.mass(waves.b).cwiseProduct(waves.kept(waves.b, sources.B)));
    const double change = energy(waves, E1, B1, B2) - energy(waves, E0, B0, B1);
    return std::abs(change - dt * flow) / (std::abs(dt * flow) + energy(waves, E0, B0, B0));
}

TEST(WavesWithLosses, balance_their_energy_to_rounding) {
    for (const Waves& waves : samples()) {
        EXPECT_LE(imbalance(waves, 1), 1e-11) << in_words(waves);
        EXPECT_GT(imbalance(waves, 0.9), 1e-5) << "with other losses";
    }
}

/// The energy after 20 steps as a part of that before; each value of E decays at this rate.
double energy_left(const Waves& waves, double loss) {
    LeapfrogOptions options{.time_step = half_stable(waves)};
    options.loss = Vector::Constant(waves.mesh.complex().size(waves.e), loss / options.time_step);
    const Leapfrog leapfrog(waves.mesh, waves.conditions, waves.side, waves.degree, options);
    WaveState state{waves.random(waves.e, 1), Vector::Zero(waves.mesh.complex().size(waves.b))};
    const double begin = leapfrog.energy(state.E, state.B);
    for (int i = 0; i < 20; ++i)
        leapfrog.step(state);
    return leapfrog.energy(state.E, state.B) / begin;
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
            const Waves one{diagonal, side, degree, conditions};
            const Waves other{as_matrix, side, degree, conditions};
            EXPECT_NEAR(energy_left(other, 0), 1, 1e-11) << name(side) << degree;
            EXPECT_NEAR(energy_left(other, 0.1), energy_left(one, 0.1), 1e-9)
                << name(side) << degree;
            EXPECT_LT(energy_left(other, 0.1), 0.5) << name(side) << degree;
        }
    for (const Side side : {Side::primal, Side::dual}) {
        const int k = side == Side::primal ? 1 : 2;
        const auto mesh = diagonal.with_stars(
            diagonal.stars().with(k, material_star(diagonal, k, CellData::on_cells(ones))));
        const Waves waves{mesh, side, 1, {BoundaryCondition::essential}};
        EXPECT_NEAR(energy_left(waves, 0), 1, 1e-11) << name(side);
        EXPECT_LT(energy_left(waves, 0.1), 0.5) << name(side);
    }
}

TEST(WavesWithLosses, keep_the_divergence_of_their_fluxes) {
    const auto mesh = circumcentric(kuhn(3, 3));
    const Waves waves{mesh, Side::primal, 1, {BoundaryCondition::essential}};
    LeapfrogOptions options{.time_step = half_stable(waves)};
    const SparseMatrix out = mesh.complex().coboundary(2).cast<double>();
    const auto divergence = [&](double magnetic) {
        options.loss = Vector::Constant(mesh.complex().size(1), 0.3);
        options.upper_loss = magnetic * random_vector(mesh.complex().size(2), 3).cwiseAbs();
        const Leapfrog leapfrog(mesh, waves.conditions, Side::primal, 1, options);
        WaveState state{waves.random(1, 1), Vector::Zero(mesh.complex().size(2))};
        const WaveSources sources{waves.random(1, 9)};
        for (int i = 0; i < 100; ++i)
            leapfrog.step(state, sources);
        return (out * state.B).norm() / state.B.norm();
    };
    EXPECT_LE(divergence(0), 1e-13);
    EXPECT_GT(divergence(1), 1e-3) << "magnetic losses are sources of B";
}

TEST(Materials, weigh_diagonal_stars_by_the_parts_of_duals) {
    for (const Mesh& input : {grid(3, 3), kuhn(3, 2), well_centered(3)}) {
        const auto mesh = circumcentric(input);
        const int n = mesh.dimension();
        for (int k = 0; k <= n; ++k) {
            const Vector two = Vector::Constant(mesh.complex().size(n), 2);
            const Vector twice = weighted_stars(mesh, k, CellData::on_cells(two))[k].diagonal();
            EXPECT_LE(relative_difference(twice, 2 * mesh.stars()[k].diagonal()), 1e-14);
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

TEST(Materials, slow_waves_down) {
    const auto mesh = circumcentric(kuhn(2, 4));
    const Vector four = Vector::Constant(mesh.complex().size(2), 4);
    for (const int k : {0, 1}) {
        const auto slow = mesh.with_stars(weighted_stars(mesh, k, CellData::on_cells(four)));
        EXPECT_NEAR(stable_step(slow, k), 2 * stable_step(mesh, k), 1e-6);
    }
}

TEST(WaveErrors, name_losses_layers_and_sides) {
    const auto mesh = circumcentric(grid(4, 4));
    const BoundaryConditions conditions{BoundaryCondition::natural};
    const double dt = 1e-3;
    const auto made = [&](LeapfrogOptions options) {
        options.time_step = dt;
        return refusal([&] { Leapfrog(mesh, conditions, Side::primal, 0, options); });
    };
    EXPECT_TRUE(says(made({.loss = Vector::Constant(25, -1)}), {"loss", "value 0", "E", "-1"}));
    EXPECT_NE(made({.loss = Vector::Ones(3)}).find("losses of E"), std::string::npos);
    EXPECT_TRUE(says(made({.layer = {.width = 2}}), {"layer", "width 2", "0", "1"}));
    EXPECT_TRUE(says(made({.layer = {.width = 0.2, .reflection = 2}}),
                     {"layer", "reflection 2", "power 3"}));
    EXPECT_TRUE(says(refusal([&] {
                         Leapfrog(Cells(mesh), built_in_conditions(Side::primal), Side::primal, 0,
                                  {.time_step = dt, .layer = {.width = 0.2}});
                     }),
                     {"layer", "cells", "mesh"}));
    EXPECT_TRUE(says(refusal([&] { stable_step(mesh, conditions, Side::dual, 2); }),
                     {"waves", "2-forms", "dimension 2", "0", "1"}));
    const auto triangles = circumcentric(well_centered(8));
    EXPECT_TRUE(
        says(refusal([&] {
                 Leapfrog(triangles, conditions, Side::primal, 0,
                          {.time_step = dt, .layer = {.width = 0.2, .kind = LayerKind::stretched}});
             }),
             {"parallel", "axes"}));
}

} // namespace
} // namespace polydec::test::in_leapfrog
