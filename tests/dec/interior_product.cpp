// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/dec/products.h"

namespace polydec::test::in_interior_product {

constexpr double rounding = 1e-11;

/// i_X and L_X on a mesh with one sampling, by degree. The field must outlive it.
struct Transport {
    std::string name;
    const Discretization& mesh;
    const Points& field;
    Sampling sampling;
    const CellComplex& complex = mesh.complex();

    SparseMatrix interior(int k) const { return interior_product(mesh, field, k, sampling); }
    SparseMatrix lie(int k) const { return lie_derivative(mesh, field, k, sampling); }
    /// An empty matrix for centered sampling.
    SparseMatrix inflow(int k) const {
        return sampling == Sampling::upwind ? polydec::inflow(mesh, field, k)
                                            : SparseMatrix(complex.size(k), complex.size(k));
    }

    /// 1 for each k-cell with inflow or a face with it, 0 elsewhere.
    Vector inflow_marks(int k) const {
        Vector marks = inflow(k) * Vector::Ones(complex.size(k));
        if (k > 0) {
            const SparseMatrix faces = derivative(complex, k - 1).cwiseAbs();
            const Vector below = inflow(k - 1).cwiseAbs() * Vector::Ones(complex.size(k - 1));
            marks = marks.cwiseAbs() + faces * below;
        }
        return (marks.array() != 0).cast<double>();
    }

    /// Without the values on cells of which inflow_marks tells.
    Vector inside(int k, const Vector& values) const {
        return values.cwiseProduct((1 - inflow_marks(k).array()).matrix());
    }
};

const Discretization& simplices(const std::string& mesh_name) {
    return discretized(mesh_name, MergeCriterion::none);
}

/// On simplices and on merged cells, centered and upwind. field must outlive the result.
std::vector<Transport> transports(const std::string& mesh_name, const Points& field) {
    const auto &fine = simplices(mesh_name), &merged = discretized(mesh_name);
    return {{"simplices, centered", fine, field, Sampling::centered},
            {"merged, centered", merged, field, Sampling::centered},
            {"simplices, upwind", fine, field, Sampling::upwind},
            {"merged, upwind", merged, field, Sampling::upwind}};
}

class InteriorProducts : public OverMeshes {
protected:
    Index N() const { return static_cast<Index>(mesh().points.cols()); }
    bool flat() const { return is_flat(mesh_named(GetParam())); }

    Points any_field() const { return random_matrix(mesh().points.rows(), N(), 7); }

    /// x -> A x + b at the points.
    Points linear_field(const DenseMatrix& A, const Vector& b) const {
        Points field = mesh().points * A.transpose();
        field.rowwise() += b.transpose();
        return field;
    }

    static Vector on_cells_of(const Transport& transport, int k, const Vector& values) {
        return to_merged(transport.mesh, {Side::primal, k, values}).values;
    }

