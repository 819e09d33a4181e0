// SPDX-License-Identifier: MIT
#include "dec/forms/star.h"

#include "base/checks.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

HodgeStar::HodgeStar(const CellVolumes& volumes, int k) : volumes_(volumes), degree_(k) {
    volumes_.primal(k); // which there must be
}

void HodgeStar::check(const Vector& values) const {
    check_as_many(fmt::format("values of {}-cells", degree_), values.size(), size());
}

Vector HodgeStar::diagonal() const {
    return volumes_.dual(degree_).cwiseQuotient(volumes_.primal(degree_));
}

SparseMatrix HodgeStar::matrix() const {
    SparseMatrix result(size(), size());
    result.setIdentity(); // Eigen cannot make a diagonal of no entries
    result.coeffs() = diagonal().array();
    return result;
}

Vector HodgeStar::operator*(const Vector& values) const {
    check(values);
    return diagonal().cwiseProduct(values);
}

Vector HodgeStar::solve(const Vector& values) const {
    check(values);
    return inverse().cwiseProduct(values);
}

Vector HodgeStar::inverse() const {
    if (const auto cells = zeros(); !cells.empty())
        throw InvalidInput(fmt::format("the inverse star of degree {} divides by zero: the duals "
                                       "of {} {}-cells have no volume (cells {})",
                                       degree_, cells.size(), degree_, numbers(cells)),
                           place(cells));
    return diagonal().cwiseInverse();
}

Vector HodgeStar::uncertainty() const {
    return volumes_.rounding(degree_).cwiseQuotient(volumes_.primal(degree_));
}

std::vector<Index> HodgeStar::zeros() const {
    const Vector &dual = volumes_.dual(degree_), &terms = volumes_.terms(degree_);
    std::vector<Index> cells;
    for (Index s = 0; s < dual.size(); ++s)
        if (is_zero(dual[s], terms[s]))
            cells.push_back(s);
    return cells;
}

std::vector<Index> HodgeStar::negatives() const {
    const Vector &dual = volumes_.dual(degree_), &terms = volumes_.terms(degree_);
    std::vector<Index> cells;
    for (Index s = 0; s < dual.size(); ++s)
        if (dual[s] < 0 && !is_zero(dual[s], terms[s]))
            cells.push_back(s);
    return cells;
}

std::string HodgeStar::numbers(const std::vector<Index>& cells) const {
    constexpr std::size_t most = 5;
    std::vector<Index> first;
    for (std::size_t i = 0; i < std::min(cells.size(), most); ++i)
        first.push_back(volumes_.number(degree_, cells[i]));
    return fmt::format("{}{}", fmt::join(first, ", "), cells.size() > most ? ", .." : "");
}

Error::Place HodgeStar::place(const std::vector<Index>& cells) const {
    return {.degree = degree_, .cells = volumes_.numbers(degree_, cells)};
}

} // namespace polydec
