// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_constants {

/// Constant forms on flat meshes, obtuse ones included: the star takes the exact integrals over
/// primal cells to the exact integrals over dual cells, so the codifferential vanishes inside.
class ConstantForms : public OverMeshes {
protected:
    /// A random constant k-form, integrated over the cells of K.
    Vector on_simplices(int k) const {
        const auto N = static_cast<Index>(mesh().points.cols());
        return integrate(mesh().K(), mesh().points, k,
                         constant_form(random_vector(coefficients(N, k), 17 + k)));
    }
    Vector on_merged_cells(int k) const {
        return mesh().merging().diamond(k).cast<double>() * on_simplices(k);
    }
    bool flat() const { return mesh().points.cols() == mesh().n(); }
};

/// Largest entry of d_(k-1)^T star_k w off the boundary, over what it is made of.
double divergence_inside(const CellComplex& complex, const Vector& star, const Vector& w, int k) {
    const SparseMatrix transposed = SparseMatrix(derivative(complex, k - 1).transpose());
    const Vector flux = star.cwiseProduct(w);
    const Vector divergence = transposed * flux;
    const auto boundary = boundary_cells(complex);
    double result = 0;
    for (Index s = 0; s < complex.size(k - 1); ++s)
        if (!boundary[k - 1][s])
            result = std::max(result, std::abs(divergence[s]));
    return result / flux.cwiseAbs().maxCoeff();
}

TEST_P(ConstantForms, are_closed) {
    for (int k = 0; k < mesh().n(); ++k) {
        const Vector w = on_simplices(k), W = on_merged_cells(k);
        EXPECT_LE((derivative(mesh().K(), k) * w).cwiseAbs().maxCoeff(),
                  1e-13 * w.cwiseAbs().maxCoeff());
        EXPECT_LE((derivative(mesh().P(), k) * W).cwiseAbs().maxCoeff(),
                  1e-13 * W.cwiseAbs().maxCoeff());
    }
}

TEST_P(ConstantForms, have_no_codifferential_inside_flat_meshes) {
    for (int k = 1; flat() && k <= mesh().n(); ++k) {
        EXPECT_LE(divergence_inside(mesh().K(), star(mesh().input_volumes, k).diagonal(),
                                    on_simplices(k), k),
                  1e-11)
            << "k = " << k;
        EXPECT_LE(divergence_inside(mesh().P(), star(mesh().volumes, k).diagonal(),
                                    on_merged_cells(k), k),
                  1e-11)
            << "k = " << k;
    }
}

POLYDEC_OVER_MESHES(ConstantForms);

TEST(ConstantFormsBroken, stars_without_sign_give_them_a_codifferential) {
    for (const char* name : {"obtuse_planar", "obtuse_solid"}) {
        const auto& mesh = merged(name);
        const auto N = static_cast<Index>(mesh.points.cols());
        const Vector w = integrate(mesh.K(), mesh.points, 1, constant_form(random_vector(N, 18)));
        const Vector unsigned_star = star(mesh.input_volumes, 1).diagonal().cwiseAbs();
        EXPECT_GT(divergence_inside(mesh.K(), unsigned_star, w, 1), 1e-2) << name;
    }
}

} // namespace polydec::test::in_constants