    Vector integrals(const Transport& transport, int k, const Form& form) const {
        return on_cells_of(transport, k, integrate(mesh().K(), mesh().points, k, form));
    }
};

TEST_P(InteriorProducts, of_constant_forms_with_linear_fields_are_exact_on_flat_meshes) {
    const DenseMatrix A = random_matrix(N(), N(), 1);
    const Vector b = random_vector(N(), 2);
    const Points field = linear_field(A, b);
    for (const auto& transport : transports(GetParam(), field))
        for (int k = 1; flat() && k <= mesh().n(); ++k) {
            const Vector a = random_vector(coefficients(N(), k), 3);
            const Vector values = integrals(transport, k, constant_form(a));
            const Vector exact = integrals(
                transport, k - 1, [&](const Vector& x) { return contraction(A * x + b, k, a); });
            const Vector found = transport.interior(k) * values;
            EXPECT_CLOSE(found, exact, rounding) << transport.name << ", k = " << k;
            EXPECT_GT(relative_difference(Vector(-found), exact), 1)
                << transport.name << ", k = " << k << ", with the sign flipped";
        }
}

TEST_P(InteriorProducts, of_the_volume_form_are_the_flux_of_the_field) {
    const int n = mesh().n();
    const Points field = any_field();
    const Vector one = Vector::Ones(1);
    const DenseMatrix facets = multivectors(mesh().K(), mesh().points, n - 1);
    Vector flux(mesh().K().size(n - 1));
    for (Index s = 0; flat() && s < flux.size(); ++s) {
        Vector mean = Vector::Zero(N());
        for (const Index v : mesh().K().simplices(n - 1).row(s))
            mean += field.row(v) / n;
        flux[s] = facets.row(s).dot(contraction(mean, n, one));
    }
    for (const auto& transport : transports(GetParam(), field)) {
        if (!flat())
            return;
        const Vector found = transport.interior(n) * integrals(transport, n, constant_form(one));
        EXPECT_CLOSE(found, on_cells_of(transport, n - 1, flux), rounding) << transport.name;
    }
}

TEST_P(InteriorProducts, with_the_derivative_make_lie_derivatives_that_commute_with_it) {
    const Points field = any_field();
    for (const auto& transport : transports(GetParam(), field))
        for (int k = 0; k < mesh().n(); ++k) {
            const SparseMatrix d = derivative(transport.complex, k);
            if (largest(d) == 0)
                continue;
            const SparseMatrix lower = d * (transport.lie(k) - transport.inflow(k));
            const SparseMatrix upper = (transport.lie(k + 1) - transport.inflow(k + 1)) * d;
            const double size = std::max(largest(lower), largest(transport.lie(k + 1)));
            EXPECT_LE(largest(lower - upper), rounding * size) << transport.name << ", k = " << k;
        }
}

TEST_P(InteriorProducts, differentiate_linear_functions_along_the_field) {
    const Points field = any_field();
    const Vector slope = random_vector(N(), 4);
    for (const auto& transport : transports(GetParam(), field)) {
        if (!flat())
            return;
        const Vector f = integrals(
            transport, 0, [&](const Vector& x) { return Vector::Constant(1, slope.dot(x) + 1); });
        Vector exact(f.size());
        for (Index v = 0; v < f.size(); ++v)
            exact[v] = field.row(v) * slope;
        EXPECT_CLOSE(transport.inside(0, transport.lie(0) * f), transport.inside(0, exact),
                     rounding)
            << transport.name;
    }
}

/// Coefficients of the Lie derivative of a constant k-form a along x -> A x + b: the sum over axes
/// i of dx_i ^ i_(A e_i) a, which is the derivative of the linear form i_(A x) a.
Vector lie_coefficients(const DenseMatrix& A, int k, const Vector& a) {
    const auto N = static_cast<Index>(A.cols());
    Vector result = Vector::Zero(a.size());
    for (Index i = 0; i < N; ++i)
        result += exterior_product(N, 1, Vector::Unit(N, i), k - 1, contraction(A.col(i), k, a));
    return result;
}

TEST_P(InteriorProducts, make_exact_lie_derivatives_of_constant_forms_along_linear_fields) {
    const DenseMatrix A = random_matrix(N(), N(), 1);
    const Points field = linear_field(A, random_vector(N(), 2));
    for (const auto& transport : transports(GetParam(), field))
        for (int k = 1; flat() && k <= mesh().n(); ++k) {
            const Vector a = random_vector(coefficients(N(), k), 3);
            const Vector values = integrals(transport, k, constant_form(a));
            const Vector exact = integrals(transport, k, constant_form(lie_coefficients(A, k, a)));
            EXPECT_CLOSE(transport.inside(k, transport.lie(k) * values), transport.inside(k, exact),
                         rounding)
                << transport.name << ", k = " << k;
        }
}

/// Upwind transport lets nothing in but what inflow tells, and has another formula.
TEST_P(InteriorProducts, make_the_centered_lie_derivative_by_cartans_formula) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const Points field = random_field(mesh, 7);
        const auto interior = [&](int k) {
            return interior_product(mesh, field, k, Sampling::centered);
        };
        for (int k = 0; k <= mesh.dimension(); ++k) {
            const SparseMatrix upper = interior(k + 1) * derivative(mesh.complex(), k);
            const SparseMatrix lower = derivative(mesh.complex(), k - 1) * interior(k);
            const SparseMatrix found = lie_derivative(mesh, field, k, Sampling::centered);
            EXPECT_LE(largest(found - upper - lower), rounding * (1 + largest(found)))
                << "k = " << k;
            if (k > 0) {
                const SparseMatrix wrong = upper - lower;
                EXPECT_TRUE(largest(found - wrong) > rounding || largest(lower) <= rounding)
                    << "with the wrong sign";
            }
        }
    });
}

