// SPDX-License-Identifier: MIT
//
// Small random surfaces, many of them bad: distances, counts, spectra and errors of each are had or
// refused, and agree with those of the same surface in 64 times as many triangles.
// POLYDEC_HOSTILE_SHAPES=100000 takes so many.
#include "shape/poisson_pair.h"
#include "tests/shape/known_shapes.h"
#include "tests/support/hostile.h"

namespace polydec::test::in_hostile_shapes {

/// How many were asked, and how many were refused.
struct Tally {
    int asked = 0, refused = 0;
};

/// What a call returns; none if the numbers are refused, which must be by an error with a reason.
template <class Call>
auto unless_refused(Tally& tally, Call&& call) -> std::optional<decltype(call())> {
    ++tally.asked;
    try {
        return call();
    } catch (const InvalidInput& error) {
        EXPECT_STRNE(error.what(), "");
    } catch (const SolverFailure& error) {
        EXPECT_STRNE(error.what(), "");
    }
    ++tally.refused;
    return std::nullopt;
}

struct Tallies {
    Tally meshes, distances, counts, spectra, errors, compared;
};

/// A mesh in 64 times as many triangles, and what takes values at its vertices there: midpoints
/// have the mean of two.
struct Refinement {
    Mesh mesh;
    std::vector<SimplicialComplex> before; // each step

    explicit Refinement(const Mesh& coarse) : mesh(coarse) {
        for (int step = 0; step < 3; ++step) {
            before.emplace_back(mesh.simplices);
            mesh = test::divided(mesh);
        }
    }

    Vector operator()(Vector values) const {
        for (const SimplicialComplex& pieces : before)
            values = divided(pieces, values);
        return values;
    }
};

/// The same shape with these conditions and, if any are given, weights.
Shape with(Shape shape, const BoundaryConditions& conditions, const Vector& conductivity = {}) {
    shape.conditions = conditions;
    shape.conductivity = conductivity;
    return shape;
}

/// Linear on triangles, by values at vertices.
PoissonProblem problem_of(const Shape& shape, const Vector& f) {
    const Simplices& corners = shape.pieces.simplices(2);
    PoissonProblem problem{shape, DenseMatrix(corners.rows(), 3), {}};
    for (Index t = 0; t < corners.rows(); ++t)
        for (int i = 0; i < 3; ++i)
            problem.source(t, i) = f[corners(t, i)];
    return problem;
}

class Questions {
public:
    Questions(std::mt19937& random, Tallies& tallies) : random_(random), tallies_(tallies) {}

    void ask(const Mesh& mesh, bool compare) {
        const auto shape = unless_refused(tallies_.meshes, [&] { return unmerged(mesh); });
        if (!shape || shape->pieces.dimension() != 2)
            return;
        std::optional<Refinement> fine;
        std::optional<Shape> same;
        if (compare)
            fine = unless_refused(tallies_.compared, [&] { return Refinement(mesh); });
        if (fine) // else a triangle is there twice, which shapes have once
            same = unless_refused(tallies_.compared, [&] { return unmerged(fine->mesh); });
        distances(*shape, same);
        const auto chosen = conditions(*shape);
        const Vector kappa = compare ? Vector() : weights(shape->pieces.size(2));
        if (same)
            same->conditions = chosen;
        eigenvalues(with(*shape, chosen, kappa), same);
        errors(with(*shape, chosen, kappa), fine, same);
    }

private:
    double number() { return std::uniform_real_distribution<double>(0, 1)(random_); }

    BoundaryConditions conditions(const Shape& shape) {
        const double size = shape.lengths.maxCoeff();
        switch (random_() % 3) {
        case 0:
            return {BoundaryCondition::natural};
        case 1:
            return {BoundaryCondition::essential};
        default:
            return {BoundaryCondition::robin, {}, {2 / size}};
        }
    }

    Vector weights(Index count) {
        Vector result(random_() % 2 == 0 ? 0 : count);
        for (double& weight : result)
            weight = std::pow(10, 2 * number() - 1);
        return result;
    }

    void distances(const Shape& shape, const std::optional<Shape>& same) {
        const Triangles surface(shape.pieces);
        const auto sources = one_of_each_component(surface);
        const auto d = unless_refused(
            tallies_.distances, [&] { return exact_distance(surface, shape.lengths, sources); });
        if (!d)
            return;
        ASSERT_TRUE(d->allFinite() && d->minCoeff() >= 0);
        if (!same)
            return;
        const Triangles fine(same->pieces);
        const auto e = unless_refused(tallies_.compared,
                                      [&] { return exact_distance(fine, same->lengths, sources); });
        if (e) {
            ASSERT_LE((e->head(d->size()) - *d).cwiseAbs().maxCoeff(), 1e-7 * d->maxCoeff());
        }
    }

