// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "dec/stars/star.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace polydec {

/// A linear map between the values of forms: sums of products of derivatives and weights. It can be
/// applied to values, in the time of reading the incidences, or converted to a matrix. Build it
/// once; copies share all large data.
class Operator {
public:
    /// d_k of a complex, size(k+1) x size(k), k = -1..n. Throws InvalidInput for another degree.
    static Operator derivative(const CellComplex& complex, int k);

    /// Multiplies each value by a weight.
    static Operator weights(Vector weights);

    /// A star, and its inverse, which throws InvalidInput like HodgeStar::inverse. The inverse of a
    /// star that is a matrix solves a linear system at each application.
    static Operator star(const HodgeStar& star);
    static Operator inverse_star(const HodgeStar& star);

    /// The zero map. Throws InvalidInput for a negative size.
    static Operator zero(Index rows, Index cols);

    Index rows() const { return rows_; }
    Index cols() const { return cols_; }

    /// Applies the operator. Throws InvalidInput unless there are cols() values.
    Vector operator*(const Vector& values) const;

    /// Throws InvalidInput if a factor is the inverse of a star that is a matrix: the result would
    /// be dense.
    SparseMatrix matrix() const;
    operator SparseMatrix() const { return matrix(); }

    /// The diagonal of the matrix; for A^T W A, with weights on both sides, without the matrix.
    Vector diagonal() const;

    Operator transposed() const;

    /// Throw InvalidInput, naming the shapes, if they do not fit.
    friend Operator operator*(const Operator& A, const Operator& B);
    friend Operator operator+(const Operator& A, const Operator& B);

    friend Operator operator*(double factor, const Operator& A);

    /// The same with results converted from a unit of length, to some power, to input units (see
    /// Cells::unit). Applying it, and its matrix, throw InvalidInput, naming `what`, for overflow
    /// and underflow.
    friend Operator in_input_units(const Operator& A, double unit, double power, std::string what);

private:
    struct Derivative {
        CellComplex complex;
        int k;
        bool transposed;
    };
    using Weights = std::shared_ptr<const Vector>;
    struct Mass { // a star that is no diagonal
        HodgeStar star;
        bool inverted;
    };
    struct Conversion { // multiplies by unit^power
        double unit, power;
        std::string what;
    };
    using Factor = std::variant<Derivative, Weights, Mass, Conversion>;
    using Product = std::vector<Factor>;

    Operator(Index rows, Index cols, std::vector<Product> terms)
        : rows_(rows), cols_(cols), terms_(std::move(terms)) {}

    static bool is_gram(const Product& product, std::size_t i);
    static Vector gram_diagonal(const Product& product, std::size_t i);
    static Vector apply(const Factor& factor, const Vector& x);
    static SparseMatrix matrix(const Factor& factor);
    static SparseMatrix matrix(const Product& product);

    Index rows_, cols_;
    std::vector<Product> terms_;
};

} // namespace polydec
