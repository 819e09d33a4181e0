// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/dec/products.h"

namespace polydec::test::in_de_rham {

/// A random k-form on R^N whose coefficients are c + b.x + (l.x)^2 + (m.x)^3, and its derivative.
class CubicForm {
public:
    CubicForm(Index N, int k, unsigned seed)
        : N_(N), k_(k), random_(coefficients(N, k), 3 * N + 1) {
        random_.reshaped() = random_vector(static_cast<Index>(random_.size()), seed);
    }

    Vector value(const Vector& x) const {
        return random_.col(0).array() + (linear(0) * x).array() + (linear(1) * x).array().square() +
               (linear(2) * x).array().cube();
    }

    SmoothForm form() const {
        return [*this](const Vector& x) { return value(x); };
    }

    /// The sum over the axes of dx_axis ^ the derivative along it.
    SmoothForm d() const {
        std::vector<DenseMatrix> products; // with dx_axis, of forms with one coefficient
        for (Index axis = 0; axis < N_; ++axis) {
            auto& product = products.emplace_back(coefficients(N_, k_ + 1), random_.rows());
            for (Index I = 0; I < random_.rows(); ++I)
                product.col(I) = exterior_product(N_, 1, Vector::Unit(N_, axis), k_,
                                                  Vector::Unit(random_.rows(), I));
        }
        return [*this, products](const Vector& x) {
            const Vector a = 2 * linear(1) * x, b = 3 * (linear(2) * x).array().square();
            Vector result = Vector::Zero(products.front().rows());
            for (Index axis = 0; axis < N_; ++axis)
                result +=
                    products[axis] * (linear(0).col(axis) + a.cwiseProduct(linear(1).col(axis)) +
                                      b.cwiseProduct(linear(2).col(axis)));
            return result;
        };
    }

private:
    Eigen::Block<const DenseMatrix> linear(Index which) const {
        return random_.block(0, 1 + which * N_, random_.rows(), N_);
    }

    Index N_;
    int k_;
    DenseMatrix random_;
};

class DeRham : public OverMeshes {};

TEST_P(DeRham, satisfies_stokes_theorem) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        for (int k = 0; k < mesh.dimension(); ++k) {
            const CubicForm w(space(mesh), k, 7 + k);
            const Cochain left = d(mesh.complex(), de_rham(mesh, k, w.form(), 3));
            EXPECT_CLOSE(left.values, de_rham(mesh, k + 1, w.d(), 3).values, allowed_rounding(mesh))
                << "k = " << k;
        }
    });
}

TEST_P(DeRham, gives_the_exact_integrals_of_quadratic_forms) {
    const auto& mesh = discretized(GetParam());
    for (int k = 0; k <= mesh.dimension(); ++k) {
        const Vector coefficient = random_vector(coefficients(space(mesh), k), 3);
        const SmoothForm form = [&](const Vector& x) {
            return Vector((1 + x.squaredNorm() - x[0]) * coefficient);
        };
        EXPECT_CLOSE(de_rham(mesh.input(), mesh.points(), k, form),
                     integrate(mesh.input(), mesh.points(), k, form), 1e-12)
            << "k = " << k;
    }
}

/// Pieces, by degree, that no facet with other than two cofaces has as a face.
std::vector<std::vector<bool>> interior(const Pieces& K) {
    const int n = K.dimension();
    std::vector<std::vector<bool>> inside;
    for (int k = 0; k <= n; ++k)
        inside.emplace_back(K.size(k), true);
    for (Index f = 0; f < K.size(n - 1); ++f)
        inside[n - 1][f] = K.coface_counts(n - 1)[f] == 2;
    for (int k = n - 1; k > 0; --k)
        for (Index s = 0; s < K.size(k); ++s)
            for (int omitted = 0; omitted <= k && !inside[k][s]; ++omitted)
                inside[k - 1][K.face(k, s, omitted)] = false;
    return inside;
}

