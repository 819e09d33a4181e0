// SPDX-License-Identifier: MIT
#include "dec/metric/subsets.h"
#include "tests/support/test.h"

namespace polydec::test {

namespace {

/// Mean of a quadratic polynomial over a k-simplex, from its values at vertices and at the middles
/// of edges: weights (2 - k) and 4, over (k + 1)(k + 2).
Vector mean(const Form& form, const DenseMatrix& corners) {
    const auto k = static_cast<double>(corners.cols()) - 1;
    Vector sum = 0 * form(corners.col(0));
    for (Index i = 0; i < corners.cols(); ++i) {
        sum += (2 - k) * form(corners.col(i));
        for (Index j = 0; j < i; ++j)
            sum += 4 * form((corners.col(i) + corners.col(j)) / 2);
    }
    return sum / ((k + 1) * (k + 2));
}

} // namespace

Form constant_form(Vector coefficients) {
    return [c = std::move(coefficients)](const Vector&) { return c; };
}

DenseMatrix multivectors(const SimplicialComplex& complex, const Points& points, int k) {
    const auto axes = subsets(static_cast<int>(points.cols()), k);
    DenseMatrix result(complex.size(k), axes.size());
    const double factorial = std::tgamma(k + 1.0);
    for (Index s = 0; s < complex.size(k); ++s) {
        const auto vertices = complex.simplices(k).row(s);
        DenseMatrix edges(k, points.cols());
        for (int i = 0; i < k; ++i)
            edges.row(i) = points.row(vertices[i + 1]) - points.row(vertices[0]);
        const double sign = k == complex.dimension() ? complex.orientation(s) : 1;
        for (std::size_t I = 0; I < axes.size(); ++I) {
            DenseMatrix minor(k, k);
            for (int c = 0; c < k; ++c)
                minor.col(c) = edges.col(axes[I][c]);
            result(s, I) = sign * (k == 0 ? 1.0 : minor.determinant()) / factorial;
        }
    }
    return result;
}

Vector integrate(const SimplicialComplex& complex, const Points& points, int k, const Form& form) {
    const DenseMatrix simplices = multivectors(complex, points, k);
    Vector result(complex.size(k));
    for (Index s = 0; s < complex.size(k); ++s) {
        DenseMatrix corners(points.cols(), k + 1);
        for (int i = 0; i <= k; ++i)
            corners.col(i) = points.row(complex.simplices(k)(s, i));
        result[s] = simplices.row(s).dot(mean(form, corners));
    }
    return result;
}

} // namespace polydec::test
