// SPDX-License-Identifier: MIT
#include "backends/blas.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <dlfcn.h>
#include <mutex>

namespace polydec {

namespace {

// Fortran's dgemm, with the lengths of its two words.
using Gemm = void(const char*, const char*, const int*, const int*, const int*, const double*,
                  const double*, const int*, const double*, const int*, const double*, double*,
                  const int*, std::size_t, std::size_t);

struct FoundBlas {
    const char* (*configuration)() = nullptr;
    const char* (*kernels)() = nullptr;
    int (*threads)() = nullptr;
    Gemm* gemm = nullptr; // null where its integers have 64 bits
};

std::mutex found_mutex;
FoundBlas found_blas;

template <typename Function>
void look_up(void* library, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(dlsym(library, name));
}

const char* fitting_kernels() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512cd"))
        return "SkylakeX";
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return "Haswell";
#endif
    return nullptr;
}

bool has_long_integers(const std::string& configuration) {
    return configuration.find("USE64BITINT") != std::string::npos;
}

Gemm* found_gemm() {
    const std::lock_guard lock(found_mutex);
    return found_blas.gemm;
}

/// False where there is none.
bool multiply_by_blas(const char* how, double a, const ConstDenseBlock& A, const ConstDenseBlock& B,
                      double keep, DenseBlock C) {
    Gemm* const gemm = found_gemm();
    if (!gemm || C.size() == 0 || B.rows() == 0)
        return false;
    const auto sizes = [](auto... number) { return std::array{static_cast<int>(number)...}; };
    const auto [rows, columns, inner] = sizes(C.rows(), C.cols(), B.rows());
    const auto [stride_A, stride_B, stride_C] =
        sizes(A.outerStride(), B.outerStride(), C.outerStride());
    gemm(how, "N", &rows, &columns, &inner, &a, A.data(), &stride_A, B.data(), &stride_B, &keep,
         C.data(), &stride_C, 1, 1);
    return true;
}

} // namespace

void prepare_blas() {
    setenv("OPENBLAS_NUM_THREADS", "1", 0);
    if (const char* kernels = fitting_kernels())
        setenv("OPENBLAS_CORETYPE", kernels, 0);
}

void find_blas(void* library) {
    const std::lock_guard lock(found_mutex);
    if (found_blas.configuration)
        return;
    FoundBlas found;
    look_up(library, "openblas_get_config", found.configuration);
    look_up(library, "openblas_get_corename", found.kernels);
    look_up(library, "openblas_get_num_threads", found.threads);
    if (!found.configuration || !found.kernels || !found.threads)
        return;
    if (!has_long_integers(found.configuration()))
        look_up(library, "dgemm_", found.gemm);
    found_blas = found;
}

std::optional<Blas> loaded_blas() {
    find_blas(RTLD_DEFAULT);
    const std::lock_guard lock(found_mutex);
    if (!found_blas.configuration)
        return std::nullopt;

    // "OpenBLAS 0.3.21 NO_LAPACKE DYNAMIC_ARCH .."
    const std::string configuration = found_blas.configuration();
    const auto end_of_version = configuration.find(' ', configuration.find(' ') + 1);
    return Blas{.name = configuration.substr(0, end_of_version),
                .kernels = found_blas.kernels(),
                .threads = found_blas.threads(),
                .integer_bits = has_long_integers(configuration) ? 64 : 32};
}

void add_product(double a, const ConstDenseBlock& A, const ConstDenseBlock& B, double keep,
                 DenseBlock C) {
    if (multiply_by_blas("N", a, A, B, keep, C))
        return;
    if (keep == 0)
        C.setZero();
    else
        C *= keep;
    C.noalias() += a * A * B;
}

DenseMatrix transposed_product(const ConstDenseBlock& A, const ConstDenseBlock& B) {
    DenseMatrix C(A.cols(), B.cols());
    if (!multiply_by_blas("T", 1, A, B, 0, C))
        C.noalias() = A.transpose() * B;
    return C;
}

} // namespace polydec
