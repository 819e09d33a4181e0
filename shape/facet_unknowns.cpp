// SPDX-License-Identifier: MIT
#include "shape/facet_unknowns.h"

#include "base/errors.h"
#include "shape/forms.h"

namespace polydec {

FacetUnknowns facet_unknowns(const Shape& shape, const std::vector<FacetSide>& sides, int each) {
    const int n = shape.pieces.dimension();
    std::vector<Index> first(shape.pieces.size(n - 1), -1);
    for (const FacetSide& side : sides)
        if (!side.is_essential)
            first[side.facet] = 0;
    FacetUnknowns result{0, {}, {}};
    for (Index& number : first)
        if (number == 0) {
            number = result.count;
            result.count += each;
        }
    for (const FacetSide& side : sides)
        for (int k = 0; k < each; ++k) {
            const Index number = first[side.facet];
            result.unknowns.push_back(number < 0 ? -1 : number + k);
            result.signs.push_back(side.sign);
        }
    return result;
}

double conductivity_of(const Shape& shape, Index simplex) {
    return shape.conductivity.size() == 0 ? 1.0 : shape.conductivity[simplex];
}

double density_of(const Shape& shape, Index simplex) {
    return shape.density.size() == 0 ? 1.0 : shape.density[simplex];
}

FormFamily lower_form(const Shape& shape, int degree) {
    return degree == 1 ? crouzeix_raviart_form(shape) : hybrid_form(shape);
}

DenseMatrix facet_moments(const Shape& shape, int degree, const ConformingForm& from,
                          const DenseMatrix& values) {
    const int n = shape.pieces.dimension();
    const int each = degree == 1 ? 1 : n;
    const FacetUnknowns to = facet_unknowns(shape, facet_sides(shape), each);
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
                const Index row = to.unknowns[entry];
                if (row < 0)
                    continue;
                moments.row(row).setZero();
                const int a = k < i ? k : k + 1;
                for (std::size_t p = 0; p < width; ++p) {
                    const Index at = from.points().unknowns[width * s + p];
                    if (pairs[p][0] == i || pairs[p][1] == i || at < 0)
                        continue;
                    const int sign = from.points().signs[width * s + p] * to.signs[entry];
                    moments.row(row) += sign * mean(p, a) * values.row(at);
                }
            }
    return moments;
}

} // namespace polydec
