// SPDX-License-Identifier: MIT
#include "dec/metric/centers.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/metric/center_heights.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

Centers Centers::centroids() {
    std::vector<Points> rows;
    for (int m = 1; m <= most_vertices; ++m)
        rows.emplace_back(Points::Constant(1, m, 1.0 / m));
    Centers result;
    result.kind_ = Kind::centroids;
    result.given_ = std::make_shared<const std::vector<Points>>(std::move(rows));
    return result;
}

Centers::Centers(std::vector<Points> coordinates) : kind_(Kind::given) {
    constexpr double rounding = 1e-12;
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
        check_as_many(fmt::format("coordinates of the center of a {}-simplex", k),
                      coordinates[k].cols(), static_cast<Index>(k) + 1);
        for (Eigen::Index s = 0; s < coordinates[k].rows(); ++s)
            if (!(std::abs(coordinates[k].row(s).sum() - 1) <=
                  rounding * (1 + coordinates[k].row(s).cwiseAbs().sum())))
                throw InvalidInput(
                    fmt::format(
                        "the coordinates of the center of {}-simplex {} add up to {}: expected 1",
                        k, s, coordinates[k].row(s).sum()),
                    {.degree = static_cast<int>(k), .cells = {static_cast<Index>(s)}});
    }
    given_ = std::make_shared<const std::vector<Points>>(std::move(coordinates));
}

Centers Centers::of_cells(Points moments, Points terms) {
    check_as_many("rows of terms", terms.rows(), moments.rows());
    check_as_many("terms of a center", terms.cols(), 4);
    if (!moments.allFinite() || !terms.allFinite())
        throw InvalidInput("a moment of a shared center is not a finite number");
    Centers result;
    result.kind_ = Kind::of_cells;
    result.given_ = std::make_shared<const std::vector<Points>>(
        std::vector<Points>{std::move(moments), std::move(terms)});
    return result;
}

double CenterHeights::shared_coordinate(Index s, int i) const {
    const auto moments = given_->front().row(s);
    constexpr double rounding = 1e-12;
    const double sum = moments.sum();
    return std::abs(sum) > rounding * moments.cwiseAbs().sum()
               ? moments[i] / sum
               : 1.0 / static_cast<double>(moments.size());
}

void Centers::check_fit(const Pieces& complex) const {
    if (kind_ == Kind::of_cells) {
        check_as_many("moments of a center", given_->front().cols(), complex.dimension() + 1);
        check_as_many("shared centers of n-simplices", given_->front().rows(),
                      complex.size(complex.dimension()));
    }
    if (kind_ != Kind::given)
        return;
    check_as_many("degrees of centers", static_cast<Index>(given_->size()),
                  complex.dimension() + 1);
    for (int k = 0; k <= complex.dimension(); ++k)
        check_as_many(fmt::format("centers of {}-simplices", k), (*given_)[k].rows(),
                      complex.size(k));
}

Points center_coordinates(const Pieces& complex, const SimplexMetric& metric,
                          const Centers& centers, int k) {
    check_number("the centers of simplices of degree", k, 0, complex.dimension());
    centers.check_fit(complex);
    SimplexLayout layout(complex, metric);
    const CenterHeights heights(centers);
    Circumsphere sphere;
    Points result(complex.size(k), k + 1);
    for (Index s = 0; s < complex.size(k); ++s) {
        if (!heights.know(k))
            sphere.look_at(layout, k, s);
        for (int i = 0; i <= k; ++i)
            result(s, i) = heights.coordinate(k, s, i, sphere);
    }
    return result;
}

Points combinations(const Pieces& complex, int k, const Points& coordinates,
                    const Points& of_vertices) {
    check_number("a place in simplices of degree", k, 0, complex.dimension());
    check_as_many("rows of coordinates", coordinates.rows(), complex.size(k));
    check_as_many("coordinates of a place", coordinates.cols(), k + 1);
    check_as_many("rows of vertices", of_vertices.rows(), complex.size(0));
    Points result = Points::Zero(complex.size(k), of_vertices.cols());
    for (Index s = 0; s < complex.size(k); ++s)
        for (int i = 0; i <= k; ++i)
            result.row(s) += coordinates(s, i) * of_vertices.row(complex.simplices(k)(s, i));
    return result;
}
} // namespace polydec