    void eigenvalues(const Shape& shape, const std::optional<Shape>& same) {
        const int level = 1 + static_cast<int>(random_() % 2);
        const double size = shape.lengths.maxCoeff();
        const double s = 40 * number() / size / size;
        const auto count = unless_refused(tallies_.counts,
                                          [&] { return count_below(shape, s, {.level = level}); });
        if (count) {
            ASSERT_LE(count->at_least, count->at_most.value_or(1000));
        }
        const auto spectrum = [&](const Shape& of) {
            return unless_refused(tallies_.spectra,
                                  [&] { return shape_spectrum(of, {.count = 2, .level = level}); });
        };
        const auto found = spectrum(shape);
        if (found) {
            for (Index j = 0; j < 2; ++j)
                ASSERT_TRUE(found->lower[j] >= 0 && found->lower[j] <= found->upper[j]);
        }
        if (!same)
            return;
        if (const auto again = unless_refused(
                tallies_.compared, [&] { return count_below(*same, s, {.level = level}); });
            again && count) {
            ASSERT_LE(again->at_least, count->at_most.value_or(1000));
            ASSERT_LE(count->at_least, again->at_most.value_or(1000));
        }
        if (const auto again = spectrum(*same); again && found)
            for (Index j = 0; j < 2; ++j) {
                ASSERT_LE(found->lower[j], again->upper[j]);
                ASSERT_LE(again->lower[j], found->upper[j]);
            }
    }

    void errors(const Shape& shape, const std::optional<Refinement>& fine,
                const std::optional<Shape>& same) {
        const double size = shape.lengths.maxCoeff();
        Vector u(shape.pieces.size(0)), f(u.size());
        for (Index v = 0; v < u.size(); ++v) {
            u[v] = number();
            f[v] = (2 * number() - 1) / size / size;
        }
        const auto error =
            unless_refused(tallies_.errors, [&] { return poisson_error(problem_of(shape, f), u); });
        if (!error)
            return;
        ASSERT_TRUE(std::isfinite(error->energy) && error->energy >= 0);
        if (!same || size < 1e-60 || size > 1e60)
            return;
        // u is nearer to Galerkin's solution on the finer mesh than to the exact one
        const auto distance = unless_refused(tallies_.compared, [&] {
            const PoissonForms forms(*same, "auto");
            const auto data = forms.local(problem_of(*same, (*fine)(f)).source, {});
            const DenseMatrix change =
                forms.to_galerkin(forms.at_corners((*fine)(u)), data).values.cast<double>();
            return std::sqrt(std::max(forms.energy(change, change), 0.0));
        });
        if (distance) {
            ASSERT_LE(*distance, error->energy * (1 + 1e-7));
        }
    }

    std::mt19937& random_;
    Tallies& tallies_;
};

TEST(HostileShapes, are_answered_or_refused_and_agree_with_64_times_as_many_triangles) {
    const char* const asked = std::getenv("POLYDEC_HOSTILE_SHAPES");
    const int count = asked != nullptr ? std::atoi(asked) : 200;
    Tallies tallies;
    for (int seed = 0; seed < count && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        std::vector<std::uint8_t> bytes(20 + random() % 60);
        Mesh mesh;
        while (mesh.dimension() != 2) {
            for (auto& byte : bytes)
                byte = static_cast<std::uint8_t>(random());
            mesh = hostile_mesh(bytes);
        }
        Questions(random, tallies).ask(mesh, seed % 10 == 0);
    }
    const auto [meshes, distances, counts, spectra, errors, compared] = tallies;
    const std::vector<std::pair<const char*, Tally>> all{
        {"meshes", meshes},   {"distances", distances}, {"counts", counts},
        {"spectra", spectra}, {"errors", errors},       {"compared", compared}};
    for (const auto& [name, tally] : all)
        RecordProperty(name, std::to_string(tally.refused) + " refused of " +
                                 std::to_string(tally.asked));
    EXPECT_LT(10 * meshes.refused, 9 * meshes.asked);
    EXPECT_LT(2 * distances.refused, distances.asked);
    EXPECT_LT(2 * errors.refused, errors.asked);
}

} // namespace polydec::test::in_hostile_shapes
