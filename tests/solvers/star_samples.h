// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

struct StarSample {
    std::string name;
    Discretization mesh;
    ChosenStars chosen; ///< what its stars are
};

/// A mesh, merged and as it is, with stars of every kind that is consistent and positive.
inline std::vector<StarSample> with_star_kinds(const Mesh& input) {
    std::vector<StarSample> result;
    for (const auto& [title, mesh] :
         {std::pair{"merged", circumcentric(input)},
          std::pair{"simplices", circumcentric(input, {.criterion = MergeCriterion::none})}})
        for (const StarKind kind : {StarKind::galerkin, StarKind::hybrid, StarKind::automatic}) {
            if ((kind == StarKind::hybrid) != (mesh.dimension() == 2) && kind != StarKind::galerkin)
                continue; // automatic ones of surfaces are hybrid
            auto chosen = mesh.with_stars(kind).chosen_stars();
            result.push_back({std::string(title) + ", " + name(kind), mesh.with_stars(chosen.stars),
                              std::move(chosen)});
        }
    return result;
}

/// The same of one of the family, made once for all laws.
inline const std::vector<StarSample>& with_star_kinds(const std::string& name_of) {
    static std::map<std::string, std::vector<StarSample>> made;
    auto& result = made[name_of];
    if (result.empty())
        result = with_star_kinds(mesh_named(name_of));
    return result;
}

} // namespace polydec::test
