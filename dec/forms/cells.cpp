// SPDX-License-Identifier: MIT
#include "dec/forms/cells.h"

#include "base/checks.h"
#include "dec/forms/input_units.h"
#include "dec/merging/merged_cells.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace polydec {

Cells::Cells(const CellComplex& complex, const HodgeStars& stars, double unit)
    : complex_(complex),
      volumes_(stars.volumes()),
      stars_(std::make_shared<Lazy<ChosenStars>>(ChosenStars(stars))),
      unit_(unit) {
    check_fit(complex, stars);
}

Cells::Cells(std::shared_ptr<const MergedCells> merged, std::function<ChosenStars()> stars,
             double unit)
    : complex_(merged->complex()),
      volumes_(merged->volumes()),
      merged_(std::move(merged)),
      make_stars_(std::move(stars)),
      stars_(std::make_shared<Lazy<ChosenStars>>()),
      unit_(unit) {}

const ChosenStars& Cells::chosen_stars() const& {
    return stars_->get(make_stars_);
}

const CellVolumes& Cells::input_volumes() const& {
    return unit_ == 1 ? volumes_
                      : input_volumes_->get([this] { return in_input_units(volumes_, unit_); });
}

const HodgeStars& Cells::input_stars() const& {
    return unit_ == 1 ? stars()
                      : input_stars_->get([this] { return in_input_units(stars(), unit_); });
}

Cells Cells::with_stars(const ChosenStars& chosen) const {
    check_fit(complex_, chosen.stars);
    check_as_many("marks of cells with Galerkin's stars", std::ssize(chosen.galerkin),
                  complex_.size(dimension()));
    Cells result = *this;
    result.stars_ = std::make_shared<Lazy<ChosenStars>>(chosen);
    result.input_stars_ = std::make_shared<Lazy<HodgeStars>>();
    return result;
}

Cells Cells::with_star(int k, const SparseMatrix& star) const {
    SparseMatrix measured = in_input_units(star, unit_, 2 * k - dimension(), "the star");
    return with_stars(ChosenStars(stars().with(k, std::move(measured))));
}

std::vector<bool> Cells::boundary_facets_without_dual() const {
    const int facets = dimension() - 1;
    std::vector<bool> marks(static_cast<std::size_t>(complex_.size(facets)), false);
    for (const Index f : stars()[facets].zeros())
        marks[f] = complex_.coface_counts(facets)[f] == 1;
    return marks;
}

std::string Cells::name(int k, Index cell) const {
    const std::string what = k == dimension() - 1 ? "facet" : fmt::format("{}-cell", k);
    if (!merged_)
        return fmt::format("{} {}", what, stars()[k].numbers({cell}));
    return fmt::format("{} {} (vertices {})", what, cell, fmt::join(place(k, cell).vertices, ", "));
}

Error::Place Cells::place(int k, Index cell) const {
    if (!merged_)
        return stars()[k].place({cell});
    const Merging& merging = merged_->merging();
    return {.degree = k,
            .cells = {cell},
            .vertices = merging.pieces().vertex_numbers(merging.vertices(k, cell))};
}

} // namespace polydec
