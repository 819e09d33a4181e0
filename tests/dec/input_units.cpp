// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/dec/products.h"
#include "tests/support/all_sizes.h"

namespace polydec::test::in_input_units {

/// One whose coefficients change over a length.
SmoothForm any_smooth_form(const Discretization& mesh, double size, int k) {
    return [size, count = binomial(mesh.ambient_dimension(), k)](const Vector& point) {
        Vector values(count);
        for (Index i = 0; i < values.size(); ++i)
            values[i] = std::sin(1.0 + static_cast<double>(i) + (point / size).sum());
        return values;
    };
}

Cochain any_form(const Discretization& mesh, Side side, int degree) {
    return random_form(mesh.complex(), side, degree, 5);
}

DenseMatrix any_rows(const Discretization& mesh, int k) {
    return random_matrix(mesh.complex().size(k), mesh.ambient_dimension(), 3);
}

Vector in_one(const DenseMatrix& rows) {
    return rows.reshaped();
}

TEST(InputUnits, are_those_of_integrals_and_of_places_where_forms_are_asked) {
    for (const StarKind kind : {StarKind::circumcentric, StarKind::galerkin})
        expect_no_unit({}, [kind](const Discretization& given, double size, Side side, int k) {
            const auto mesh = given.with_stars(kind);
            const auto form = any_smooth_form(mesh, size, k);
            const Cochain all =
                side == Side::primal ? de_rham(mesh, k, form) : dual_de_rham(mesh, k, form);
            Vector on_boundary;
            if (k < mesh.dimension())
                on_boundary = boundary_de_rham(mesh, k, form);
            return Vector(joined({all.values, on_boundary}) / std::pow(size, k));
        });
}

TEST(InputUnits, are_those_of_places) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side, int k) {
        const Mesh lines = streamlines(mesh, any_rows(mesh, mesh.dimension()),
                                       {.spacing = size / 16, .shortest = 0});
        return Vector(
            joined({in_one(mesh.points()), in_one(mesh.input_points()),
                    in_one(cell_centers(mesh, k)), in_one(cell_centroids(mesh, k)),
                    in_one(dual_sites(mesh)), in_one(facet_sites(mesh)), in_one(lines.points)}) /
            size);
    });
}

TEST(InputUnits, are_those_of_flats) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side, int) {
        std::vector<Vector> forms;
        for (const Flat kind : {Flat::ppp, Flat::pdp, Flat::dpp, Flat::ppd, Flat::pdd, Flat::dpd}) {
            const bool at_cells = kind == Flat::dpp || kind == Flat::dpd;
            forms.push_back(
                flat(mesh, kind, any_rows(mesh, at_cells ? mesh.dimension() : 0)).values);
        }
        return Vector(joined(forms) / size);
    });
}

TEST(InputUnits, are_those_of_vectors_and_coefficients_of_forms) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side, int k) {
        const int n = mesh.dimension();
        const Cochain one = any_form(mesh, Side::primal, 1),
                      flux = any_form(mesh, Side::primal, n - 1),
                      form = any_form(mesh, Side::primal, k);
        const Vector middle = Vector::Constant(n + 1, 1.0 / (n + 1));
        const double power = std::pow(size, k);
        return joined({in_one(size * sharp_pp(mesh, one)), in_one(size * sharp_pd(mesh, one)),
                       in_one(std::pow(size, n - 1) * flux_sharp(mesh, flux)),
                       in_one(power * whitney_at_centroids(mesh, form)),
                       Vector(power * whitney_form(mesh, form, 0, middle))});
    });
}

TEST(InputUnits, are_those_of_vector_fields_that_act_on_forms) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int k) {
        const auto sampling = side == Side::primal ? Sampling::centered : Sampling::upwind;
        const Points X = size * any_rows(mesh, 0);
        const Cochain form = any_form(mesh, Side::primal, k);
        const LieDerivative L(mesh, k, sampling);
        return joined({lie_derivative(mesh, X, k, sampling) * form.values,
                       interior_product(mesh, X, k, sampling) * form.values,
                       inflow(mesh, X, k) * form.values, L(X, form).values,
                       L.interior_product(X, form).values, L.inflow(X, form).values});
    });
}

TEST(InputUnits, are_those_of_the_volumes_of_a_mesh_whatever_its_stars) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int k) {
        const int n = mesh.dimension();
        const Vector weights = Vector::LinSpaced(mesh.complex().size(n), 1, 9);
        const auto other =
            with_material(mesh.with_stars(StarKind::barycentric), k, CellData::on_cells(weights));
        const auto volumes = [&](const Cells& of) -> const Vector& {
            return side == Side::primal ? of.input_volumes(k) : of.input_dual_volumes(n - k);
        };
        EXPECT_EQ(volumes(other), volumes(mesh));
        return k == 0 ? Vector() : Vector(volumes(other) / std::pow(size, k));
    });
}

