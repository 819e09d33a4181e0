// SPDX-License-Identifier: MIT
#pragma once

#include "shape/form_family.h"
#include "shape/shape.h"

namespace polydec {

/// The forms a - s b on conforming piecewise polynomials of degree 1 or 2, with exact inner
/// products. At least as many eigenvalues of the shape lie below s as Q(s) has negative ones
/// (Rayleigh, Ritz). The unknowns are values at vertices and, for degree 2, at midpoints of edges.
class ConformingForm {
public:
    ConformingForm(const Shape& shape, int degree);

    const FormFamily& family() const { return family_; }
    CountedMatrix stiffness() const { return sum(1, 0); } ///< of a, with Robin's part
    CountedMatrix mass() const { return sum(0, 1); }      ///< of b
    const Unknowns& points() const { return family_.unknowns(); }
    const std::vector<Pair>& pairs() const { return pairs_; } ///< of corners: the points

private:
    CountedMatrix sum(double of_a, double of_b) const;

    std::vector<Pair> pairs_;
    FormFamily family_;
};

/// The forms on means over facets. For s below the limit, at most as many eigenvalues of the shape
/// lie below s as Q(s) has negative ones. Each simplex has n^2 kappa (grad lambda_i, grad lambda_j)
/// minus s times the mass of the Crouzeix-Raviart functions, enlarged for other functions with the
/// same means. Proof: docs/what-is-proved.md. Source: Crouzeix, Raviart 1973; Carstensen, Gedicke
/// 2014; Liu 2015.
FormFamily crouzeix_raviart_form(const Shape& shape);

/// The same on means over cells, which are eliminated, and on moments over facets against linear
/// functions. Gradients are reconstructed with degree 1 and functions with degree 2: bounds of
/// order 4. Proof: docs/what-is-proved.md. Source: Carstensen, Ern, Puttkammer 2021.
FormFamily hybrid_form(const Shape& shape);

/// The lower form of degree 1 or 2, and the map from values of conforming functions of degree 1 or
/// 2 to its unknowns.
FormFamily lower_form(const Shape& shape, int degree);
DenseMatrix facet_moments(const Shape& shape, int degree, const ConformingForm& from,
                          const DenseMatrix& values);

} // namespace polydec
