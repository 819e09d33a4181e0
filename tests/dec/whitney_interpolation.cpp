// SPDX-License-Identifier: MIT
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_whitney_interpolation {

class WhitneyInterpolation : public OverMeshes {
protected:
    const SimplicialComplex& K() const { return mesh().K(); }
    const Points& points() const { return mesh().points; }
};

/// The integral of the Whitney form, as it is in n-simplex t, over k-face s of t, which has these
/// of its corners.
double integral(const Merged& mesh, const DenseMatrix& multivectors, const Cochain& form, Index t,
                Index s, const std::vector<int>& corners) {
    const auto rule = grundmann_moeller(form.degree, 1);
    double sum = 0;
    for (Index q = 0; q < rule.weights.size(); ++q) {
        Vector barycentric = Vector::Zero(mesh.n() + 1);
        barycentric(corners) = rule.points.row(q).transpose();
        sum += rule.weights[q] *
               multivectors.row(s).dot(whitney_form(mesh.K(), mesh.points, form, t, barycentric));
    }
    return sum;
}

TEST_P(WhitneyInterpolation, integrates_to_the_values_that_are_interpolated) {
    // every n-simplex of small meshes, some of large ones
    const Index step = K().size(mesh().n()) / 50 + 1;
    for (int k = 0; k <= mesh().n(); ++k) {
        const Cochain form{Side::primal, k, random_vector(K().size(k), 2)};
        const DenseMatrix simplices = multivectors(K(), points(), k);
        double worst = 0;
        for (Index t = 0; t < K().size(mesh().n()); t += step)
            for (const auto& corners : subsets(mesh().n() + 1, k + 1)) {
                const Index s = face_at(K(), mesh().n(), t, corners);
                const double found = integral(mesh(), simplices, form, t, s, corners);
                worst = std::max(worst, std::abs(found - form.values[s]));
            }
        EXPECT_LE(worst, 1e-12) << "k = " << k;
    }
}

/// A random point of a simplex, not necessarily inside.
Vector barycentric_point(int n, unsigned seed) {
    Vector result = random_vector(n + 1, seed);
    result[0] += 1 - result.sum();
    return result;
}

TEST_P(WhitneyInterpolation, returns_constant_forms_at_every_point_of_flat_meshes) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    const auto& whole = discretized(GetParam());
    for (int k = 0; k <= mesh().n(); ++k) {
        const Vector w = random_vector(coefficients(mesh().n(), k), 5);
        const Cochain fine{Side::primal, k, integrate(K(), points(), k, constant_form(w))};
        const Cochain coarse{Side::primal, k,
                             mesh().merging().diamond(k).cast<double>() * fine.values};
        for (Index t = 0; t < K().size(mesh().n()); t += K().size(mesh().n()) / 50 + 1) {
            const Vector place = barycentric_point(mesh().n(), t);
            EXPECT_CLOSE(whitney_form(K(), points(), fine, t, place), w, 1e-12)
                << "k = " << k << ", simplex " << t;
            EXPECT_CLOSE(whitney_form(whole, coarse, t, place), w, 1e-12)
                << "k = " << k << ", simplex " << t << ", merged";
        }
        const DenseMatrix expected = w.transpose().replicate(K().size(mesh().n()), 1);
        EXPECT_WITHIN(whitney_at_centroids(K(), points(), fine), expected, 1e-12);
        EXPECT_WITHIN(whitney_at_centroids(whole, coarse), expected, 1e-12);
    }
}

/// How far W df is from the gradient of the linear function with the values f, by its change along
/// every edge of n-simplex t.
double gradient_defect(const Merged& mesh, const Vector& f, double sign, Index t) {
    const auto& K = mesh.K();
    const Cochain df = sign * d(K, {Side::primal, 0, f});
    const Vector gradient = whitney_form(K, mesh.points, df, t, barycentric_point(mesh.n(), t));
    double worst = 0;
    for (const auto& ends : subsets(mesh.n() + 1, 2)) {
        const auto corners = K.simplices(mesh.n()).row(t);
        const Index tail = corners[ends[0]], head = corners[ends[1]];
        const Vector edge = mesh.points.row(head) - mesh.points.row(tail);
        const double change = f[head] - f[tail];
        worst = std::max(worst, std::abs(edge.dot(gradient) - change));
    }
    return worst;
}

