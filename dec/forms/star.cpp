// SPDX-License-Identifier: MIT
#include "dec/forms/star.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

Vector star(const CellVolumes& volumes, int k) {
    return volumes.dual(k).cwiseQuotient(volumes.primal(k));
}

std::vector<Index> zero_star_cells(const CellVolumes& volumes, int k) {
    const Vector &dual = volumes.dual(k), &terms = volumes.terms(k);
    std::vector<Index> cells;
    for (Index s = 0; s < dual.size(); ++s)
        if (is_zero(dual[s], terms[s]))
            cells.push_back(s);
    return cells;
}

std::vector<Index> negative_star_cells(const CellVolumes& volumes, int k) {
    const Vector &dual = volumes.dual(k), &terms = volumes.terms(k);
    std::vector<Index> cells;
    for (Index s = 0; s < dual.size(); ++s)
        if (dual[s] < 0 && !is_zero(dual[s], terms[s]))
            cells.push_back(s);
    return cells;
}

std::string numbers_of(const CellVolumes& volumes, int k, const std::vector<Index>& cells) {
    constexpr std::size_t most = 5;
    std::vector<Index> numbers;
    for (std::size_t i = 0; i < std::min(cells.size(), most); ++i)
        numbers.push_back(volumes.number(k, cells[i]));
    return fmt::format("{}{}", fmt::join(numbers, ", "), cells.size() > most ? ", .." : "");
}

Vector inverse_star(const CellVolumes& volumes, int k) {
    if (const auto cells = zero_star_cells(volumes, k); !cells.empty())
        throw InvalidInput(
            fmt::format("the inverse star of degree {} divides by zero: the duals of "
                        "{} {}-cells have no volume (cells {})",
                        k, cells.size(), k, numbers_of(volumes, k, cells)),
            {.degree = k, .cells = volumes.numbers(k, cells)});
    return star(volumes, k).cwiseInverse();
}

Vector dual_star(const CellVolumes& volumes, int k) {
    const int n = volumes.dimension();
    return (k * (n - k) % 2 == 0 ? 1.0 : -1.0) * inverse_star(volumes, k);
}

} // namespace polydec
