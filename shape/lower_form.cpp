// SPDX-License-Identifier: MIT
#include "shape/forms.h"

namespace polydec {

FormFamily lower_form(const Shape& shape, int degree) {
    return degree == 1 ? crouzeix_raviart_form(shape) : hybrid_form(shape);
}

DenseMatrix facet_moments(const Shape& shape, int degree, const ConformingForm& from,
                          const DenseMatrix& values) {
    const int n = shape.pieces.dimension();
    const int each = degree == 1 ? 1 : n;
    const Unknowns to = facet_unknowns(shape, facet_sides(shape), each);
    const auto& pairs = from.pairs();
    const auto width = pairs.size();
    const bool is_linear = width == std::size_t(n + 1);

    // the mean over a facet of a basis function, times a barycentric coordinate if each > 1
    const auto mean = [&](std::size_t p, int a) {
        const auto [i, j] = pairs[p];
        const auto of = [&](std::initializer_list<int> with_a, std::initializer_list<int> without) {
            return static_cast<double>(mean_of_product(n - 1, each > 1 ? with_a : without));
        };
        if (is_linear)
            return of({i, a}, {i});
        if (i != j)
            return 4 * of({i, j, a}, {i, j});
        return 2 * of({i, i, a}, {i, i}) - of({i, a}, {i}); // lambda_i (2 lambda_i - 1)
    };
    DenseMatrix moments = DenseMatrix::Zero(to.count, values.cols());
    std::size_t entry = 0;
    for (Index s = 0; s < shape.pieces.size(n); ++s)
        for (int i = 0; i <= n; ++i)
            for (int k = 0; k < each; ++k, ++entry) {
                const Index row = to.of_simplices[entry];
                if (row < 0)
                    continue;
                moments.row(row).setZero();
                const int a = k < i ? k : k + 1;
                for (std::size_t p = 0; p < width; ++p) {
                    const Index at = from.points().of_simplices[width * s + p];
                    if (pairs[p][0] == i || pairs[p][1] == i || at < 0)
                        continue;
                    const int sign = from.points().signs[width * s + p] * to.signs[entry];
                    moments.row(row) += sign * mean(p, a) * values.row(at);
                }
            }
    return moments;
}

} // namespace polydec
