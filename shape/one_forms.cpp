// SPDX-License-Identifier: MIT
#include "shape/one_forms.h"

#include "base/errors.h"
#include "shape/gluing.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// The first of the positive bounds of both, ascending, behind zeros.
Vector merged(const ShapeSpectrum& a, const ShapeSpectrum& b, Vector ShapeSpectrum::*bounds,
              Index zeros, Index count) {
    const auto positive = [&](const ShapeSpectrum& of) {
        return Vector((of.*bounds).tail((of.*bounds).size() - of.zeros));
    };
    const Vector of_a = positive(a), of_b = positive(b);
    Vector all(of_a.size() + of_b.size());
    all << of_a, of_b;
    std::sort(all.begin(), all.end());
    Vector result = Vector::Zero(count);
    result.tail(count - zeros) = all.head(count - zeros);
    return result;
}

/// Euler's characteristic of the surface relative to its essential edges. Points do not join what
/// meets at them alone.
Index characteristic(const Shape& shape) {
    const Pieces& pieces = shape.pieces;
    const auto sides = facet_sides(shape);
    const auto vertices = glued_points(shape, sides, {{0, 0}, {1, 1}, {2, 2}});
    std::vector<bool> is_essential(pieces.size(1), false);
    for (const FacetSide& side : sides)
        is_essential[side.facet] = side.is_essential;
    const auto edges =
        static_cast<Index>(std::count(is_essential.begin(), is_essential.end(), false));
    return vertices.count - edges + pieces.size(2);
}

} // namespace

bool are_one_forms(const Shape& shape, int degree) {
    const int n = shape.pieces.dimension();
    if (degree == 0 || degree == n)
        return false;
    if (degree != 1 || n != 2)
        throw InvalidInput(
            fmt::format("{}-forms of a shape of dimension {}: expected degree 0 or {}, or 1 on a "
                        "surface; no bounds are known for other degrees",
                        degree, n, n));
    if (shape.conductivity.size() > 0 || shape.density.size() > 0)
        throw InvalidInput("1-forms of a shape with weights: only functions support weights; omit "
                           "conductivity and density");
    refuse_robin(shape.pieces, shape.conditions, "1-forms of a shape");
    return true;
}

ShapeSpectrum one_form_spectrum(const Shape& shape, const ShapeSpectrumOptions& options) {
    ShapeSpectrum result;
    // the Betti number b_1
    result.zeros = std::min(zero_eigenvalues(shape) + zero_eigenvalues(top_forms(shape)) -
                                characteristic(shape),
                            options.count);
    // positive ones: as many of each as are wanted of both, and one for the gap behind
    const auto spectrum = [&](const Shape& of) {
        ShapeSpectrumOptions more = options;
        more.degree = 0;
        more.count = std::max<Index>(options.count - result.zeros, 1) + zero_eigenvalues(of);
        return shape_spectrum(of, more);
    };
    const ShapeSpectrum functions = spectrum(shape), densities = spectrum(top_forms(shape));
    for (const auto bounds : {&ShapeSpectrum::lower, &ShapeSpectrum::upper})
        result.*bounds = merged(functions, densities, bounds, result.zeros, options.count);
    result.factorizations = functions.factorizations + densities.factorizations + 2;
    result.simplices = std::max(functions.simplices, densities.simplices);
    result.count_at = std::min(functions.count_at, densities.count_at);
    result.count = one_form_count(shape, result.count_at,
                                  {.level = options.level, .linear_solver = options.linear_solver});
    for (const ShapeSpectrum* const part : {&functions, &densities})
        result.warnings.insert(result.warnings.end(), part->warnings.begin(), part->warnings.end());
    return result;
}

CountBelow one_form_count(const Shape& shape, double s, const CountOptions& options) {
    CountOptions of_functions = options;
    of_functions.degree = 0;
    const CountBelow functions = count_below(shape, s, of_functions);
    const CountBelow densities = count_below(top_forms(shape), s, of_functions);
    if (!(s > 0))
        return functions;
    // the zeros of functions and densities less those of 1-forms
    const Index euler = characteristic(shape);
    CountBelow result = functions;
    result.at_least = functions.at_least + densities.at_least - euler;
    if (functions.at_most && densities.at_most)
        result.at_most = *functions.at_most + *densities.at_most - euler;
    return result;
}

} // namespace polydec