TEST_P(WhitneyInterpolation, of_the_differential_of_a_function_is_its_gradient) {
    const Vector f = random_vector(K().size(0), 3);
    for (Index t = 0; t < K().size(mesh().n()); t += K().size(mesh().n()) / 50 + 1) {
        EXPECT_LE(gradient_defect(mesh(), f, 1, t), 1e-12);
        EXPECT_GT(gradient_defect(mesh(), f, -1, t), 1e-3) << "with the sign flipped";
    }
}

TEST_P(WhitneyInterpolation, is_tangent_to_the_simplices) {
    const DenseMatrix covectors =
        whitney_at_centroids(K(), points(), {Side::primal, 1, random_vector(K().size(1), 8)});
    for (Index t = 0; t < covectors.rows(); ++t) {
        DenseMatrix edges(mesh().n(), points().cols());
        for (int i = 0; i < mesh().n(); ++i)
            edges.row(i) = points().row(K().simplices(mesh().n())(t, i + 1)) -
                           points().row(K().simplices(mesh().n())(t, 0));
        const Vector inside = least_squares(edges, edges * covectors.row(t).transpose()).shortest;
        EXPECT_CLOSE(inside, covectors.row(t), 1e-12) << "simplex " << t;
    }
}

POLYDEC_OVER_MESHES(WhitneyInterpolation);

TEST(WhitneyInterpolationBroken, by_zeros_inside_merged_cells_misses_constant_forms) {
    for (const auto& name : {"grid4", "hex4", "kuhn3", "split_cubes"}) {
        const auto& mesh = merged(name);
        const Vector w = random_vector(mesh.n(), 5);
        const SparseMatrix diamond = mesh.merging().diamond(1).cast<double>();
        const Vector form = diamond * integrate(mesh.K(), mesh.points, 1, constant_form(w));
        const Cochain fine{Side::primal, 1, diamond.transpose() * form};
        const DenseMatrix expected = w.transpose().replicate(mesh.K().size(mesh.n()), 1);
        EXPECT_GT(
            (whitney_at_centroids(mesh.K(), mesh.points, fine) - expected).cwiseAbs().maxCoeff(),
            0.05)
            << name;
    }
}

TEST(WhitneyInterpolationBroken, without_the_orientation_of_n_simplices_misses_densities) {
    const auto& mesh = merged("kuhn3");
    const int n = mesh.n();
    Cochain form{Side::primal, n,
                 integrate(mesh.K(), mesh.points, n, constant_form(Vector::Ones(1)))};
    EXPECT_LE((whitney_at_centroids(mesh.K(), mesh.points, form).array() - 1).abs().maxCoeff(),
              1e-12);
    for (Index t = 0; t < form.values.size(); ++t)
        form.values[t] *= mesh.K().orientation(t);
    EXPECT_GT((whitney_at_centroids(mesh.K(), mesh.points, form).array() - 1).abs().maxCoeff(), 1);
}

TEST(WhitneyInterpolationRefuses, what_it_cannot_place) {
    const auto& mesh = merged("grid4");
    const auto& K = mesh.K();
    const Cochain form{Side::primal, 1, Vector::Ones(K.size(1))};
    const Vector middle = Vector::Constant(3, 1.0 / 3);
    EXPECT_REFUSED(whitney_form(K, mesh.points, {Side::dual, 1, form.values}, 0, middle),
                   "dual 1-form", "Whitney");
    EXPECT_REFUSED(whitney_form(K, mesh.points, form, 32, middle), "2-simplex 32", "32");
    EXPECT_REFUSED(whitney_form(K, mesh.points, form, 0, Vector::Ones(3)), "(1, 1, 1)",
                   "barycentric", "2-simplex 0", "3 numbers", "1");
    EXPECT_REFUSED(whitney_at_centroids(discretized("grid4"), form), "primal 1-form", "56 values",
                   "40 1-cells");
    EXPECT_THROW(whitney_at_centroids(K, mesh.points, {Side::primal, 2, form.values}),
                 InvalidInput);
}

} // namespace polydec::test::in_whitney_interpolation