/// How far d R(w), times a sign, is from R(dw) on dual (j+1)-cells off the boundary.
double dual_stokes_defect(const Discretization& mesh, int j, double sign) {
    const int k = mesh.dimension() - j - 1;
    const CubicForm w(space(mesh), j, 11 + j);
    Vector left = sign * d(mesh.complex(), dual_de_rham(mesh, j, w.form(), 3)).values;
    Vector right = dual_de_rham(mesh, j + 1, w.d(), 3).values;
    // where everything inside is degenerate, the cells at the boundary tell what size there is
    const double scale = right.cwiseAbs().maxCoeff();
    const auto inside = interior(mesh.pieces());
    const auto& carriers = mesh.merging().carriers(k);
    for (Index s = 0; s < mesh.pieces().size(k); ++s)
        if (!inside[k][s] && carriers[s].dimension == k)
            left[carriers[s].cell] = right[carriers[s].cell] = 0;
    return (left - right).cwiseAbs().maxCoeff() / scale;
}

TEST_P(DeRham, on_duals_satisfies_stokes_theorem_off_the_boundary) {
    for_flipped_and_not(GetParam(), [&](const Discretization& mesh) {
        // a bent cell has several duals, and their means are no boundary of anything
        const bool bent =
            mesh.passage().is_identity() && !is_flat(mesh_named(GetParam())) &&
            mesh.complex().size(mesh.dimension()) < mesh.input().size(mesh.dimension());
        if (bent || !mesh.input().orientable())
            return;
        // a 5-simplex has 720 flags a degree; the first and the last degree are enough there
        const int step = mesh.dimension() < 5 ? 1 : mesh.dimension() - 1;
        for (int j = 0; j < mesh.dimension(); j += step)
            EXPECT_LE(dual_stokes_defect(mesh, j, 1), allowed_rounding(mesh)) << "j = " << j;
    });
}

/// The Hodge star of a constant k-form on R^n: its coefficient at dx_J is what the product with
/// dx_J has at dx_1 ^ .. ^ dx_n.
Vector smooth_star(int n, int k, const Vector& coefficient) {
    Vector result(coefficient.size());
    for (Index J = 0; J < result.size(); ++J)
        result[J] = exterior_product(n, k, coefficient, n - k, Vector::Unit(result.size(), J))[0];
    return result;
}

/// For each k-cell the orientation in space of the n-cells around it.
Vector orientations_around(const Discretization& mesh, int k) {
    const int n = mesh.dimension();
    Vector signs = orientations_in_space(mesh);
    for (int i = n; i > k; --i) {
        Vector lower(mesh.input().size(i - 1));
        for (Index s = 0; s < mesh.input().size(i); ++s)
            for (int omitted = 0; omitted <= i; ++omitted)
                lower[mesh.input().face(i, s, omitted)] = signs[s];
        signs = lower;
    }
    Vector merged(mesh.complex().size(k));
    const auto& carriers = mesh.merging().carriers(k);
    for (Index s = 0; s < mesh.input().size(k); ++s)
        if (carriers[s].dimension == k)
            merged[carriers[s].cell] = signs[s];
    return merged;
}

TEST_P(DeRham, takes_the_star_of_constant_forms_to_their_hodge_star) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        const int n = mesh.dimension();
        for (int k = 0; k <= n; ++k) {
            const Vector w = random_vector(coefficients(n, k), 5 + k);
            const Cochain left =
                star({mesh.complex(), mesh.volumes()}, de_rham(mesh, k, constant_form(w), 1));
            const Vector right =
                dual_de_rham(mesh, n - k, constant_form(smooth_star(n, k, w)), 1).values;
            EXPECT_CLOSE(left.values, right.cwiseProduct(orientations_around(mesh, k)), 1e-12)
                << "k = " << k;
        }
    });
}

