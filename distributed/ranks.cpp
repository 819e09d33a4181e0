// SPDX-License-Identifier: MIT
#include "distributed/ranks.h"

#include "backends/linear/petsc_session.h"
#include "base/errors.h"
#include "distributed/communicator.h"
#include "system/memory.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <new>
#include <span>
#include <string>
#include <thread>

namespace polydec {

namespace {

enum class Kind : std::int64_t { input, solver, memory, backend, io, other };

/// An error in a form that can be sent.
struct Report {
    Kind kind = Kind::other;
    std::string text;
    Error::Place place;
};

Report describe(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const InvalidInput& error) {
        return {Kind::input, error.what(), error.place()};
    } catch (const OutOfMemory& error) {
        return {Kind::memory, error.what(), error.place()};
    } catch (const SolverFailure& error) {
        return {Kind::solver, error.what(), error.place()};
    } catch (const BackendUnavailable& error) {
        return {Kind::backend, error.what(), error.place()};
    } catch (const IoError& error) {
        return {Kind::io, error.what(), error.place()};
    } catch (const std::bad_alloc&) {
        return {Kind::io, "not enough memory: use more ranks, or machines with more memory", {}};
    } catch (const std::exception& error) {
        return {Kind::other, error.what(), {}};
    } catch (...) {
        return {Kind::other, "an exception of unknown type", {}};
    }
}

[[noreturn]] void raise(const Report& report) {
    switch (report.kind) {
    case Kind::input:
        throw InvalidInput(report.text, report.place);
    case Kind::solver:
        throw SolverFailure(report.text, SolveReport::failed(""), report.place);
    case Kind::memory:
        throw OutOfMemory(report.text, SolveReport::failed(""), report.place);
    case Kind::backend:
        throw BackendUnavailable(report.text, report.place);
    case Kind::io:
        throw IoError(report.text, report.place);
    case Kind::other:
        break;
    }
    throw Error(report.text, report.place);
}

/// Numbers and letters, one list of each.
struct Packed {
    std::vector<std::int64_t> numbers;
    std::string letters;
};

Packed pack(const Report& report) {
    const auto& [degree, cells, vertices, path, line] = report.place;
    const std::string file = path.string();
    Packed packed{{static_cast<std::int64_t>(report.kind), degree, line, std::ssize(cells),
                   std::ssize(report.text)},
                  report.text + file};
    packed.numbers.insert(packed.numbers.end(), cells.begin(), cells.end());
    packed.numbers.insert(packed.numbers.end(), vertices.begin(), vertices.end());
    return packed;
}

Report unpack(const Packed& packed) {
    const auto& numbers = packed.numbers;
    const auto cells = numbers.begin() + 5, vertices = cells + numbers[3];
    const auto end_of_text = static_cast<std::size_t>(numbers[4]);
    return {static_cast<Kind>(numbers[0]),
            packed.letters.substr(0, end_of_text),
            {.degree = static_cast<int>(numbers[1]),
             .cells = {cells, vertices},
             .vertices = {vertices, numbers.end()},
             .path = packed.letters.substr(end_of_text),
             .line = numbers[2]}};
}

using Clock = std::chrono::steady_clock;

/// Whether they have ended before a time. Leaves the processor to others before long: ranks that
/// share one would else wait for each other's turns to end.
bool await(std::span<MPI_Request> requests, Clock::time_point latest = Clock::time_point::max()) {
    constexpr int eager = 1000;
    constexpr std::chrono::microseconds pause(50);
    for (int tries = 0, done = 0;; ++tries) {
        MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
        if (done != 0)
            return true;
        if (tries < eager)
            continue;
        if (Clock::now() > latest)
            return false;
        std::this_thread::sleep_for(pause);
    }
}

/// Begins a collective call by `begin(MPI_Request*)` and returns when it has ended.
template <class Begin>
void call_together(Begin begin) {
    MPI_Request request = MPI_REQUEST_NULL;
    begin(&request);
    await({&request, 1});
}

template <class Number>
void reduce(MPI_Comm communicator, std::span<Number> numbers, MPI_Datatype type, MPI_Op operation) {
    call_together([&](MPI_Request* request) {
        MPI_Iallreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), type,
                       operation, communicator, request);
    });
}

template <class Item>
void broadcast(MPI_Comm communicator, std::span<Item> items, MPI_Datatype type, int from) {
    call_together([&](MPI_Request* request) {
        MPI_Ibcast(items.data(), static_cast<int>(items.size()), type, from, communicator, request);
    });
}

template <class Number>
Number reduced(MPI_Comm communicator, Number own, MPI_Datatype type, MPI_Op operation) {
    reduce(communicator, std::span(&own, 1), type, operation);
    return own;
}

} // namespace

Ranks Ranks::all() {
    static const auto state = [] {
        const petsc::Session session("polydec on several ranks");
        auto made = std::make_shared<State>();
        MPI_Comm_dup(MPI_COMM_WORLD, &made->communicator);
        MPI_Comm_dup(MPI_COMM_WORLD, &made->after_errors);
        MPI_Comm_rank(made->communicator, &made->rank);
        MPI_Comm_size(made->communicator, &made->size);
        return made;
    }();
    return Ranks(state);
}

