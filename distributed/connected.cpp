// SPDX-License-Identifier: MIT
#include "distributed/connected.h"

#include "complex/disjoint_sets.h"
#include "distributed/petsc_calls.h"
#include "distributed/shared_classes.h"

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

/// The connections of own unknowns by a matrix.
struct Connections {
    GlobalIndex first_row = 0;
    std::vector<std::pair<Index, Index>> own;
    std::vector<std::pair<Index, GlobalIndex>> to_others; ///< whose rows these are
    std::vector<int> owners;                              ///< of these
};

Connections connections_of(Mat graph) {
    Connections result;
    PetscInt begin = 0, end = 0;
    const PetscInt* ranges = nullptr;
    PetscMPIInt size = 0;
    require(MatGetOwnershipRange(graph, &begin, &end), "looking at a matrix");
    require(MatGetOwnershipRanges(graph, &ranges), "looking at a matrix");
    MPI_Comm_size(PetscObjectComm(reinterpret_cast<PetscObject>(graph)), &size);
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
            if (j >= begin && j < end) {
                result.own.emplace_back(row - begin, j - begin);
            } else {
                result.to_others.emplace_back(row - begin, j);
                result.owners.push_back(
                    static_cast<int>(std::upper_bound(ranges, ranges + size + 1, j) - ranges - 1));
            }
        }
        require(MatRestoreRow(graph, row, &count, &columns, &entries), "looking at a matrix");
    }
    return result;
}

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
        own += shared[static_cast<std::size_t>(part)].first == first + part ? 1 : 0;
    return ranks.sum(own);
}

SharedComponents::SharedComponents(const Ranks& ranks, Mat graph, const HeldUnknowns& held,
                                   Vector weights)
    : ranks_(ranks), weights_(std::move(weights)) {
    const auto n = static_cast<Index>(weights_.size());
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
    std::vector<Index> part_of_root(static_cast<std::size_t>(n), -1);
    part_.assign(static_cast<std::size_t>(n), -1);
    std::vector<Index> first;
    for (Index i = 0; i < n; ++i) {
        if (fixed[i])
            continue;
        Index& part = part_of_root[sets.find(i).element];
        if (part < 0) {
            part = static_cast<Index>(first.size());
            first.push_back(i);
        }
        part_[i] = part;
    }
    const auto parts = static_cast<Index>(first.size());
    first_part_ = ranks.sum_before(parts);

    // and with those of other ranks, whose number is -1 if they are fixed
    std::vector<GlobalIndex> wanted;
    for (const auto& [i, row] : connections.to_others)
        wanted.push_back(row);
    const auto beside =
        ranks.ask<GlobalIndex>("parts", connections.owners, wanted, [&](GlobalIndex row) {
            const Index part = part_[static_cast<std::size_t>(row - connections.first_row)];
            return part < 0 ? -1 : first_part_ + part;
        });
    std::vector<SharedElement> shared;
    for (std::size_t e = 0; e < beside.size(); ++e) {
        const Index i = connections.to_others[e].first;
        if (fixed[i])
            continue;
        if (beside[e] < 0)
            is_held[i] = true;
        else
            shared.push_back({first_part_ + part_[i], beside[e], 1});
    }
    for (const auto& joined : join_shared(ranks, first_part_, parts, std::move(shared)))
        component_.push_back(joined.first);

    std::vector<double> holds(static_cast<std::size_t>(parts), 0);
    for (Index i = 0; i < n; ++i)
        if (part_[i] >= 0 && is_held[i])
            holds[part_[i]] = 1;
    holds = over_all(std::move(holds));
    grounded_.assign(static_cast<std::size_t>(n), false);
    for (Index p = 0; p < parts; ++p)
        if (holds[p] == 0 && component_[p] == first_part_ + p) {
            grounded_[first[p]] = true;
            ++count_;
        }
    count_ = ranks.sum(count_);
    for (Index& part : part_)
        if (part >= 0 && holds[part] > 0)
            part = -1;
    weights_of_all_ = sums(weights_);
}

/// Numbers of parts added up over those of a component, which the owner of its first part does.
std::vector<double> SharedComponents::over_all(std::vector<double> of_parts) const {
    const auto begins = ranks_.of_all(std::vector<GlobalIndex>{first_part_});
    struct Share {
        GlobalIndex component;
        double value;
    };
    auto shares = ranks_.empty_parcels<Share>();
    std::vector<int> whom;
    for (std::size_t p = 0; p < of_parts.size(); ++p) {
        whom.push_back(static_cast<int>(
            std::upper_bound(begins.begin(), begins.end(), component_[p]) - begins.begin() - 1));
        shares[whom.back()].push_back({component_[p], of_parts[p]});
    }
    std::vector<double> totals(of_parts.size(), 0);
    for (const auto& parcel : ranks_.deliver(std::move(shares)))
        for (const auto& [component, value] : parcel)
            totals[static_cast<std::size_t>(component - first_part_)] += value;
    return ranks_.ask<double>("sums", whom, component_, [&](GlobalIndex component) {
        return totals[static_cast<std::size_t>(component - first_part_)];
    });
}

std::vector<double> SharedComponents::sums(const Vector& values) const {
    std::vector<double> of_parts(component_.size(), 0);
    for (std::size_t i = 0; i < part_.size(); ++i)
        if (part_[i] >= 0)
            of_parts[part_[i]] += values[static_cast<Index>(i)];
    return over_all(std::move(of_parts));
}

Compatibility SharedComponents::balance(Vector& b) const {
    const auto sum = sums(b), size = sums(b.cwiseAbs());
    double worst = 0;
    for (std::size_t p = 0; p < sum.size(); ++p)
        if (size[p] > 0)
            worst = std::max(worst, std::abs(sum[p]) / size[p]);
    for (Index i = 0; i < b.size(); ++i)
        if (const Index p = part_[i]; p >= 0)
            b[i] -= sum[p] * weights_[i] / weights_of_all_[p];
    return {static_cast<Index>(count_), ranks_.largest(worst)};
}

void SharedComponents::remove_means(Vector& u) const {
    const auto weighted = sums(weights_.cwiseProduct(u));
    for (Index i = 0; i < u.size(); ++i)
        if (const Index p = part_[i]; p >= 0)
            u[i] -= weighted[p] / weights_of_all_[p];
}

} // namespace polydec
