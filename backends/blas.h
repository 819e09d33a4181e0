// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <optional>
#include <string>

/// The BLAS behind the engines, where it is OpenBLAS.
namespace polydec {

/// What it says of itself.
struct Blas {
    std::string name = {};    ///< with its version
    std::string kernels = {}; ///< the processor that its code in use was written for
    int threads = 1;
    int integer_bits = 32;
};

/// To be called before an OpenBLAS is loaded: has it take one thread, and the kernels that suit
/// this processor, which those versions that are older than it do not know and give the slowest
/// ones. What the environment says (OPENBLAS_NUM_THREADS, OPENBLAS_CORETYPE) is left as it is.
void prepare_blas();

/// Looks for OpenBLAS behind a shared library that dlopen() has given, unless it is known already.
void find_blas(void* library);

/// What was found so far, also where the program was linked with it; nullopt: none, or another.
std::optional<Blas> loaded_blas();

using DenseBlock = Eigen::Ref<DenseMatrix>;
using ConstDenseBlock = Eigen::Ref<const DenseMatrix>;

/// C becomes keep C + a A B, by that BLAS, else by Eigen, which is compiled for older processors.
void add_product(double a, const ConstDenseBlock& A, const ConstDenseBlock& B, double keep,
                 DenseBlock C);

/// A^T B, likewise.
DenseMatrix transposed_product(const ConstDenseBlock& A, const ConstDenseBlock& B);

/// All eigenpairs of a symmetric matrix, of which the lower triangle is read.
struct SymmetricPairs {
    Vector values;       ///< ascending
    DenseMatrix vectors; ///< orthonormal columns
};

/// By divide and conquer of the LAPACK in that BLAS (Cuppen 1981), else by Eigen, which takes four
/// to eight times as long. Throws SolverFailure, naming the engine, if the iteration does not
/// converge.
SymmetricPairs symmetric_pairs(const ConstDenseBlock& A, const std::string& engine);

} // namespace polydec
