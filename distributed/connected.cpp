// SPDX-License-Identifier: MIT
#include "distributed/connected.h"

#include "complex/disjoint_sets.h"
#include "distributed/petsc_calls.h"
#include "distributed/shared_classes.h"

namespace polydec {

namespace {

/// The connections of own unknowns by a matrix.
struct Connections {
    GlobalIndex first_row = 0;
    std::vector<std::pair<Index, Index>> own;
    std::vector<std::pair<Index, GlobalIndex>> to_others; ///< whose rows these are
};

Connections connections_of(Mat graph) {
    Connections result;
    PetscInt begin = 0, end = 0;
    require(MatGetOwnershipRange(graph, &begin, &end), "looking at a matrix");
    result.first_row = begin;
    for (PetscInt row = begin; row < end; ++row) {
        PetscInt count = 0;
        const PetscInt* columns = nullptr;
        const double* entries = nullptr;
        require(MatGetRow(graph, row, &count, &columns, &entries), "looking at a matrix");
        for (PetscInt e = 0; e < count; ++e) {
            const PetscInt j = columns[e];
            if (entries[e] == 0 || j == row)
                continue;
            if (j >= begin && j < end)
                result.own.emplace_back(row - begin, j - begin);
            else
                result.to_others.emplace_back(row - begin, j);
        }
        require(MatRestoreRow(graph, row, &count, &columns, &entries), "looking at a matrix");
    }
    return result;
}

/// Adds the sums of local parts over each component; the owner of its first part does so.
struct OverAll {
    FreeComponents::Sums operator()(const FreeComponents::Sums& of_parts) const {
        const Stretches stretches(ranks, first_part);
        struct Share {
            GlobalIndex component;
            long double value;
        };
        auto shares = ranks.empty_parcels<Share>();
        std::vector<int> whom;
        for (std::size_t p = 0; p < component.size(); ++p) {
            whom.push_back(stretches.rank_of(component[p]));
            shares[whom.back()].push_back({component[p], of_parts[static_cast<Index>(p)]});
        }
        std::vector<long double> totals(component.size(), 0);
        for (const auto& parcel : ranks.deliver(std::move(shares)))
            for (const auto& [whole, value] : parcel)
                totals[whole - first_part] += value;
        const auto result = ranks.ask<long double>(
            "sums", whom, component, [&](GlobalIndex whole) { return totals[whole - first_part]; });
        return FreeComponents::Sums::Map(result.data(), static_cast<Index>(result.size()));
    }

    Ranks ranks;
    GlobalIndex first_part;             ///< here
    std::vector<GlobalIndex> component; ///< of parts here: the number of its first part
};

} // namespace

GlobalIndex component_count(const Ranks& ranks, const LocalComplex& local) {
    const Index vertices = local.complex.size(0);
    std::vector<Index> parts;
    Index count = 0;
    ranks.together("components", [&] {
        DisjointSets sets(vertices);
        for (const auto& edge : local.complex.simplices(1).rowwise())
            sets.join(edge[0], edge[1]);
        parts = sets.firsts();
        for (Index v = 0; v < vertices; ++v)
            parts[v] = parts[v] == v ? count++ : parts[parts[v]];
    });
    const std::vector<std::int8_t> signs(parts.size(), 1);
    const GlobalIndex first = ranks.sum_before(count);
    const auto shared = join_parts(ranks, local.degree(0).copies, parts, signs, count);
    GlobalIndex own = 0; // components whose first part is here
    for (Index part = 0; part < count; ++part)
        own += shared[part].first == first + part ? 1 : 0;
    return ranks.sum(own);
}

SharedComponents::SharedComponents(const Ranks& ranks, Mat graph, const HeldUnknowns& held,
                                   Vector weights)
    : ranks_(ranks) {
    const auto n = static_cast<Index>(weights.size());
    const auto& fixed = held.fixed;
    const Connections connections = connections_of(graph);
    DisjointSets sets(n);
    std::vector<bool> is_held = held.tied;
    for (const auto& [i, j] : connections.own)
        if (!fixed[i]) {
            if (fixed[j])
                is_held[i] = true;
            else
                sets.join(i, j);
        }

    // what hangs together here, numbered over all ranks
    std::vector<Index> part_of(n, -1), first;
    for (Index i = 0; i < n; ++i) {
        if (fixed[i])
            continue;
        const Index root = sets.find(i).element;
        part_of[i] = root == i ? static_cast<Index>(first.size()) : part_of[root];
        if (root == i)
            first.push_back(i);
    }
    const auto parts = static_cast<Index>(first.size());
    OverAll over_all{ranks, ranks.sum_before(parts), {}};
    const GlobalIndex first_part = over_all.first_part;

    // and with those of other ranks, whose number is -1 if they are fixed
    const Stretches rows(ranks, connections.first_row);
    std::vector<GlobalIndex> wanted;
    std::vector<int> whom;
    for (const auto& [i, row] : connections.to_others) {
        wanted.push_back(row);
        whom.push_back(rows.rank_of(row));
    }
    const auto beside = ranks.ask<GlobalIndex>("parts", whom, wanted, [&](GlobalIndex row) {
        const Index part = part_of[row - connections.first_row];
        return part < 0 ? -1 : first_part + part;
    });
    std::vector<SharedElement> shared;
    for (std::size_t e = 0; e < beside.size(); ++e) {
        const Index i = connections.to_others[e].first;
        if (fixed[i])
            continue;
        if (beside[e] < 0)
            is_held[i] = true;
        else
            shared.push_back({first_part + part_of[i], beside[e], 1});
    }
    for (const auto& joined : join_shared(ranks, first_part, parts, std::move(shared)))
        over_all.component.push_back(joined.first);

    FreeComponents::Sums holds = FreeComponents::Sums::Zero(parts);
    for (Index i = 0; i < n; ++i)
        if (part_of[i] >= 0 && is_held[i])
            holds[part_of[i]] = 1;
    holds = over_all(holds);
    grounded_.assign(n, false);
    for (Index p = 0; p < parts; ++p)
        if (holds[p] == 0 && over_all.component[p] == first_part + p) {
            grounded_[first[p]] = true;
            ++count_;
        }
    count_ = ranks.sum(count_);
    for (Index& part : part_of)
        if (part >= 0 && holds[part] > 0)
            part = -1;
    parts_ = {std::move(part_of), parts, std::move(weights), std::move(over_all)};
    if (ranks.any(!parts_.have_means()))
        refuse_means();
}

Compatibility SharedComponents::balance(Vector& b) const {
    const Compatibility local = parts_.balance(b);
    return {static_cast<Index>(count_), ranks_.largest(local.worst)};
}

} // namespace polydec