TEST(InputUnits, are_those_of_stars_and_of_their_inverses) {
    for (const StarKind kind : {StarKind::circumcentric, StarKind::galerkin})
        expect_no_unit({}, [kind](const Discretization& given, double size, Side, int k) {
            const auto mesh = given.with_stars(kind);
            if (mesh.dimension() == 2 * k)
                return Vector(); // stars have no unit
            const double factor = std::pow(size, mesh.dimension() - 2 * k);
            const HodgeStar M = star(mesh, k);
            std::vector<Vector> all{M.matrix() * Vector::Ones(M.size()) / factor,
                                    M * Vector::Ones(M.size()) / factor};
            if (M.zeros().empty())
                all.push_back(factor * M.solve(Vector::Ones(M.size())));
            if (M.is_diagonal() && M.zeros().empty())
                all.push_back(factor * M.inverse());
            return joined(all);
        });
}

TEST(InputUnits, are_those_of_one_degree_wherever_double_precision_holds_it) {
    const Mesh cube = kuhn(3, 1);
    for (const double size : {1e-110, 1e110}) {
        Mesh scaled = cube;
        scaled.points *= size;
        const auto mesh = discretize(scaled), one = discretize(cube);
        for (const int k : {1, 2}) {
            const double factor = std::pow(size, 3 - 2 * k);
            EXPECT_CLOSE(star(mesh, k).diagonal() / factor, star(one, k).diagonal(), 1e-13);
            EXPECT_CLOSE(mesh.input_volumes(k) / std::pow(size, k), one.input_volumes(k), 1e-13);
            EXPECT_CLOSE(mesh.input_dual_volumes(k) / std::pow(size, 3 - k),
                         one.input_dual_volumes(k), 1e-13);
            const Cochain form = any_form(mesh, Side::primal, k);
            EXPECT_CLOSE(star(mesh, star(mesh, form)).values, form.values, 1e-13);
        }
        for (const int k : {0, 3})
            EXPECT_REFUSED(star(mesh, k).diagonal(), "star of degree", "range");
        EXPECT_REFUSED(mesh.input_volumes(3), "volumes of degree 3", "range");
        EXPECT_REFUSED(mesh.input_dual_volumes(0), "dual volumes of degree 0", "range");
    }
}

TEST(InputUnits, are_those_of_operators) {
    expect_no_unit({}, [](const Discretization& mesh, double size, Side side, int k) {
        const int n = mesh.dimension();
        const Cochain form = any_form(mesh, side, k);
        const double power = n - 2 * k; // of both sides
        return joined({star(mesh, form).values / std::pow(size, power),
                       size * size * codifferential(mesh, form).values,
                       size * size * laplacian(mesh, form).values,
                       Vector{{norm(mesh, form) / std::pow(size, power / 2)}}});
    });
}

/// Products of stars leave the range of doubles where their result does not.
TEST(InputUnits, are_those_of_the_stiffness_wherever_double_precision_holds_it) {
    int held = 0, refused = 0;
    for (const std::string& name_of : Asked().names)
        for (const int exponent : {-320, -300, 200, 370}) {
            Mesh mesh = mesh_named(name_of);
            const auto usual = discretize(mesh);
            mesh.points *= std::exp2(exponent);
            const auto scaled = discretize(mesh);
            for (int k = 0; k <= mesh.dimension(); ++k) {
                const int power = exponent * (mesh.dimension() - 2 * k - 2);
                const Operator A = symmetric_laplacian(scaled, k);
                const Vector form = any_form(usual, Side::primal, k).values;
                if (std::abs(power) > 1024) {
                    EXPECT_REFUSED(A.matrix(), "stiffness", "range");
                    EXPECT_REFUSED(A * form, "stiffness", "range");
                    ++refused;
                } else {
                    const SparseMatrix expected = symmetric_laplacian(usual, k);
                    EXPECT_CLOSE(A.matrix() * std::exp2(-power), expected, 1e-8) << name_of << k;
                    EXPECT_CLOSE(A * form * std::exp2(-power), expected * form, 1e-8);
                    ++held;
                }
            }
        }
    EXPECT_GT(held, 20);
    EXPECT_GT(refused, 8);
}

} // namespace polydec::test::in_input_units