TEST_P(DeRham, of_a_flux_form_counts_what_flows_out) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        const int n = mesh.dimension();
        if (orientations_in_space(mesh).minCoeff() < 0)
            return;
        const auto position = [](const Vector& x) { return x; };
        const Cochain flux = de_rham(mesh, n - 1, flux_form(position));
        const double volume = mesh.volumes().primal(n).sum();
        const Vector boundary =
            derivative(mesh.complex(), n - 1).transpose() * Vector::Ones(mesh.complex().size(n));
        EXPECT_NEAR(flux.values.dot(boundary), n * volume, 1e-12 * n * volume);
        const auto divergence = [&](const Vector&) { return double(n); };
        EXPECT_CLOSE(d(mesh.complex(), flux).values,
                     de_rham(mesh, n, function_form(divergence)).values, 1e-12);
    });
}

TEST_P(DeRham, of_functions_is_their_values) {
    const auto& mesh = discretized(GetParam());
    const auto f = [](const Vector& x) { return std::sin(x.sum()) + 2; };
    const Cochain values = de_rham(mesh, 0, function_form(f));
    const Cochain at_centers = dual_de_rham(mesh, 0, function_form(f));
    for (Index v = 0; v < values.values.size(); ++v)
        EXPECT_NEAR(values.values[v], f(mesh.points().row(v)), 1e-14);
    EXPECT_EQ(at_centers.side, Side::dual);
    EXPECT_EQ(at_centers.values.size(), mesh.complex().size(mesh.dimension()));
}

/// The values of the function 1 as a dual 0-form, where star_n is a matrix.
Vector ones_by_a_matrix(const Discretization& mesh) {
    const int n = mesh.dimension();
    const auto by_matrix = mesh.with_stars(mesh.stars().with(n, mesh.stars()[n].matrix()));
    EXPECT_FALSE(by_matrix.stars()[n].is_diagonal());
    return dual_de_rham(by_matrix, 0, constant_form(Vector::Ones(1))).values;
}

TEST_P(DeRham, of_a_constant_is_the_constant_on_duals_if_the_star_of_n_cells_is_a_matrix) {
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        if (!mesh.stars()[mesh.dimension()].zeros().empty())
            return;
        const Vector values = ones_by_a_matrix(mesh);
        EXPECT_CLOSE(values, Vector::Ones(values.size()), 1e-12);
    });
}

POLYDEC_OVER_MESHES(DeRham);

const std::vector<std::string> some_meshes = {"hex4", "uv8", "kuhn3", "split_cubes", "kuhn4"};

TEST(DeRhamBroken, without_the_orientation_of_n_cells_stokes_theorem_fails) {
    for (const auto& name : some_meshes) {
        const auto& mesh = discretized(name, MergeCriterion::none);
        const int n = mesh.dimension();
        const CubicForm w(space(mesh), n - 1, 3);
        Vector top = de_rham(mesh, n, w.d(), 3).values;
        for (Index t = 0; t < top.size(); ++t)
            top[t] *= mesh.input().orientation(t);
        EXPECT_GT(
            relative_difference(d(mesh.complex(), de_rham(mesh, n - 1, w.form(), 3)).values, top),
            0.1)
            << name;
    }
}

TEST(DeRhamBroken, with_too_few_quadrature_points_stokes_theorem_fails) {
    for (const auto& name : some_meshes) {
        const auto& mesh = discretized(name);
        for (int k = 1; k < mesh.dimension(); ++k) {
            const CubicForm w(space(mesh), k, 3);
            EXPECT_GT(relative_difference(d(mesh.complex(), de_rham(mesh, k, w.form(), 1)).values,
                                          de_rham(mesh, k + 1, w.d(), 1).values),
                      1e-4)
                << name << ", k = " << k;
        }
    }
}

