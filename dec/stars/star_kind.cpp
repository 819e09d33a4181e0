// SPDX-License-Identifier: MIT
#include "complex/surfaces/glued_surface.h"
#include "dec/stars/star.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polydec {

const char* name(StarKind kind) {
    constexpr std::array names{"circumcentric", "galerkin",  "hybrid",
                               "barycentric",   "automatic", "own"};
    return names[static_cast<std::size_t>(kind)];
}

bool all_positive(const HodgeStars& stars) {
    for (int k = 0; k <= stars.dimension(); ++k)
        if (!stars[k].zeros().empty() || !stars[k].negatives().empty())
            return false;
    return true;
}

StarKind automatic_kind(int dimension, bool every_dual_is_positive) {
    return every_dual_is_positive                 ? StarKind::circumcentric
           : dimension == GluedSurface::dimension ? StarKind::hybrid
                                                  : StarKind::galerkin;
}

ChosenStars::ChosenStars(const HodgeStars& stars_, StarKind kind_, std::vector<bool> galerkin_)
    : stars(stars_), kind(kind_), galerkin(std::move(galerkin_)) {}

ChosenStars::ChosenStars(const HodgeStars& stars_, StarKind kind_)
    : ChosenStars(
          stars_, kind_,
          std::vector<bool>(stars_.dimension() < 0
                                ? 0
                                : static_cast<std::size_t>(stars_[stars_.dimension()].size()))) {}

bool ChosenStars::is_over_duals(int k) const {
    return stars[k].is_diagonal() &&
           (kind == StarKind::circumcentric || kind == StarKind::own || k == stars.dimension());
}

double ChosenStars::galerkin_share() const {
    const auto count = std::count(galerkin.begin(), galerkin.end(), true);
    return galerkin.empty() ? 0 : static_cast<double>(count) / static_cast<double>(galerkin.size());
}

} // namespace polydec
