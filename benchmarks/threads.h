// SPDX-License-Identifier: MIT
#pragma once

namespace polydec::benchmarks {

/// Whether the library was built to use several threads.
bool has_threads();

/// How many threads the library has from now on, whatever OMP_NUM_THREADS says; without effect
/// where it was built for one.
void set_threads(int count);

/// So many threads in a scope, and one again behind it.
class Threads {
public:
    explicit Threads(int count) { set_threads(count); }
    ~Threads() { set_threads(1); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
};

} // namespace polydec::benchmarks
