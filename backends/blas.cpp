// SPDX-License-Identifier: MIT
#include "backends/blas.h"

#include "backends/linear_solver.h"
#include "base/decompositions.h"
#include "base/errors.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <dlfcn.h>
#include <mutex>
#include <vector>

namespace polydec {

namespace {

// Fortran's dgemm, with the lengths of its two words.
using Gemm = void(const char*, const char*, const int*, const int*, const int*, const double*,
                  const double*, const int*, const double*, const int*, const double*, double*,
                  const int*, std::size_t, std::size_t);

// LAPACK's dsyevd, likewise.
using Syevd = void(const char*, const char*, const int*, double*, const int*, double*, double*,
                   const int*, int*, const int*, int*, std::size_t, std::size_t);

struct FoundBlas {
    const char* (*configuration)() = nullptr;
    const char* (*kernels)() = nullptr;
    int (*threads)() = nullptr;
    Gemm* gemm = nullptr; // null where its integers have 64 bits
    Syevd* syevd = nullptr;
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

FoundBlas found() {
    const std::lock_guard lock(found_mutex);
    return found_blas;
}

/// False where there is none.
bool multiply_by_blas(const char* how, double a, const ConstDenseBlock& A, const ConstDenseBlock& B,
                      double keep, DenseBlock C) {
    Gemm* const gemm = found().gemm;
    if (!gemm || C.size() == 0 || B.rows() == 0 ||
        C.cols() == 1) // packing A costs more than one column
        return false;
    const auto sizes = [](auto... number) { return std::array{static_cast<int>(number)...}; };
    const auto [rows, columns, inner] = sizes(C.rows(), C.cols(), B.rows());
    const auto [stride_A, stride_B, stride_C] =
        sizes(A.outerStride(), B.outerStride(), C.outerStride());
    gemm(how, "N", &rows, &columns, &inner, &a, A.data(), &stride_A, B.data(), &stride_B, &keep,
         C.data(), &stride_C, 1, 1);
    return true;
}

/// False where there is none, or where it fails.
bool pairs_by_lapack(const ConstDenseBlock& A, SymmetricPairs& pairs) {
    Syevd* const syevd = found().syevd;
    const auto n = static_cast<int>(A.rows());
    constexpr int least = 100; // below it Eigen costs nothing and keeps more digits of small values
    constexpr int largest = 30000; // so that the numbers below are ints
    if (!syevd || n < least || n > largest)
        return false;
    pairs.vectors = A;
    pairs.values.resize(n);
    const int numbers = 1 + 6 * n + 2 * n * n, integers = 3 + 5 * n;
    std::vector<double> work(static_cast<std::size_t>(numbers));
    std::vector<int> more_work(static_cast<std::size_t>(integers));
    int outcome = 0;
    syevd("V", "L", &n, pairs.vectors.data(), &n, pairs.values.data(), work.data(), &numbers,
          more_work.data(), &integers, &outcome, 1, 1);
    return outcome == 0;
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
    if (!has_long_integers(found.configuration())) {
        look_up(library, "dgemm_", found.gemm);
        look_up(library, "dsyevd_", found.syevd);
    }
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

SymmetricPairs symmetric_pairs(const ConstDenseBlock& A, const std::string& engine) {
    SymmetricPairs pairs{Vector(0), DenseMatrix(0, 0)};
    if (A.rows() == 0 || pairs_by_lapack(A, pairs))
        return pairs;
    const Eigen::SelfAdjointEigenSolver<DenseMatrix> solver{DenseMatrix(A)};
    if (solver.info() != Eigen::Success)
        throw SolverFailure(engine + ": the dense eigensolver did not converge",
                            SolveReport::failed(engine));
    return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace polydec
