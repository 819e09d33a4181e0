// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "python/bindings/convert.h"

#include <atomic>
#include <mutex>
#include <thread>

namespace polydec::python {

/// A solver, for one thread at a time; the others wait without the interpreter's lock. A function
/// of Python's that it calls cannot use it, which throws InvalidInput instead of waiting for ever.
template <class Solver>
class Guarded {
public:
    template <class... Arguments>
    explicit Guarded(Arguments&&... arguments) : solver(std::forward<Arguments>(arguments)...) {}

    template <class Work>
    auto use(Work work) {
        if (user_ == std::this_thread::get_id())
            throw InvalidInput("a function called by a solver uses the same solver: expected a "
                               "function that uses only its arguments");
        return unlocked([&] {
            const std::lock_guard lock(in_use_);
            const Mark mark(user_);
            return work(solver);
        });
    }

    Solver solver;

private:
    struct Mark {
        explicit Mark(std::atomic<std::thread::id>& user) : user_(user) {
            user_ = std::this_thread::get_id();
        }
        ~Mark() { user_ = std::thread::id(); }
        std::atomic<std::thread::id>& user_;
    };

    std::mutex in_use_;
    std::atomic<std::thread::id> user_ = std::thread::id();
};

template <class Solver, class... Arguments>
std::unique_ptr<Guarded<Solver>> guarded(Arguments&&... arguments) {
    return unlocked(
        [&] { return std::make_unique<Guarded<Solver>>(std::forward<Arguments>(arguments)...); });
}

} // namespace polydec::python
