// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/shared.h"
#include "base/types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace polydec {

/// Number of a cell, vertex or record over all ranks.
using GlobalIndex = std::int64_t;

/// Items sent to, or received from, each rank.
template <class Item>
using Parcels = std::vector<std::vector<Item>>;

/// The items of all parcels, in the order of ranks.
template <class Item>
std::vector<Item> unpacked(const Parcels<Item>& parcels) {
    std::vector<Item> items;
    for (const auto& parcel : parcels)
        items.insert(items.end(), parcel.begin(), parcel.end());
    return items;
}

/// Divides items 0 .. count - 1 into one range per rank, of equal lengths except for the last ones.
class EqualStretches {
public:
    EqualStretches(GlobalIndex count, int ranks)
        : count_(count), length_(std::max<GlobalIndex>(1, (count + ranks - 1) / ranks)) {}
    GlobalIndex count() const { return count_; }
    GlobalIndex begin(int rank) const { return std::min(count_, rank * length_); }
    GlobalIndex end(int rank) const { return begin(rank + 1); }
    int rank_of(GlobalIndex item) const { return static_cast<int>(item / length_); }
    std::vector<int> ranks_of(const std::vector<GlobalIndex>& items) const {
        std::vector<int> ranks;
        for (const GlobalIndex item : items)
            ranks.push_back(rank_of(item));
        return ranks;
    }

private:
    GlobalIndex count_, length_;
};

/// The processes that work together on one mesh, each with its own memory. All ranks must call
/// every collective, in the same order. A handle: copies refer to the same ranks.
///
/// Code that may throw on one rank must run in `together`, without collectives inside. Then an
/// error on one rank becomes the same error on all, and no rank waits for another in vain. An error
/// inside MPI ends the program.
class Ranks {
public:
    /// All processes started by mpirun; one without mpirun. Starts MPI and PETSc unless they are
    /// running, and ends them with the program. Throws BackendUnavailable if they have ended.
    static Ranks all();

    int rank() const;
    int size() const;

    /// Collective: does local work and returns its result. If it fails, all ranks throw the error
    /// of the first failing rank. `what` names the work for a listener.
    template <class Work>
    auto together(std::string_view what, Work&& work) const {
        using Result = std::invoke_result_t<Work>;
        std::exception_ptr failure;
        if constexpr (std::is_void_v<Result>) {
            attempt(failure, [&] {
                begin(what);
                work();
            });
            vote(failure);
        } else {
            std::optional<Result> result;
            attempt(failure, [&] {
                begin(what);
                result.emplace(work());
            });
            vote(failure);
            return std::move(*result);
        }
    }

    /// Calls listener(what) at the start of every local work; its exceptions count as thrown there.
    /// For progress, and for tests of errors.
    void listen(Progress listener) const;

    /// Collectives over one number per rank: sum, largest and least, the sum over the ranks before
    /// this one, and whether the flag is set on any rank.
    GlobalIndex sum(GlobalIndex own) const;
    double sum(double own) const;
    GlobalIndex sum(Index own) const { return sum(GlobalIndex{own}); }
    GlobalIndex largest(GlobalIndex own) const;
    double largest(double own) const;
    double least(double own) const;
    GlobalIndex sum_before(GlobalIndex own) const;
    bool any(bool own) const;

    /// Collective: the entrywise maxima over the ranks.
    void take_largest(std::span<double> own) const;

    /// Collective: the entrywise sums over the ranks, identical on all.
    void add_up(std::span<double> own) const;

    /// Collective: sends parcel r to rank r, and returns the parcel received from each rank. Memory
    /// and time are proportional to the data sent; a rank's own parcel is not copied. Items are
    /// plain data.
    template <class Item>
    Parcels<Item> deliver(Parcels<Item> parcels) const {
        static_assert(std::is_trivially_copyable_v<Item>);
        const auto own = static_cast<std::size_t>(rank());
        std::vector<GlobalIndex> counts;
        std::vector<const void*> from;
        for (const auto& parcel : parcels) {
            counts.push_back(static_cast<GlobalIndex>(parcel.size()));
            from.push_back(parcel.data());
        }
        counts[own] = 0;
        const auto arriving = exchange_counts(counts);
        Parcels<Item> result(parcels.size());
        std::vector<void*> to;
        [&]() noexcept { // if memory runs out, the program ends: others are waiting
            for (std::size_t r = 0; r < result.size(); ++r) {
                result[r].resize(arriving[r]);
                to.push_back(result[r].data());
            }
        }();
        transfer(sizeof(Item), counts, from, arriving, to);
        result[own] = std::move(parcels[own]);
        return result;
    }

