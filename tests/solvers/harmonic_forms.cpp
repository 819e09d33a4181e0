// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"
#include "tests/support/slivers.h"

namespace polydec::test::in_harmonic_forms {

/// Constant forms are harmonic, and every consistent scheme has them exactly.
struct Constant {
    int n, degree;
    Vector coefficients;

    SmoothForm form() const { return constant_form(coefficients); }
    SmoothForm star() const { return constant_form(euclidean_star(n, degree, coefficients)); }
    Cochain on(const Discretization& mesh, Side side) const {
        return side == Side::primal ? de_rham(mesh, degree, form())
                                    : dual_de_rham(mesh, degree, form());
    }
    /// All that is known of it; its derivatives are 0.
    BoundaryForms boundary(const Discretization& mesh, Side side) const {
        const auto over_cells = [&](int k, const SmoothForm& w) {
            return k <= n ? de_rham(mesh, k, w).values : Vector();
        };
        const auto over_duals = [&](int k, const SmoothForm& w) {
            return k < n ? boundary_de_rham(mesh, k, w) : Vector();
        };
        if (side == Side::primal)
            return {.values = over_cells(degree, form()),
                    .flow = degree > 0 ? over_duals(n - degree, star()) : Vector()};
        return {.values = degree < n ? over_duals(degree, form()) : Vector(),
                .flow = over_cells(n - degree, star())};
    }
};

struct Shape {
    const char* name;
    std::function<Mesh()> make;
    DiscretizeOptions options = {};
    double jitter = 0;         ///< by which what is cospherical is not
    bool lengths_only = false; ///< whether solvers are given no points
};

void PrintTo(const Shape& shape, std::ostream* out) {
    *out << shape.name;
}

class HarmonicForms : public testing::TestWithParam<Shape> {
protected:
    struct Sample {
        Discretization places; ///< the same mesh with its points
        Discretization mesh;
    };

    /// Made once for all laws.
    static const std::vector<Sample>& with_all_stars() {
        static std::map<std::string, std::vector<Sample>> made;
        const Shape& shape = GetParam();
        auto& result = made[shape.name];
        if (!result.empty())
            return result;
        const auto places = discretize(shape.make(), shape.options);
        const auto mesh =
            shape.lengths_only ? discretize(length_mesh(shape.make()), shape.options) : places;
        for (const StarKind kind :
             {StarKind::circumcentric, StarKind::galerkin, StarKind::hybrid, StarKind::automatic})
            if (kind != StarKind::hybrid || mesh.dimension() == 2)
                result.push_back({places.with_stars(kind), mesh.with_stars(kind)});
        return result;
    }