TEST_P(InteriorProducts, have_the_ends_of_the_tower_in_their_shapes) {
    const Points field = any_field();
    const int n = mesh().n();
    for (const auto& transport : transports(GetParam(), field)) {
        EXPECT_EQ(transport.interior(0).rows(), 0);
        EXPECT_EQ(transport.interior(0).cols(), transport.complex.size(0));
        EXPECT_EQ(transport.interior(n + 1).rows(), transport.complex.size(n));
        EXPECT_EQ(transport.interior(n + 1).cols(), 0);
        for (int k = 0; k <= n; ++k)
            EXPECT_EQ(transport.lie(k).cols(), transport.complex.size(k));
    }
}

/// Largest entry off the diagonal of L_X of functions, over its largest diagonal entry: if none is
/// positive, a short step of f - time L_X f is a mean of values of f at every vertex.
double worst_weight(const SparseMatrix& L) {
    double worst = -INFINITY;
    for (Index v = 0; v < L.rows(); ++v)
        for (SparseMatrix::InnerIterator entry(L, v); entry; ++entry)
            if (entry.col() != v)
                worst = std::max(worst, entry.value());
    return worst / largest(L);
}

/// How far one step from values between 0 and 1 leaves this range, at half of the CFL limit.
double overshoot(const SparseMatrix& L) {
    const double time = 0.5 / Vector(L.diagonal()).cwiseAbs().maxCoeff();
    double worst = 0;
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Vector f = (random_vector(L.rows(), seed).array() > 0).cast<double>();
        const Vector next = f - time * (L * f);
        worst = std::max({worst, next.maxCoeff() - 1, -next.minCoeff()});
    }
    return worst;
}

/// A random field that vanishes on the boundary, so that nothing flows in.
Points enclosed_field(const Merged& mesh) {
    const Points random = random_matrix(mesh.points.rows(), mesh.points.cols(), 11);
    Points field = Points::Zero(mesh.points.rows(), mesh.points.cols());
    const auto boundary = boundary_cells(mesh.K());
    for (Index s = 0; s < mesh.K().size(0); ++s)
        if (!boundary[0][s])
            field.row(s) = random.row(s);
    return field;
}

TEST_P(InteriorProducts, upwind_transport_functions_within_their_range) {
    const Points field = enclosed_field(mesh());
    if (!flat() || field.isZero())
        return;
    for (const auto& transport : transports(GetParam(), field)) {
        const SparseMatrix L = transport.lie(0);
        if (transport.sampling == Sampling::upwind) {
            EXPECT_LE(worst_weight(L), rounding) << transport.name;
            EXPECT_LE(overshoot(L), rounding) << transport.name;
        } else {
            EXPECT_GT(worst_weight(L), 0.1) << transport.name;
        }
    }
}

POLYDEC_OVER_MESHES(InteriorProducts);

TEST(InteriorProductsBroken, centered_transport_overshoots) {
    for (const char* name : {"segments4", "grid4", "wellcentred4", "bcc2"}) {
        const Points field = enclosed_field(merged(name));
        const SparseMatrix L = lie_derivative(simplices(name), field, 0, Sampling::centered);
        // the diagonal almost vanishes, so no step is short enough for it
        const double time = 0.5 / largest(L);
        const Vector f = (random_vector(L.rows(), 1).array() > 0).cast<double>();
        const Vector next = f - time * (L * f);
        EXPECT_GT(std::max(next.maxCoeff() - 1, -next.minCoeff()), 0.01) << name;
    }
}

