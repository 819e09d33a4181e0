// SPDX-License-Identifier: MIT
#include "dec/discretization/mesh_warnings.h"

#include "base/listed.h"
#include "base/lists.h"
#include "dec/metric/overlaps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace polydec {

void warn_of_orientation(std::int64_t turned, std::int64_t cells, bool orientable,
                         std::vector<std::string>& warnings) {
    if (turned > 0)
        warnings.push_back(
            fmt::format("{} of {} cells {} turned to match the orientation of {} neighbors", turned,
                        cells, turned == 1 ? "was" : "were", turned == 1 ? "its" : "their"));
    if (!orientable)
        warnings.emplace_back("the mesh is non-orientable: its cells keep the orientation of the "
                              "input, and dual 0-forms change sign across some facets");
}

void warn_of_branching(std::int64_t facets, std::vector<std::string>& warnings) {
    if (facets > 0)
        warnings.push_back(fmt::format("not a manifold: {} facet{} with three or more cells",
                                       facets, facets == 1 ? "" : "s"));
}

void warn_of_jitter(std::int64_t flat, std::int64_t nearly, double wider,
                    std::vector<std::string>& warnings) {
    if (flat > 0 && nearly > 0)
        warnings.push_back(
            fmt::format("{} flat cell{} on no neighbor's sphere within the tolerance, and the "
                        "duals of {} facets exceed the tolerance by a factor of at most 10: if "
                        "corners should be cospherical, try the tolerance {:.0e}",
                        flat, flat == 1 ? " lies" : "s lie", nearly, wider));
}

void warn_of_unit(double unit, std::vector<std::string>& warnings) {
    if (unit != 1)
        warnings.push_back(fmt::format(
            "the lengths of the mesh are far from 1: polydec measures it in units of 2^{} = {:.3g}",
            std::ilogb(unit), unit));
}

std::int64_t branching_facets(const CellComplex& complex) {
    const auto& counts = complex.coface_counts(complex.dimension() - 1);
    return std::count_if(counts.begin(), counts.end(), [](Index c) { return c > 2; });
}

void warn_of_overlaps(const SimplicialComplex& complex, const Points& points,
                      std::vector<std::string>& warnings) {
    const int n = complex.dimension();
    const auto [folded, wound] = find_overlaps(complex, points);
    warn_of_overlaps(named(complex, n, folded), complex.size(n), named(complex, 0, wound),
                     warnings);
}

NamedSimplices named(const Pieces& complex, int k, const std::vector<Index>& simplices) {
    NamedSimplices result{std::ssize(simplices)};
    for (std::size_t i = 0; i < std::min(simplices.size(), most_listed); ++i)
        result.first.push_back(complex.vertex_numbers(k, simplices[i]));
    return result;
}

void warn_of_overlaps(const NamedSimplices& folded, std::int64_t cells, const NamedSimplices& wound,
                      std::vector<std::string>& warnings) {
    const auto names = [](const NamedSimplices& of) {
        return listed(numbers_below(of.first.size()), static_cast<std::size_t>(of.count),
                      [&](Index i) { return fmt::format("{}", fmt::join(of.first[i], " ")); });
    };
    if (folded.count > 0)
        warnings.push_back(
            fmt::format("the mesh is folded: {} of {} cells lie{} over {} neighbors (vertices {}): "
                        "results are for the folded mesh, not for the region that it covers",
                        folded.count, cells, folded.count == 1 ? "s" : "",
                        folded.count == 1 ? "its" : "their", names(folded)));
    if (wound.count > 0)
        warnings.push_back(fmt::format(
            "the mesh overlaps itself: cells around {} lie over each other without a fold (vertex "
            "{}): results are for the mesh as glued, not for the region that it covers",
            counted(static_cast<std::size_t>(wound.count), "vertex", "vertices"), names(wound)));
}

void warn_of_unjoined(const UnjoinedBoundary& boundary, int n, std::vector<std::string>& warnings) {
    const char* const remedy =
        n <= 3 ? "join_hanging(mesh) splits the cells there" : "mesh both sides so that they fit";
    const auto warn = [&](const std::vector<Index>& found, const char* one, const char* many,
                          const char* cure) {
        if (!found.empty())
            warnings.push_back(fmt::format(
                "{} of the boundary {} (vertex {}): the mesh is slit there; {}",
                found.size() == 1 ? "1 vertex" : fmt::format("{} vertices", found.size()),
                found.size() == 1 ? one : many,
                listed(found, [](Index v) { return fmt::format("{}", v); }), cure));
    };
    warn(boundary.coincident, "coincides with another", "coincide with others",
         "weld(mesh) joins coincident vertices");
    warn(boundary.hanging, "hangs inside an edge or facet of a larger cell",
         "hang inside edges or facets of larger cells", remedy);
    if (boundary.misfits > 0 && boundary.hanging.empty())
        warnings.push_back(fmt::format("{} facets of the boundary lie on facets with other "
                                       "corners: the mesh is slit there; {}",
                                       boundary.misfits, remedy));
}

void warn_of_flips(const IntrinsicStatistics& flips, double unit,
                   std::vector<std::string>& warnings) {
    if (flips.added_length > 0)
        warnings.push_back(fmt::format("a triangle has nearly no area: {:.3g} was added to the "
                                       "length of every edge before flips (area: +{:.2g} %)",
                                       unit * flips.added_length, 100 * flips.added_area));
    if (flips.negative_interior > 0)
        warnings.push_back(fmt::format("{} interior edges kept a negative dual: rounding is larger "
                                       "than the triangles there",
                                       flips.negative_interior));
}

} // namespace polydec