    static bool is_positive(const HodgeStar& star) {
        return star.zeros().empty() && star.negatives().empty();
    }
};

TEST_P(HarmonicForms, are_returned_and_stand_still) {
    const double rounding = 1e-10 + 100 * GetParam().jitter;
    int solved = 0;
    for (const auto& [places, mesh] : with_all_stars()) {
        SCOPED_TRACE(name(mesh.chosen_stars().kind));
        const int n = mesh.dimension();
        for_all_conditions(n, [&, &places = places, &mesh = mesh](Side side, int degree,
                                                                  Where where) {
            const int k = side == Side::primal ? degree : n - degree;
            if (!is_positive(mesh.stars()[k]) || (k > 0 && !is_positive(mesh.stars()[k - 1])))
                return;
            if (where == Where::robin && side == Side::dual)
                return; // data where facets meet are no integrals of a form
            const Constant constant{n, degree, random_vector(coefficients(n, degree), 1 + degree)};
            const auto conditions = conditions_of(places, where);
            const Cochain u = constant.on(places, side);
            BoundaryForms data = constant.boundary(places, side);
            if (where == Where::robin && k < n) {
                const double sign = k % 2 == 0 ? 1 : -1; // see FormEquations
                data.derivative_flow =
                    sign * dual_boundary_derivative(mesh.complex(), n - 1 - k).transpose() *
                    Vector(FormSpace(mesh, side, degree, conditions).robin_weights() * u.values);
            }
            const PoissonSolver solver({mesh, side, degree, conditions});
            const DenseMatrix H = solver.harmonic_forms();
            Vector harmonic(H.cols());
            for (Index i = 0; i < harmonic.size(); ++i)
                harmonic[i] = inner_product(mesh, u, {side, degree, H.col(i)});
            const auto found = solver.solve(0.0 * u, data, harmonic);
            const double size = norm(mesh, u);
            EXPECT_LE(norm(mesh, found.form - u), rounding * size);

            const Diffusion diffusion({mesh, side, degree, conditions});
            const Vector values = diffusion.values_of(u.values, data);
            const Vector rate = diffusion.rate(values) + diffusion.boundary_rate(data);
            EXPECT_LE(rate.norm(), rounding * (diffusion.rate(values).norm() + size));
            ++solved;
        });
    }
    EXPECT_GT(solved, 6);
}

/// How far a function is from a linear one.
double distance(Vector u, const Vector& linear, bool up_to_a_constant) {
    u -= linear;
    if (up_to_a_constant)
        u.array() -= u[0];
    return u.norm() / linear.norm();
}

TEST_P(HarmonicForms, that_are_linear_functions_come_back_and_stand_still) {
    const double rounding = 1e-10 + 100 * GetParam().jitter;
    int solved = 0;
    for (const auto& sample : with_all_stars())
        for (const Side side : sides)
            for (const Where where : everywhere) {
                const Discretization &places = sample.places, &mesh = sample.mesh;
                const int n = mesh.dimension(), k = side == Side::primal ? 0 : n;
                const int beside = side == Side::primal ? 1 : n - 1;
                SCOPED_TRACE(testing::Message() << name(mesh.chosen_stars().kind) << name(side)
                                                << ", condition " << int(where));
                const auto x = places.points().col(0);
                const auto conditions =
                    conditions_of(places, where, (x.minCoeff() + x.maxCoeff()) / 2);
                std::optional<PoissonSolver> poisson;
                const auto refused =
                    refusal([&] { poisson.emplace(FormSpace(mesh, side, 0, conditions)); });
                if (refused != "accepted") {
                    EXPECT_SAYS(refused, "facet", "length");
                    continue;
                }
                const Vector slope = random_vector(n, 4);
                const Vector u = (sites(places, side) * slope).array() + 1;
                const Vector given = (boundary_sites(places, side) * slope).array() + 1;
                Vector derivatives = outward_normals(places) * slope;
                if (where == Where::robin && side == Side::dual)
                    derivatives +=
                        robin_coefficients(mesh.complex(), conditions).cwiseProduct(given);
                const bool free = where == Where::natural;
                BoundaryForms data{.values = given,
                                   .derivative_flow = outward_flow(mesh, side, derivatives)};
                if (where == Where::robin && side == Side::primal)
                    data.derivative_flow += poisson->space().robin_weights() * u;
                const auto found = [&](double factor) {
                    BoundaryForms flow = data;
                    flow.derivative_flow *= factor;
                    const Cochain none{side, 0, Vector::Zero(u.size())};
                    return distance(poisson->solve(none, flow).form.values, u, free);
                };
                EXPECT_LE(found(1), 0.1 * rounding);
                if (where != Where::essential && u.size() > 1) {
                    EXPECT_GT(found(-1), 1e-2) << "with the flux reversed";
                }
                ++solved;
                if (!is_positive(mesh.stars()[k]) || !is_positive(mesh.stars()[beside]))
                    continue;

                const Diffusion diffusion({mesh, side, 0, conditions});
                const Vector values = diffusion.values_of(u, data);
                const Vector alone = diffusion.rate(values);
                EXPECT_LE((alone + diffusion.boundary_rate(data)).norm(),
                          rounding * (alone.norm() + u.norm()));
                if (diffusion.size() > 1) {
                    EXPECT_GT(alone.norm(), 1e-3) << "without the data";
                }
            }
    EXPECT_GT(solved, 6);
}

TEST_P(HarmonicForms, have_the_norm_of_their_coefficients) {
    for (const auto& [places, mesh] : with_all_stars()) {
        const int n = mesh.dimension();
        for (int degree = 0; degree <= n; ++degree) {
            if (!is_positive(mesh.stars()[n - degree]) ||
                (degree > 0 && degree < n && mesh.stars()[n - degree].is_diagonal()))
                continue; // circumcentric duals have it only as a sum over what is around
            const Constant constant{n, degree, random_vector(coefficients(n, degree), 7)};
            const Cochain u = constant.on(places, Side::dual);
            EXPECT_NEAR(inner_product(mesh, u, u),
                        constant.coefficients.squaredNorm() * mesh.volumes().primal(n).sum(),
                        1e-9 * constant.coefficients.squaredNorm())
                << name(mesh.chosen_stars().kind) << ' ' << degree;
        }
    }
}

TEST_P(HarmonicForms, are_the_flats_of_their_fields) {
    for (const auto& [mesh, same] : with_all_stars()) {
        const int n = mesh.dimension();
        const Vector field = random_vector(n, 3);
        const Constant constant{n, 1, field};
        const Cochain u = constant.on(mesh, Side::dual);
        for (const auto& [kind, rows] : {std::pair{Flat::ppd, mesh.complex().size(0)},
                                         {Flat::pdd, mesh.complex().size(0)},
                                         {Flat::dpd, mesh.complex().size(n)}}) {
            const Cochain a = flat(mesh, kind, DenseMatrix::Ones(rows, 1) * field.transpose());
            EXPECT_LE((a.values - u.values).norm(), 1e-9 * (1 + u.values.norm()))
                << name(mesh.chosen_stars().kind);
        }
    }
}

Shape of_family(const char* name) {
    return {name, [=] { return mesh_named(name); }};
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, HarmonicForms,
    testing::Values(Shape{"interval", [] { return kuhn(1, 5); }}, //
                    Shape{"grid", [] { return grid(4, 3); }},
                    Shape{"hexagons", [] { return hexagons(3); }},
                    Shape{"triangles", [] { return well_centered(4); }},
                    Shape{"shaken", [] { return perturbed(well_centered(4), 0.06, 1); }},
                    Shape{"shaken_grid", [] { return perturbed(grid(4, 4), 0.03, 2); }},
                    Shape{"shaken_simplices",
                          [] { return perturbed(grid(4, 4), 0.03, 2); },
                          {.criterion = MergeCriterion::none}},
                    Shape{"flipped",
                          [] { return perturbed(grid(4, 4), 0.08, 2); },
                          {.delaunay = Delaunay::flips}},
                    Shape{"split_boundary",
                          [] { return perturbed(grid(9, 9), 0.04, 3); },
                          {.delaunay = Delaunay::flips_and_splits}},
                    Shape{"lengths", [] { return perturbed(grid(4, 4), 0.06, 2); }, {}, 0, true},
                    Shape{"lengths_flipped",
                          [] { return perturbed(grid(4, 4), 0.08, 2); },
                          {.delaunay = Delaunay::flips},
                          0,
                          true},
                    Shape{"lengths_of_squares", [] { return grid(4, 3); }, {}, 0, true},
                    Shape{"cubes", [] { return kuhn(3, 2); }}, //
                    Shape{"lengths_of_cubes", [] { return kuhn(3, 2); }, {}, 0, true},
                    Shape{"bcc", [] { return bcc(2); }}, Shape{"fcc", [] { return fcc(2); }},
                    Shape{"shaken_cubes", [] { return perturbed(kuhn(3, 2), 0.03, 3); }},
                    Shape{"obtuse_simplices",
                          [] { return shaken(kuhn(3, 3), 0.08, 3); },
                          {.criterion = MergeCriterion::none}},
                    Shape{"slivers", [] { return delaunay_grid(3, 1e-9); }, {}, 1e-9},
                    Shape{"jittered_slivers", [] { return delaunay_grid(3, 1e-5); }, {}, 1e-5},
                    Shape{"four", [] { return kuhn(4, 1); }}, of_family("hex4"), of_family("ring6"),
                    of_family("split_cubes"), of_family("solid_torus3"), of_family("boxes"),
                    of_family("tesseracts2"), of_family("rectangles"), of_family("fcc1"),
                    of_family("obtuse_planar"), of_family("obtuse_solid")),
    [](const auto& instance) { return std::string(instance.param.name); });

} // namespace polydec::test::in_harmonic_forms
