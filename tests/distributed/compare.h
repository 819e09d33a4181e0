// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"
#include "tests/distributed/swept.h"

namespace polydec::test {

/// All ways to own vertices; one of them by turns where there are several ranks, since ranks on a
/// small machine wait for each other.
inline std::vector<Ownership> some_ownerships(const Ranks& ranks, const std::string& name) {
    const std::vector<Ownership> all = {Ownership::file, Ownership::morton, Ownership::graph,
                                        Ownership::random};
    return ranks.size() == 1 ? all : std::vector{all[name.size() % all.size()]};
}

inline LocalComplex distributed(const Ranks& ranks, const Mesh& mesh, Ownership by) {
    const MeshSlice slice = slice_of(ranks, mesh);
    return local_complex(ranks, slice, vertex_owners(ranks, slice, by));
}

inline DistributedMesh discretized(const Ranks& ranks, const Mesh& mesh, Ownership by) {
    const MeshSlice slice = slice_of(ranks, mesh);
    DistributedMesh made = discretize(ranks, slice, vertex_owners(ranks, slice, by));
    made.star = StarKind::circumcentric;
    return made;
}

/// What differs between the simplices of a rank and those of one process: numbers, owners,
/// orientations and cofaces; empty if nothing does.
inline std::string difference(const LocalComplex& local, const SimplicialComplex& whole) {
    const int n = whole.dimension();
    if (local.dimension() != n || local.orientable != whole.orientable() ||
        local.turned != whole.turned())
        return fmt::format("orientable {} for {}, turned {} for {}", local.orientable,
                           whole.orientable(), local.turned, whole.turned());
    for (int k = 0; k <= n; ++k) {
        const auto& degree = local.degree(k);
        if (degree.count != whole.size(k))
            return fmt::format("{} {}-simplices for {}", degree.count, k, whole.size(k));
        for (Index s = 0; s < degree.size(); ++s) {
            const auto number = static_cast<Index>(degree.number[s]);
            if (number < 0 || number >= whole.size(k))
                return fmt::format("{}-simplex {} has no number", k, s);
            if (local.complex.vertex_numbers(k, s) != whole.vertex_numbers(k, number))
                return fmt::format("{}-simplex {} has other vertices", k, number);
            if (degree.owner[s] != local.degree(0).owner[local.complex.simplices(k)(s, 0)])
                return fmt::format("{}-simplex {} belongs to another vertex", k, number);
            if (k == n && local.complex.orientation(s) != whole.orientation(number))
                return fmt::format("simplex {} is turned", number);
            if (degree.complete[s] &&
                local.complex.coface_counts(k)[s] != whole.coface_counts(k)[number])
                return fmt::format("{}-simplex {} lacks cofaces", k, number);
            for (int i = 0; k > 0 && i <= k; ++i)
                if (local.degree(k - 1).number[local.complex.face(k, s, i)] !=
                    whole.face(k, number, i))
                    return fmt::format("{}-simplex {} has other faces", k, number);
        }
    }
    return "";
}

} // namespace polydec::test
