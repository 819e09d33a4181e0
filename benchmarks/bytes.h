// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "dec/merging/merge.h"
#include "meshes/mesh.h"

#include <vector>

namespace polydec::benchmarks {

/// Bytes that the entries of these take: what must be read or written at least once.

template <typename Scalar, int Rows, int Columns, int Options>
double bytes(const Eigen::Matrix<Scalar, Rows, Columns, Options>& values) {
    return static_cast<double>(values.size()) * sizeof(Scalar);
}

template <typename Scalar>
double bytes(const Eigen::SparseMatrix<Scalar, Eigen::RowMajor, Index>& A) {
    return static_cast<double>(A.nonZeros()) * (sizeof(Scalar) + sizeof(Index)) +
           static_cast<double>(A.rows() + 1) * sizeof(Index);
}

inline double bytes(const Incidences& incidences) {
    return static_cast<double>(incidences.size()) * sizeof(Index);
}
double bytes(const CellComplex& complex);
double bytes(const SimplicialComplex& complex);
double bytes(const CellVolumes& volumes);
double bytes(const Mesh& mesh);
double bytes(const CosphericalMerging& merged);
double bytes(const Discretization& discretization);
inline double bytes(const Cochain& form) {
    return bytes(form.values);
}
inline double bytes(const std::vector<Index>& values) {
    return static_cast<double>(values.size()) * sizeof(Index);
}

template <typename Part>
double bytes(const std::vector<Part>& parts) {
    double sum = 0;
    for (const auto& part : parts)
        sum += bytes(part);
    return sum;
}

} // namespace polydec::benchmarks
