// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <concepts>
#include <initializer_list>
#include <utility>

namespace polydec {

namespace detail {

[[noreturn]] void refuse_as_column(Eigen::Index rows, Eigen::Index columns);

template <class Other>
inline constexpr bool is_vector = Eigen::internal::traits<Other>::ColsAtCompileTime == 1 ||
                                  Eigen::internal::traits<Other>::RowsAtCompileTime == 1;

template <class Other>
concept MaybeVector =
    is_vector<Other> || Eigen::internal::traits<Other>::ColsAtCompileTime == Eigen::Dynamic;

} // namespace detail

/// A column of numbers: Eigen's VectorX, and used like it. But where VectorX silently keeps the
/// first column of a matrix, this type accepts only vectors. A type with several columns does not
/// compile; a matrix with a dynamic number of columns throws InvalidInput, naming its shape, unless
/// it has one.
template <class Scalar>
class Column : public Eigen::VectorX<Scalar> {
    using Plain = Eigen::VectorX<Scalar>;

public:
    Column() = default;
    explicit Column(Eigen::Index size) : Plain(size) {}

    /// Column{{1, 2, 3}} or Column{{1}, {2}, {3}}, as in Eigen.
    Column(std::initializer_list<std::initializer_list<Scalar>> numbers)
        : Column(upright(numbers)) {}

    template <std::same_as<Plain> Vector>
    Column(Vector&& vector) noexcept : Plain(std::move(vector)) {}

    template <detail::MaybeVector Other>
    Column(const Eigen::EigenBase<Other>& other) : Plain(checked(other)) {}

    template <std::same_as<Plain> Vector>
    Column& operator=(Vector&& vector) noexcept {
        Plain::operator=(std::move(vector));
        return *this;
    }

    template <detail::MaybeVector Other>
    Column& operator=(const Eigen::EigenBase<Other>& other) {
        Plain::operator=(checked(other));
        return *this;
    }

private:
    static Eigen::MatrixX<Scalar>
    upright(std::initializer_list<std::initializer_list<Scalar>> numbers) {
        Eigen::MatrixX<Scalar> matrix(numbers);
        if (numbers.size() == 1)
            matrix.transposeInPlace();
        return matrix;
    }

    template <class Other>
    static const Other& checked(const Eigen::EigenBase<Other>& other) {
        if constexpr (!detail::is_vector<Other>)
            if (other.cols() != 1)
                detail::refuse_as_column(other.rows(), other.cols());
        return other.derived();
    }
};

using Vector = Column<double>;
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

/// Makes Map<Vector> and Ref<Vector> behave as for VectorX.
template <class Scalar>
struct Eigen::internal::traits<polydec::Column<Scalar>> : traits<Eigen::VectorX<Scalar>> {};
template <class Scalar>
struct Eigen::internal::evaluator<polydec::Column<Scalar>> : evaluator<Eigen::VectorX<Scalar>> {
    using evaluator<Eigen::VectorX<Scalar>>::evaluator;
};
