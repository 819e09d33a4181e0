// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdint>

namespace polydec {

/// Number of a cell, vertex or file record; 32 bits, so at most 2^31 - 1 cells of a degree.
using Index = std::int32_t;

using Vector = Eigen::VectorXd;
using DenseMatrix = Eigen::MatrixXd;

/// Operators: real, compressed sparse rows.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>;

/// Signed incidences: entries -1, 0, 1 (2 where a cell is glued to itself on a one-sided surface).
using IncidenceMatrix = Eigen::SparseMatrix<std::int8_t, Eigen::RowMajor, Index>;

/// Coordinates: row i is the position of vertex i.
using Points = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Vertex lists: row i holds the vertex numbers of simplex i.
using Simplices = Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

} // namespace polydec