    /// Collective: asks rank whom[i] question i. That rank answers as local work: write(question,
    /// row) fills a row of `width` items. The rows are in the order of the questions.
    template <class Item, class Question, class Write>
    std::vector<Item> ask_rows(std::string_view what, std::ptrdiff_t width,
                               const std::vector<int>& whom, const std::vector<Question>& questions,
                               Write write) const {
        Parcels<Question> asked = empty_parcels<Question>();
        for (std::size_t i = 0; i < whom.size(); ++i)
            asked[whom[i]].push_back(questions[i]);
        const auto to_answer = deliver(std::move(asked));
        const auto given = deliver(together(what, [&] {
            Parcels<Item> answers = empty_parcels<Item>();
            for (std::size_t r = 0; r < answers.size(); ++r) {
                answers[r].resize(to_answer[r].size() * static_cast<std::size_t>(width));
                Item* row = answers[r].data();
                for (const Question& question : to_answer[r]) {
                    write(question, row);
                    row += width;
                }
            }
            return answers;
        }));
        std::vector<const Item*> next;
        for (const auto& parcel : given)
            next.push_back(parcel.data());
        std::vector<Item> result;
        result.reserve(whom.size() * static_cast<std::size_t>(width));
        for (const int r : whom) {
            result.insert(result.end(), next[r], next[r] + width);
            next[r] += width;
        }
        return result;
    }

    /// The same for one item each: answer(question).
    template <class Answer, class Question, class Work>
    std::vector<Answer> ask(std::string_view what, const std::vector<int>& whom,
                            const std::vector<Question>& questions, Work answer) const {
        return ask_rows<Answer>(
            what, 1, whom, questions,
            [&](const Question& question, Answer* row) { *row = answer(question); });
    }

    /// Collective: the items of all ranks, in the order of ranks.
    template <class Item>
    std::vector<Item> of_all(const std::vector<Item>& own) const {
        return unpacked(deliver(Parcels<Item>(static_cast<std::size_t>(size()), own)));
    }

    /// An empty parcel for each rank.
    template <class Item>
    Parcels<Item> empty_parcels() const {
        return Parcels<Item>(static_cast<std::size_t>(size()));
    }

    /// Bytes sent by this rank to others so far, through deliver and ask.
    std::int64_t bytes_sent() const;

    /// Whether all ranks call this within this many seconds, possibly infinity, of each other.
    /// After an error without a vote, the ranks without the error wait elsewhere for the others.
    bool all_come(double seconds) const;

    /// Ends the program on all ranks.
    [[noreturn]] void abort(int code) const;

    struct State;
    const State& state() const { return *state_; }

private:
    explicit Ranks(std::shared_ptr<State> state) : state_(std::move(state)) {}

    template <class Work>
    static void attempt(std::exception_ptr& failure, Work work) {
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
        }
    }
    void begin(std::string_view what) const;
    void vote(const std::exception_ptr& failure) const;
    std::vector<GlobalIndex> exchange_counts(const std::vector<GlobalIndex>& counts) const;
    void transfer(std::size_t item_size, const std::vector<GlobalIndex>& counts,
                  const std::vector<const void*>& from, const std::vector<GlobalIndex>& arriving,
                  const std::vector<void*>& to) const;

    Shared<State> state_;
};

/// Ranges of items, one per rank, one after the other.
class Stretches {
public:
    /// Collective: the range of this rank begins with item `first`.
    Stretches(const Ranks& ranks, GlobalIndex first)
        : begins_(ranks.of_all(std::vector<GlobalIndex>{first})) {}
    int rank_of(GlobalIndex item) const {
        return static_cast<int>(std::upper_bound(begins_.begin(), begins_.end(), item) -
                                begins_.begin() - 1);
    }

private:
    std::vector<GlobalIndex> begins_;
};

} // namespace polydec