TEST(InteriorProductsBroken, half_of_cartans_formula_does_not_commute_with_the_derivative) {
    for (const char* name : {"grid4", "kuhn3", "goldberg2"}) {
        const auto& mesh = merged(name);
        const Points field = random_matrix(mesh.points.rows(), mesh.points.cols(), 7);
        for (const auto& transport : transports(name, field)) {
            const SparseMatrix d = derivative(transport.complex, 0);
            const SparseMatrix half = d * transport.lie(0);
            const SparseMatrix other = transport.interior(2) * derivative(transport.complex, 1) * d;
            EXPECT_GT(relative_difference(other, half), 0.1) << name << ", " << transport.name;
        }
    }
}

/// How far i_X(a ^ b) is from i_X a ^ b - a ^ i_X b for 1-forms on simplices, relative.
double product_rule_defect(const SimplicialComplex& K, const Transport& transport, const Cochain& a,
                           const Cochain& b) {
    const auto contracted = [&](const Cochain& form) -> Cochain {
        return {Side::primal, form.degree - 1, transport.interior(form.degree) * form.values};
    };
    const auto first = wedge(K, contracted(a), b), second = wedge(K, a, contracted(b));
    return relative_difference(contracted(wedge(K, a, b)).values, (first - second).values);
}

TEST(InteriorProductsBroken, obey_the_product_rule_and_vanish_twice_for_constants_alone) {
    for (const char* name : {"wellcentred4", "obtuse_solid", "obtuse4"}) {
        const auto& mesh = merged(name);
        const auto N = static_cast<Index>(mesh.points.cols());
        const Points field = Points::Constant(mesh.points.rows(), N, 0.7);
        const auto constant = [&](unsigned seed) -> Cochain {
            const auto form = constant_form(random_vector(N, seed));
            return {Side::primal, 1, integrate(mesh.K(), mesh.points, 1, form)};
        };
        const auto all = transports(name, field);
        for (const auto& transport : {all[0], all[2]}) {
            EXPECT_LE(product_rule_defect(mesh.K(), transport, constant(1), constant(2)), rounding)
                << name << ", " << transport.name;
            const auto a = random_form(mesh.K(), Side::primal, 1, 1);
            const auto b = random_form(mesh.K(), Side::primal, 1, 2);
            EXPECT_GT(product_rule_defect(mesh.K(), transport, a, b), 0.1)
                << name << ", " << transport.name;
        }
        const Points other = random_matrix(mesh.points.rows(), N, 7);
        for (const auto& transport : transports(name, other)) {
            const SparseMatrix first = transport.interior(2), second = transport.interior(1);
            EXPECT_GT(largest(second * first), 1e-2 * largest(second) * largest(first))
                << name << ", " << transport.name;
        }
    }
}

TEST(InteriorProductErrors, name_the_shape_the_vertex_and_the_degree) {
    const auto& mesh = merged("grid4");
    Points field = Points::Ones(mesh.points.rows(), 2);
    const auto call = [&](int k) {
        return refusal([&] { interior_product(simplices("grid4"), field, k, Sampling::upwind); });
    };
    EXPECT_SAYS(call(-1), "vector field", "-1-forms", "0", "3");
    EXPECT_SAYS(call(4), "vector field", "4-forms", "0", "3");
    EXPECT_REFUSED(lie_derivative(simplices("grid4"), field, 3, Sampling::centered), "vector field",
                   "3-forms", "0", "2");
    field(3, 1) = NAN;
    EXPECT_SAYS(call(1), "vector field", "vertex 3", "finite");
    field = Points::Ones(7, 2);
    EXPECT_SAYS(call(1), "vector field", "7 x 2", "25 x 2", "point");
}

} // namespace polydec::test::in_interior_product
