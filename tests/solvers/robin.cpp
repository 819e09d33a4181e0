// SPDX-License-Identifier: MIT
#include "tests/solvers/flow_samples.h"

namespace polydec::test::in_robin {

constexpr StarKind kinds[] = {StarKind::circumcentric, StarKind::galerkin};

/// A coefficient that varies over the unit square: it doubles from left to right.
double varied(double coefficient, const Vector& p) {
    return coefficient * (1 + p[0]);
}

BoundaryConditions varied_robin(const Discretization& mesh, double coefficient) {
    BoundaryConditions conditions{BoundaryCondition::robin};
    const Points facets = cell_centers(mesh, mesh.dimension() - 1);
    for (Index f = 0; f < facets.rows(); ++f)
        conditions.coefficients.push_back(varied(coefficient, facets.row(f)));
    return conditions;
}

double wave(const Vector& p) {
    return std::sin(2 * p[0] + 0.3) * std::cos(p[1]);
}

/// Its outward derivative at the middle of a facet of the unit square.
double slope(const Vector& p) {
    const double x = 2 * std::cos(2 * p[0] + 0.3) * std::cos(p[1]);
    const double y = -std::sin(2 * p[0] + 0.3) * std::sin(p[1]);
    return p[0] < 1e-9 ? -x : p[0] > 1 - 1e-9 ? x : p[1] < 1e-9 ? -y : y;
}

/// L2 error of the wave for the data slope + varied(coefficient) u, solved with another
/// coefficient.
double error(const Discretization& mesh, Side side, double coefficient, double solved_with) {
    const PoissonSolver solver(functions(mesh, side, varied_robin(mesh, solved_with)));
    const Vector exact = at(sites(mesh, side), wave);
    const Vector data = at(facet_sites(mesh), [&](const Vector& p) {
        return slope(p) + varied(coefficient, p) * wave(p);
    });
    return l2_norm(mesh, side, solved(solver, 5 * exact, {}, data).form.values - exact);
}

/// Calls law(case, side) for cells of the plane with diagonal stars and with matrices, both sides.
template <class Law>
void for_both_stars(const std::vector<std::string>& patterns, int cells, Law law) {
    for (const auto& pattern : patterns)
        for (const StarKind kind : kinds)
            for (const Side side : sides) {
                const Case of{pattern, cells, 2 * cells, kind};
                SCOPED_TRACE(testing::Message() << of << name(side));
                law(of, side);
            }
}

/// error(mesh, side, coefficient, the one solved with) has order 2, but not with another one.
template <class Error>
void expect_order_2(const Case& of, Side side, double coefficient, double twin, Error error) {
    const auto order_of = [&](double solved_with) {
        return order(of,
                     [&](const auto& mesh) { return error(mesh, side, coefficient, solved_with); });
    };
    EXPECT_GE(order_of(coefficient), 1.8) << coefficient;
    EXPECT_LT(order_of(twin), 1.0) << coefficient;
}

TEST(Robin, converges_with_order_2_on_both_sides) {
    for_both_stars({"squares", "hexagons", "triangles"}, 8, [](const Case& of, Side side) {
        for (const double coefficient : {0.1, 1.0, 50.0})
            expect_order_2(of, side, coefficient, 2 * coefficient, error);
    });
}

/// -u'' = 1 on [0, 1] with u' = alpha u at the left and -u' = beta u at the right end, so u =
/// c + alpha c x - x^2 / 2, which is the value at vertices exactly; in every dimension with no flow
/// through the sides, where coefficients do not matter.
TEST(Robin, of_a_slab_is_exact) {
    constexpr double alpha = 3, beta = 5;
    constexpr double c = (1 + beta / 2) / (alpha * (1 + beta) + beta);
    for (const Mesh& input : {kuhn(1, 7), grid(5, 5), kuhn(3, 3)}) {
        const auto mesh = circumcentric(input);
        const int n = mesh.dimension();
        BoundaryConditions ends{BoundaryCondition::natural};
        const Points facets = cell_centers(mesh, n - 1);
        for (Index f = 0; f < facets.rows(); ++f) {
            const double x = facets(f, 0);
            const bool is_end = std::abs(x - 0.5) > 0.5 - 1e-9;
            ends.facets.push_back(is_end ? BoundaryCondition::robin : BoundaryCondition::natural);
            ends.coefficients.push_back(!is_end ? 0 : x < 0.5 ? alpha : beta);
        }
        for (const Side side : sides) {
            const Points places = sites(mesh, side);
            const auto solution =
                solved(PoissonSolver(functions(mesh, side, ends)), Vector::Ones(places.rows()));
            const auto x = places.col(0).array();
            // a cell's balance lets dual values be off by an eighth of the square of its length
            const double h = 1 / std::round(std::pow(mesh.complex().size(n), 1.0 / n));
            const double offset = side == Side::primal ? 0 : h * h / 8;
            const Vector exact = c + alpha * c * x - x * x / 2 + offset;
            EXPECT_CLOSE(solution.form.values, exact, 1e-11) << n << name(side);
            EXPECT_EQ(solution.compatibility.free_components, 0);
            if (side == Side::dual) {
                const Vector made = d(mesh.complex(), solution.flux).values;
                EXPECT_CLOSE(made, mesh.volumes().primal(n), 1e-11) << n;
            }
        }
    }
}

/// -Delta u = 1 between the radii 1 and 2, where the outward derivative is -alpha u, has the
/// solution u = a + b log r - r^2 / 4.
TEST(Robin, of_a_ring_converges_to_the_closed_form) {
    constexpr double alpha = 2;
    // at 1: 1/2 - b + alpha (a - 1/4) = 0; at 2: b/2 - 1 + alpha (a + b log 2 - 1) = 0
    Eigen::Matrix2d A;
    A << alpha, -1, alpha, alpha * std::log(2) + 0.5;
    const Eigen::Vector2d c = A.inverse() * Eigen::Vector2d(alpha / 4 - 0.5, alpha + 1);
    const auto exact = [&](double r) { return c[0] + c[1] * std::log(r) - r * r / 4; };
    for (const Side side : sides) {
        std::vector<double> errors;
        for (const int m : {12, 24, 48}) {
            const auto mesh = circumcentric(annulus(6 * m, m));
            const Vector wanted =
                at(sites(mesh, side), [&](const Vector& x) { return exact(x.norm()); });
            const auto found = solved(PoissonSolver(functions(mesh, side, robin(alpha))),
                                      Vector::Ones(wanted.size()));
            errors.push_back((found.form.values - wanted).cwiseAbs().maxCoeff());
        }
        EXPECT_LE(errors[2], 2e-3) << name(side);
        EXPECT_GE(std::log2(errors[0] / errors[1]), 1.8) << name(side);
        EXPECT_GE(std::log2(errors[1] / errors[2]), 1.8) << name(side);
    }
}

/// w tan(w / 2) = alpha, 0 < w < pi, by bisection.
double frequency(double alpha) {
    double w = 0, above = std::numbers::pi;
    for (int i = 0; i < 60; ++i) {
        const double middle = (w + above) / 2;
        (middle * std::tan(middle / 2) < alpha ? w : above) = middle;
    }
    return w;
}

/// The lowest wave of the square under Robin's condition, cos(w (x - 1/2)) cos(w (y - 1/2)) with
/// w tan(w / 2) = alpha, fades as exp(-2 w^2 t).
double fading_error(const Discretization& mesh, Side side, double alpha, double solved_with) {
    const double w = frequency(alpha);
    const bool diagonal = mesh.chosen_stars().kind == StarKind::circumcentric;
    const Points sites = side == Side::primal ? mesh.points()
                         : diagonal           ? cell_centers(mesh, 2)
                                              : cell_centroids(mesh, 2);
    const Vector start = (w * (sites.array() - 0.5)).cos().rowwise().prod();
    constexpr int steps = 80;
    constexpr double time = 0.2;
    const Cochain u = heated({mesh, side, 0, robin(solved_with)}, {side, 0, start}, time / steps,
                             steps, "implicit-midpoint");
    return l2_norm(mesh, side, u.values - std::exp(-2 * w * w * time) * start);
}

TEST(Robin, lets_heat_fade_as_its_closed_form) {
    for_both_stars({"squares", "triangles"}, 12, [](const Case& of, Side side) {
        for (const double alpha : {0.5, 4.0})
            expect_order_2(of, side, alpha, 1.5 * alpha, fading_error);
    });
}

/// w of the lowest wave above: w tan(w / 2) = alpha.
TEST(Robin, has_the_spectrum_of_the_square) {
    for_both_stars({"squares", "triangles"}, 12, [](const Case& of, Side side) {
        for (const double alpha : {0.5, 4.0}) {
            const double exact = 2 * std::pow(frequency(alpha), 2);
            const auto error_of = [&](const Discretization& mesh, double solved_with) {
                const auto found = spectrum({mesh, side, 0, robin(solved_with)}, {.count = 3});
                EXPECT_TRUE(found.certificate.complete);
                return std::abs(found.eigenvalues[0] - exact);
            };
            EXPECT_LE(error_of(of.mesh(of.fine), alpha), 0.01 * exact) << alpha;
            EXPECT_GE(order(of, [&](const auto& mesh) { return error_of(mesh, alpha); }), 1.8)
                << alpha;
            EXPECT_GT(error_of(of.mesh(of.fine), 1.5 * alpha), 0.1 * exact);
        }
    });
}

/// Calls law(mesh, side, degree) for forms that have a trace, on a few meshes.
template <class Law>
void for_traces(Law law) {
    for (const char* name_of : {"grid4", "kuhn3", "wellcentred4"}) {
        SCOPED_TRACE(name_of);
        const auto mesh = circumcentric(mesh_named(name_of));
        for_all_forms(mesh.dimension() - 1, [&](Side side, int k) { law(mesh, side, k); });
    }
}

/// Of forms of every degree: heat under the same condition fades at the rates of the spectrum.
TEST(Robin, has_spectra_by_which_heat_fades) {
    for_traces([](const Discretization& mesh, Side side, int k) {
        const auto found = spectrum({mesh, side, k, robin(1.5)}, {.count = 4});
        const Diffusion diffusion({mesh, side, k, robin(1.5)});
        const Diffusion twin({mesh, side, k, robin(3)});
        double off = 0;
        for (Index i = 0; i < 4; ++i) {
            const Vector mode = found.modes.col(i)(diffusion.kept());
            const Vector expected = -found.eigenvalues[i] * mode;
            const double size = mode.norm() * (1 + found.eigenvalues[3]);
            EXPECT_LE((diffusion.rate(mode) - expected).norm(), 1e-7 * size);
            off = std::max(off, (twin.rate(mode) - expected).norm() / size);
        }
        EXPECT_GT(off, 1e-3);
    });
}

/// It takes more than no flow does from primal forms, and less than held values from dual ones.
TEST(Robin, takes_energy_from_heat_of_every_degree) {
    for_traces([](const Discretization& mesh, Side side, int k) {
        const int cells = cell_degree(mesh.complex(), side, k);
        const Vector star = mesh.stars()[cells].diagonal();
        const Vector weights = side == Side::primal ? star : star.cwiseInverse();
        const Cochain u{side, k, random_vector(mesh.complex().size(cells), 5)};
        const auto energy_after = [&](const BoundaryConditions& conditions) {
            const Cochain next = heated({mesh, side, k, conditions}, u, 0.1);
            return weights.dot(next.values.cwiseAbs2());
        };
        const double left = energy_after(robin(1));
        EXPECT_LT(left, weights.dot(u.values.cwiseAbs2()));
        const double without = energy_after(built_in_conditions(side));
        const double more = side == Side::primal ? without - left : left - without;
        EXPECT_GT(more, 1e-6 * without);
    });
}

TEST(Robin, of_an_infinite_coefficient_is_Dirichlets_and_of_none_Neumanns) {
    for (const char* name_of : {"grid4", "wellcentred4", "kuhn3", "ring6", "hexagons5"})
        for (const Side side : sides)
            for (const StarKind kind : kinds) {
                const auto mesh = with_stars(mesh_named(name_of), kind);
                const auto solution = [&](const BoundaryConditions& conditions, double data) {
                    return solved(PoissonSolver(functions(mesh, side, conditions)),
                                  random_vector(sites(mesh, side).rows(), 1),
                                  Vector::Constant(boundary_sites(mesh, side).rows(), 0.7),
                                  Vector::Constant(facet_sites(mesh).rows(), data))
                        .form.values;
                };
                const Vector dirichlet = solution({BoundaryCondition::essential}, 0);
                EXPECT_CLOSE(solution(robin(1e9), 0.7e9), dirichlet, 1e-6) << name_of << name(side);
                EXPECT_GT(relative_difference(solution(robin(1), 0.7), dirichlet), 1e-3);
            }
}

TEST(Robin, is_refused_where_it_and_a_negative_half_dual_leave_no_resistance) {
    const auto mesh = circumcentric(mesh_named("bcc2"));
    EXPECT_REFUSED(PoissonSolver(functions(mesh, Side::dual, robin(16))), "facet 0",
                   "vertices 0, 1, 3, 4", "-0.125", "1", "Robin", "-0.0625");
    EXPECT_NO_THROW(PoissonSolver(functions(mesh, Side::dual, robin(4))));
}

TEST(Robin, is_refused_by_name_where_it_is_not_known) {
    const auto mesh = circumcentric(grid(2, 2));
    EXPECT_REFUSED(HodgeSolver({mesh, Side::primal, 0, robin(1)}), "facet 0", "Robin",
                   "PoissonSolver");
    for (const Side side : {Side::primal, Side::dual})
        EXPECT_REFUSED(FormSpace(mesh, side, 2, robin(1)), "facet 0", "Robin", "n-forms");
    EXPECT_REFUSED(functions(mesh, Side::primal, robin(-1)), "Robin", "1-cell 0", "-1");
    EXPECT_REFUSED(functions(mesh, Side::primal, {BoundaryCondition::robin}),
                   "0 Robin coefficients", "12 1-cells");
}

} // namespace polydec::test::in_robin
