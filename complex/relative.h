// SPDX-License-Identifier: MIT
#pragma once

#include "complex/components.h"

namespace polydec {

/// A complex relative to some of its cells. These are dropped in every degree; the others keep
/// their order and orientation. Its cochains are the cochains of the whole complex that vanish on
/// the dropped cells, like forms under an essential boundary condition.
struct RelativeComplex {
    CellComplex complex;
    std::vector<std::vector<Index>> cells; ///< cells[k]: the kept k-cells' numbers in the whole
    std::vector<Index> whole_sizes;        ///< numbers of cells of the whole

    /// One form, or several as columns.
    template <class Values>
    using Forms = std::conditional_t<Values::ColsAtCompileTime == 1, Vector, DenseMatrix>;

    /// The values on the kept k-cells, from one value per k-cell of the whole complex. Throws
    /// InvalidInput for a wrong number of values.
    template <class Values>
    Forms<Values> restrict(int k, const Eigen::MatrixBase<Values>& whole) const {
        return restrict_columns(k, whole);
    }

    /// The same values on the whole complex, 0 on the dropped cells. Throws likewise.
    template <class Values>
    Forms<Values> extend(int k, const Eigen::MatrixBase<Values>& kept) const {
        return extend_columns(k, kept);
    }

    /// The rows and columns of the kept k-cells.
    SparseMatrix block(int k, const SparseMatrix& of_whole) const;

private:
    DenseMatrix restrict_columns(int k, const DenseMatrix& whole) const;
    DenseMatrix extend_columns(int k, const DenseMatrix& kept) const;
};

/// Inclusion of some of `size` cells: extends values on these cells by 0 to all cells.
SparseMatrix inclusion(const std::vector<Index>& cells, Index size);

/// The complex relative to a closed set of cells (with each cell, all its faces), and without an
/// open set (with each cell, all its cofaces), if one is given. In the dual complex, where faces
/// and cofaces are exchanged, the open set is closed. d d = 0 holds on the remaining cells. Linear
/// time. Throws InvalidInput, naming the cells, if the sets are not closed and open or do not fit
/// the complex.
RelativeComplex relative_complex(const CellComplex& complex, const CellMarks& closed,
                                 const CellMarks& open = {});

/// The complex relative to its boundary.
RelativeComplex relative_to_boundary(const CellComplex& complex);

} // namespace polydec
