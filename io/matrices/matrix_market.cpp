// SPDX-License-Identifier: MIT
#include "io/matrices/matrix_market.h"

#include "io/number_lines.h"
#include "io/source_file.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

void check_finite(double value, const std::filesystem::path& path, Eigen::Index row,
                  Eigen::Index column) {
    if (!std::isfinite(value))
        refuse_writing(path, fmt::format("entry ({}, {}), counted from 0, is NaN or infinite; "
                                         "correct the operator that it comes from",
                                         row, column));
}

template <typename Matrix>
void write_coordinates(const std::filesystem::path& path, const Matrix& matrix, const char* field) {
    NumberLines lines(path);
    lines.text(fmt::format("%%MatrixMarket matrix coordinate {} general\n{} {} {}\n", field,
                           matrix.rows(), matrix.cols(), matrix.nonZeros()));
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        for (typename Matrix::InnerIterator entry(matrix, row); entry; ++entry) {
            check_finite(entry.value(), path, row, entry.col());
            lines.line(row + 1, entry.col() + 1, +entry.value());
        }
    lines.commit();
}

} // namespace

void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix) {
    write_coordinates(path, matrix, "real");
}

void write_matrix_market(const std::filesystem::path& path, const IncidenceMatrix& matrix) {
    write_coordinates(path, matrix, "integer");
}

void write_matrix_market(const std::filesystem::path& path,
                         const Eigen::Ref<const DenseMatrix>& matrix) {
    NumberLines lines(path);
    lines.text(fmt::format("%%MatrixMarket matrix array real general\n{} {}\n", matrix.rows(),
                           matrix.cols()));
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
        for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
            check_finite(matrix(row, column), path, row, column);
            lines.line(matrix(row, column));
        }
    lines.commit();
}

} // namespace polydec
