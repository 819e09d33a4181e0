// SPDX-License-Identifier: MIT
#include "dec/mesh_warnings.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

void warn_of_orientation(std::int64_t turned, std::int64_t cells, bool orientable,
                         std::vector<std::string>& warnings) {
    if (turned > 0)
        warnings.push_back(fmt::format("{} of {} cells {} turned to be oriented like {} neighbors",
                                       turned, cells, turned == 1 ? "was" : "were",
                                       turned == 1 ? "its" : "their"));
    if (!orientable)
        warnings.emplace_back("the mesh is non-orientable: its cells keep the orientation of the "
                              "input, and operators on dual 0-forms see jumps of sign");
}

void warn_of_branching(std::int64_t facets, std::vector<std::string>& warnings) {
    if (facets > 0)
        warnings.push_back(fmt::format("not a manifold: {} facet{} with three or more cells",
                                       facets, facets == 1 ? "" : "s"));
}

void warn_of_jitter(std::int64_t flat, std::int64_t nearly, double wider,
                    std::vector<std::string>& warnings) {
    if (flat > 0 && nearly > 0)
        warnings.push_back(fmt::format(
            "{} flat cell{} on no neighbor's sphere within the tolerance, and the duals of {} "
            "facets are within a factor 10 of it: if corners are meant to be cospherical, try "
            "the tolerance {:.0e}",
            flat, flat == 1 ? " lies" : "s lie", nearly, wider));
}

void warn_of_unit(double unit, std::vector<std::string>& warnings) {
    if (unit != 1)
        warnings.push_back(fmt::format("the lengths of the mesh are far from 1: it is measured in "
                                       "units of 2^{} = {:.3g}",
                                       std::ilogb(unit), unit));
}

} // namespace polydec
