// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <dlfcn.h>

namespace polydec {

/// Keeps OpenBLAS and OpenMP on one thread during its lifetime: small dense blocks of sparse
/// factors are slower on many threads than on one, and CHOLMOD otherwise takes four OpenMP threads.
/// Other BLAS keep their setting. Compiled with each engine, since a module sees its own libraries,
/// and the program does not.
class OneThread {
public:
    OneThread() {
        settings_[0].take("openblas_get_num_threads", "openblas_set_num_threads", 1);
        // with no active levels allowed, parallel regions have one thread
        settings_[1].take("omp_get_max_active_levels", "omp_set_max_active_levels", 0);
    }
    ~OneThread() {
        for (const auto& setting : settings_)
            if (setting.set)
                setting.set(setting.before);
    }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    struct Setting {
        void (*set)(int) = nullptr;
        int before = 0;

        void take(const char* get_name, const char* set_name, int wished) {
            const auto get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, get_name));
            const auto change = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, set_name));
            if (!get || !change)
                return;
            before = get();
            change(wished);
            set = change;
        }
    };

    std::array<Setting, 2> settings_;
};

} // namespace polydec
