// SPDX-License-Identifier: MIT
#pragma once

#include <dlfcn.h>

namespace polydec {

/// The small dense blocks of sparse factors are slower on many threads than on one. OpenBLAS, where
/// it is what stands behind the BLAS, can be told so; others are left as they are. Compiled with
/// each engine, since a module sees what it has brought along, and the program does not.
class BlasThreads {
public:
    explicit BlasThreads(int wished) {
        const auto get = find<int()>("openblas_get_num_threads");
        set_ = find<void(int)>("openblas_set_num_threads");
        if (wished <= 0 || !get || !set_) {
            set_ = nullptr;
            return;
        }
        before_ = get();
        set_(wished);
    }
    ~BlasThreads() {
        if (set_)
            set_(before_);
    }
    BlasThreads(const BlasThreads&) = delete;
    BlasThreads& operator=(const BlasThreads&) = delete;

private:
    template <typename Function>
    static Function* find(const char* name) {
        return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
    }

    void (*set_)(int) = nullptr;
    int before_ = 0;
};

} // namespace polydec
