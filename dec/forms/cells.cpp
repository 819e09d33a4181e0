// SPDX-License-Identifier: MIT
#include "dec/forms/cells.h"

#include "base/checks.h"
#include "dec/merging/merged_cells.h"
#include "meshes/unit_of_length.h"

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

namespace {

/// Each by itself: a volume that underflows is refused, however small it is beside others.
Vector positive_in_input_units(const Vector& volumes, double unit, int k) {
    const std::string what = fmt::format("volumes of degree {}", k);
    return volumes.unaryExpr(
        [&](double volume) { return in_input_units(Vector{{volume}}, unit, k, what)[0]; });
}

} // namespace

const Vector& Cells::input_volumes(int k) const& {
    const Vector& measured = volumes_.primal(k);
    return unit_ == 1 ? measured : (*input_volumes_)[k][0].get([&] {
        return positive_in_input_units(measured, unit_, k);
    });
}

const Vector& Cells::input_dual_volumes(int k) const& {
    const Vector& measured = volumes_.dual(k);
    return unit_ == 1 ? measured : (*input_volumes_)[k][1].get([&] {
        return in_input_units(measured, unit_, dimension() - k,
                              fmt::format("dual volumes of degree {}", k));
    });
}

HodgeStar Cells::geometric_star(int k) const {
    const ChosenStars& chosen = chosen_stars();
    return chosen.is_over_duals(k) ? HodgeStar(volumes_, k) : chosen.geometric[k];
}

Cells Cells::with_stars(const ChosenStars& chosen) const {
    check_fit(complex_, chosen.stars);
    check_as_many("marks of cells with Galerkin's stars", std::ssize(chosen.galerkin),
                  complex_.size(dimension()));
    Cells result = *this;
    result.stars_ = std::make_shared<Lazy<ChosenStars>>(chosen);
    return result;
}

Cells Cells::with_star(int k, const SparseMatrix& star) const {
    SparseMatrix measured = in_input_units(star, unit_, 2 * k - dimension(), "the star");
    ChosenStars own(stars().with(k, measured));
    own.geometric = chosen_stars().geometric.with(k, std::move(measured));
    return with_stars(own);
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
