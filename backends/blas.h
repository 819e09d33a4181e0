// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <optional>
#include <string>

/// The BLAS used by the engines, if it is OpenBLAS.
namespace polydec {

/// Its self-description.
struct Blas {
    std::string name = {};    ///< with version
    std::string kernels = {}; ///< the processor type of the kernels in use
    int threads = 1;
    int integer_bits = 32;
};

/// Call before an OpenBLAS is loaded. Selects one thread and the kernels that suit this processor;
/// versions older than the processor would choose the slowest ones. Leaves environment settings
/// (OPENBLAS_NUM_THREADS, OPENBLAS_CORETYPE) unchanged.
void prepare_blas();

/// Looks for OpenBLAS behind a shared library from dlopen(), unless it is already known.
void find_blas(void* library);

/// The OpenBLAS found so far, also if linked to the program; nullopt: none, or another BLAS.
std::optional<Blas> loaded_blas();

using DenseBlock = Eigen::Ref<DenseMatrix>;
using ConstDenseBlock = Eigen::Ref<const DenseMatrix>;

/// C = keep C + a A B, by this BLAS, else by Eigen, which is compiled for older processors.
void add_product(double a, const ConstDenseBlock& A, const ConstDenseBlock& B, double keep,
                 DenseBlock C);

/// A^T B, by the same means.
DenseMatrix transposed_product(const ConstDenseBlock& A, const ConstDenseBlock& B);

/// All eigenpairs of a symmetric matrix; reads only its lower triangle.
struct SymmetricPairs {
    Vector values;       ///< ascending
    DenseMatrix vectors; ///< orthonormal columns
};

/// Uses divide and conquer from this BLAS's LAPACK (Cuppen 1981), else Eigen, which takes four to
/// eight times as long. Throws SolverFailure, naming the engine, if the iteration does not
/// converge.
SymmetricPairs symmetric_pairs(const ConstDenseBlock& A, const std::string& engine);

} // namespace polydec
