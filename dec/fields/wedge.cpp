// SPDX-License-Identifier: MIT
#include "dec/fields/wedge.h"

#include "base/errors.h"
#include "base/permutation_sign.h"
#include "dec/fields/flat_pieces.h"
#include "dec/fields/transfer.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

using Positions = std::vector<int>;

/// A k-face and an l-face of a (k+l)-simplex that share one vertex: their positions in the lists of
/// faces, the vertex, and the sign of their product.
struct Pair {
    std::size_t first, second;
    int vertex;
    double sign;
};

/// The list with the item moved to its front or end.
Positions with_first(Positions list, int item) {
    const auto place = std::find(list.begin(), list.end(), item);
    std::rotate(list.begin(), place, place + 1);
    return list;
}
Positions with_last(Positions list, int item) {
    const auto place = std::find(list.begin(), list.end(), item);
    std::rotate(place, place + 1, list.end());
    return list;
}

/// Sign of the order (a without v, v, b without v) of 0..k+l, times the signs of the permutations
/// that bring v to the end of a and to the front of b.
double sign_of(const Positions& a, const Positions& b, int v) {
    const Positions left = with_last(a, v), right = with_first(b, v);
    Positions order = left;
    order.insert(order.end(), right.begin() + 1, right.end());
    return permutation_sign(order) * permutation_sign(left) * permutation_sign(right);
}

std::vector<Pair> pairs_of(const std::vector<Positions>& first,
                           const std::vector<Positions>& second) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t j = 0; j < second.size(); ++j) {
            Positions common;
            std::set_intersection(first[i].begin(), first[i].end(), second[j].begin(),
                                  second[j].end(), std::back_inserter(common));
            if (common.size() == 1)
                pairs.push_back({i, j, common[0], sign_of(first[i], second[j], common[0])});
        }
    return pairs;
}

/// Sum over pairs of faces; share(s, v) is the weight of the vertex at position v of s; the weights
/// of s sum to 1.
template <class Share>
Cochain product(const Pieces& complex, const Cochain& a, const Cochain& b, Share share) {
    const int k = a.degree, l = b.degree, m = k + l;
    SimplexFaces first(complex, m, k), second(complex, m, l);
    const auto pairs = pairs_of(first.positions(), second.positions());
    const double weight = // k! l! / (k+l)!
        std::tgamma(k + 1.0) * std::tgamma(l + 1.0) / std::tgamma(m + 1.0);

    Vector values = Vector::Zero(complex.size(m));
    for (Index s = 0; s < complex.size(m); ++s) {
        const auto &sigma = first.of(s), &rho = second.of(s);
        double sum = 0;
        for (const auto& pair : pairs) {
            const Index f = sigma[pair.first], g = rho[pair.second];
            const double sign = orientation(complex, k, f) * orientation(complex, l, g);
            sum += sign * pair.sign * share(s, pair.vertex) * a.values[f] * b.values[g];
        }
        values[s] = weight * orientation(complex, m, s) * sum;
    }
    return {Side::primal, m, values};
}

} // namespace

Cochain wedge(const Pieces& complex, const Cochain& a, const Cochain& b) {
    check_factors(complex, Side::primal, a, b);
    const double share = 1.0 / (a.degree + b.degree + 1);
    return product(complex, a, b, [share](Index, int) { return share; });
}

Cochain wedge(const Discretization& mesh, const Cochain& a, const Cochain& b,
              WedgeWeights weights) {
    check_factors(mesh.complex(), Side::primal, a, b);
    const Cochain x = on_pieces(mesh, a), y = on_pieces(mesh, b);
    if (weights == WedgeWeights::uniform)
        return on_cells(mesh, wedge(mesh.pieces(), x, y));
    refuse_flat_pieces(mesh, "the product weighted by parts of duals");
    const Geometry& geometry = mesh.geometry();
    const int m = a.degree + b.degree;
    const Points parts = parts_of_duals(geometry, geometry.centers(), 0, m);
    const Vector& volumes = geometry.volumes().primal(m);
    return on_cells(mesh, product(mesh.pieces(), x, y,
                                  [&](Index s, int v) { return parts(s, v) / volumes[s]; }));
}

Vector primal_dual_wedge(const CellComplex& complex, const Cochain& a, const Cochain& b) {
    check(complex, a);
    check(complex, b);
    const int n = complex.dimension();
    if (a.side != Side::primal || b.side != Side::dual || a.degree + b.degree != n)
        throw InvalidInput(
            fmt::format("the primal-dual product is not defined for a {} {}-form and a {} {}-form: "
                        "expected a primal k-form and a dual ({}-k)-form, in this order",
                        name(a.side), a.degree, name(b.side), b.degree, n));
    return a.values.cwiseProduct(b.values);
}

} // namespace polydec