std::int64_t Ranks::bytes_sent() const {
    return state_->bytes_sent;
}

bool Ranks::all_come(double seconds) const {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(state_->after_errors, &request);
    if (std::isinf(seconds))
        return await({&request, 1});
    const std::chrono::duration<double> patience(seconds);
    return await({&request, 1},
                 Clock::now() + std::chrono::duration_cast<Clock::duration>(patience));
}

void Ranks::abort(int code) const {
    MPI_Abort(MPI_COMM_WORLD, code);
    std::abort();
}

int Ranks::rank() const {
    return state_->rank;
}

int Ranks::size() const {
    return state_->size;
}

void Ranks::listen(Progress listener) const {
    state_->listener = std::move(listener);
}

void Ranks::begin(std::string_view what) const {
    if (state_->listener)
        state_->listener(what);
}

void Ranks::vote(const std::exception_ptr& failure) const {
    MPI_Comm communicator = state_->communicator;
    const int first = reduced(communicator, failure ? rank() : size(), MPI_INT, MPI_MIN);
    if (first == size())
        return;
    Packed packed;
    if (rank() == first)
        packed = pack(describe(failure));
    std::vector<std::int64_t> sizes{std::ssize(packed.numbers), std::ssize(packed.letters)};
    broadcast(communicator, std::span(sizes), MPI_INT64_T, first);
    packed.numbers.resize(sizes[0]);
    packed.letters.resize(sizes[1]);
    broadcast(communicator, std::span(packed.numbers), MPI_INT64_T, first);
    broadcast(communicator, std::span(packed.letters), MPI_CHAR, first);
    raise(unpack(packed));
}

GlobalIndex Ranks::sum(GlobalIndex own) const {
    return reduced(state_->communicator, own, MPI_INT64_T, MPI_SUM);
}

double Ranks::sum(double own) const {
    return reduced(state_->communicator, own, MPI_DOUBLE, MPI_SUM);
}

GlobalIndex Ranks::largest(GlobalIndex own) const {
    return reduced(state_->communicator, own, MPI_INT64_T, MPI_MAX);
}

double Ranks::largest(double own) const {
    return reduced(state_->communicator, own, MPI_DOUBLE, MPI_MAX);
}

double Ranks::least(double own) const {
    return reduced(state_->communicator, own, MPI_DOUBLE, MPI_MIN);
}

GlobalIndex Ranks::sum_before(GlobalIndex own) const {
    GlobalIndex before = 0;
    call_together([&](MPI_Request* request) {
        MPI_Iexscan(&own, &before, 1, MPI_INT64_T, MPI_SUM, state_->communicator, request);
    });
    return rank() == 0 ? 0 : before;
}

bool Ranks::any(bool own) const {
    return reduced(state_->communicator, own ? 1 : 0, MPI_INT, MPI_MAX) > 0;
}

void Ranks::take_largest(std::span<double> own) const {
    reduce(state_->communicator, own, MPI_DOUBLE, MPI_MAX);
}

void Ranks::add_up(std::span<double> own) const {
    reduce(state_->communicator, own, MPI_DOUBLE, MPI_SUM);
}

std::vector<GlobalIndex> Ranks::exchange_counts(const std::vector<GlobalIndex>& counts) const {
    std::vector<GlobalIndex> arriving(counts.size());
    call_together([&](MPI_Request* request) {
        MPI_Ialltoall(counts.data(), 1, MPI_INT64_T, arriving.data(), 1, MPI_INT64_T,
                      state_->communicator, request);
    });
    return arriving;
}

void Ranks::transfer(std::size_t item_size, const std::vector<GlobalIndex>& counts,
                     const std::vector<const void*>& from, const std::vector<GlobalIndex>& arriving,
                     const std::vector<void*>& to) const {
    constexpr GlobalIndex at_most = 1 << 30; // MPI counts in 32 bits
    constexpr int tag = 1;
    MPI_Datatype item = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(static_cast<int>(item_size), MPI_BYTE, &item);
    MPI_Type_commit(&item);
    std::vector<MPI_Request> requests;
    const auto in_parts = [&](GlobalIndex count, auto post) {
        for (GlobalIndex begin = 0; begin < count; begin += at_most)
            post(static_cast<std::size_t>(begin) * item_size,
                 static_cast<int>(std::min(at_most, count - begin)), &requests.emplace_back());
    };
    MPI_Comm communicator = state_->communicator;
    for (int r = 0; r < size(); ++r)
        if (r != rank())
            in_parts(arriving[r], [&](std::size_t place, int count, MPI_Request* request) {
                MPI_Irecv(static_cast<std::byte*>(to[r]) + place, count, item, r, tag, communicator,
                          request);
            });
    for (int r = 0; r < size(); ++r)
        if (r != rank())
            in_parts(counts[r], [&](std::size_t place, int count, MPI_Request* request) {
                MPI_Isend(static_cast<const std::byte*>(from[r]) + place, count, item, r, tag,
                          communicator, request);
            });
    for (int r = 0; r < size(); ++r)
        if (r != rank())
            state_->bytes_sent += counts[r] * static_cast<GlobalIndex>(item_size);
    await(requests);
    MPI_Type_free(&item);
}

} // namespace polydec
