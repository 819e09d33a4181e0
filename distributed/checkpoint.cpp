// SPDX-License-Identifier: MIT
#include "distributed/checkpoint.h"

#include "base/checks.h"
#include "base/errors.h"

#include <memory>
#include <optional>

namespace polydec {

namespace {

struct NumberedValue {
    GlobalIndex number;
    double value;
};

/// Collective: of own cells to the equal stretches of numbers.
Vector in_stretch(const Ranks& ranks, const DistributedCells::Degree& cells, const Vector& own) {
    const EqualStretches stretches(cells.count, ranks.size());
    auto parcels = ranks.empty_parcels<NumberedValue>();
    for (std::size_t i = 0; i < cells.number.size(); ++i)
        parcels[stretches.rank_of(cells.number[i])].push_back(
            {cells.number[i], own[static_cast<Index>(i)]});
    const GlobalIndex begin = stretches.begin(ranks.rank());
    Vector result(stretches.end(ranks.rank()) - begin);
    for (const auto& parcel : ranks.deliver(std::move(parcels)))
        for (const auto& [number, value] : parcel)
            result[static_cast<Index>(number - begin)] = value;
    return result;
}

} // namespace

void write_checkpoint(const Ranks& ranks, const std::filesystem::path& path,
                      const DistributedCells& cells, const SharedCheckpoint& checkpoint) {
    std::unique_ptr<CheckpointWriter> writer; // of rank 0
    ranks.together("checkpoint", [&] {
        const auto& [own, degrees] = checkpoint;
        check_as_many("vectors of a state", std::ssize(own.state), std::ssize(degrees));
        std::vector<std::int64_t> sizes;
        for (std::size_t i = 0; i < degrees.size(); ++i) {
            check_number("cells of degree", degrees[i], 0, cells.dimension());
            check_as_many("values of own cells", own.state[i].size(),
                          std::ssize(cells.degree(degrees[i]).number));
            sizes.push_back(cells.degree(degrees[i]).count);
        }
        if (ranks.rank() == 0)
            writer = std::make_unique<CheckpointWriter>(path, own, sizes);
    });
    for (std::size_t i = 0; i < checkpoint.degrees.size(); ++i) {
        const Vector stretch =
            in_stretch(ranks, cells.degree(checkpoint.degrees[i]), checkpoint.own.state[i]);
        for (int turn = 0; turn < ranks.size(); ++turn) {
            auto parcels = ranks.empty_parcels<double>();
            if (turn == ranks.rank())
                parcels[0].assign(stretch.begin(), stretch.end());
            const auto arrived = ranks.deliver(std::move(parcels));
            ranks.together("write", [&] {
                if (writer)
                    writer->add(
                        Eigen::Map<const Vector>(arrived[turn].data(), std::ssize(arrived[turn])));
            });
        }
    }
    ranks.together("write", [&] {
        if (writer)
            writer->commit();
    });
}

SharedCheckpoint read_checkpoint(const Ranks& ranks, const std::filesystem::path& path,
                                 const DistributedCells& cells, std::uint64_t problem,
                                 const std::vector<int>& degrees) {
    struct Head {
        std::uint64_t problem, step;
        double time;
    };
    auto heads = ranks.empty_parcels<Head>();
    std::optional<Checkpoint> whole; // on rank 0
    ranks.together("read", [&] {
        if (ranks.rank() != 0)
            return;
        whole = read_checkpoint(path, problem);
        check_as_many("vectors of a state", std::ssize(whole->state), std::ssize(degrees));
        for (std::size_t i = 0; i < degrees.size(); ++i)
            check_as_many("values of a state", whole->state[i].size(),
                          cells.degree(degrees[i]).count);
        for (auto& parcel : heads)
            parcel.push_back({whole->problem, whole->step, whole->time});
    });
    const auto [of_problem, step, time] = ranks.deliver(std::move(heads))[0][0];
    SharedCheckpoint result{{of_problem, step, time, {}}, degrees};
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const auto& numbers = cells.degree(degrees[i]).number;
        const auto values = ranks.ask<double>(
            "state", std::vector<int>(numbers.size(), 0), numbers,
            [&](GlobalIndex number) { return whole->state[i][static_cast<Index>(number)]; });
        result.own.state.emplace_back(Eigen::Map<const Vector>(values.data(), std::ssize(values)));
    }
    return result;
}

} // namespace polydec