TEST(DeRhamBroken, with_the_other_sign_dual_stokes_theorem_fails) {
    // obtuse4 has no vertex inside
    const std::vector<std::pair<std::string, int>> highest_degrees = {
        {"hex4", 1}, {"uv8", 1}, {"boundary_of_tesseract", 2}, {"obtuse4", 2}};
    for (const auto& [name, highest] : highest_degrees)
        for (int j = 0; j <= highest; ++j)
            EXPECT_GT(dual_stokes_defect(discretized(name, MergeCriterion::none), j, -1), 1e-3)
                << name << ", j = " << j;
    for (const auto& name : {"uv_sphere7x5", "torus9x5", "hex4"})
        for (int j = 0; j < 2; ++j)
            EXPECT_GT(
                dual_stokes_defect(discretized(name, MergeCriterion::none, Delaunay::flips), j, -1),
                1e-3)
                << name << ", j = " << j << ", flipped";
}

/// How far the integrals of a constant 1-form along dual edges, from places of n-cells to places of
/// facets, are from the star of the (n-1)-form whose Hodge star it is.
double star_defect(const Discretization& mesh, const Points& cells, const Points& facets) {
    const auto& K = mesh.input();
    const int n = mesh.dimension();
    const Vector w = random_vector(n, 4);
    Vector flux = Vector::Zero(K.size(n - 1));
    const double sign = n % 2 == 0 ? 1 : -1;
    for (Index t = 0; t < K.size(n); ++t)
        for (IncidenceMatrix::InnerIterator f(K.coboundary(n - 1), t); f; ++f)
            flux[f.col()] += sign * f.value() * (cells.row(t) - facets.row(f.col())).dot(w);
    // the (n-1)-form of which the constant 1-form w is the star: (-1)^(n-1) times w's own star
    const Vector coefficient = (n % 2 == 0 ? -1 : 1) * smooth_star(n, 1, w);
    const Cochain form = de_rham(mesh, n - 1, constant_form(coefficient), 1);
    return relative_difference(flux, star({mesh.complex(), mesh.volumes()}, form).values);
}

TEST(DeRhamBroken, with_barycenters_the_star_of_constant_forms_is_wrong) {
    for (const auto& name : {"wellcentred4", "obtuse_planar", "bcc2", "kuhn4"}) {
        const auto& mesh = discretized(name, MergeCriterion::none);
        const int n = mesh.dimension();
        EXPECT_LE(star_defect(mesh, cell_centers(mesh, n), cell_centers(mesh, n - 1)), 1e-12)
            << name;
        EXPECT_GT(star_defect(mesh, cell_centroids(mesh, n), cell_centroids(mesh, n - 1)), 0.01)
            << name;
    }
}

TEST(DeRhamRefuses, what_is_no_form) {
    const auto& mesh = discretized("grid4");
    const SmoothForm two = constant_form(Vector::Ones(2)), none;
    EXPECT_REFUSED(de_rham(mesh, 0, two), "2 coefficients", "(0, 0)", "1");
    EXPECT_REFUSED(de_rham(mesh, 3, two), "primal forms", "degree 3", "dimension 2", "0", "2");
    EXPECT_THROW(dual_de_rham(mesh, -1, two), InvalidInput);
    EXPECT_REFUSED(de_rham(mesh, 1, none), "empty", "function");
    EXPECT_REFUSED(function_form({}), "empty", "function");
    EXPECT_REFUSED(circulation_form({}), "vector field", "empty", "function");
    EXPECT_REFUSED(flux_form({}), "vector field", "empty", "function");
    const auto pole = function_form([](const Vector& x) { return 1 / x.norm(); });
    EXPECT_REFUSED(de_rham(mesh, 0, pole), "form", "finite", "(0, 0)");
    EXPECT_REFUSED(de_rham(mesh, 1, circulation_form(constant_form(Vector::Ones(3)))),
                   "vector field", "3 coefficients");
    EXPECT_REFUSED(de_rham(mesh.input(), Points::Zero(3, 2), 1, two), "3 points", "25 vertices");
}

} // namespace polydec::test::in_de_rham
