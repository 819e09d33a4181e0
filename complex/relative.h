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

    /// The values on the kept k-cells, from one value per k-cell of the whole complex. Throws
    /// InvalidInput for a wrong number of values.
    Vector restrict(int k, const Vector& whole) const { return restrict_columns(k, whole); }

    /// The same values on the whole complex, 0 on the dropped cells. Throws likewise.
    Vector extend(int k, const Vector& kept) const { return extend_columns(k, kept); }

    /// The same for several forms, one per column.
    template <SeveralColumns Matrix>
    DenseMatrix restrict(int k, const Eigen::MatrixBase<Matrix>& whole) const {
        return restrict_columns(k, whole);
    }
    template <SeveralColumns Matrix>
    DenseMatrix extend(int k, const Eigen::MatrixBase<Matrix>& kept) const {
        return extend_columns(k, kept);
    }

private:
    DenseMatrix restrict_columns(int k, const DenseMatrix& whole) const;
    DenseMatrix extend_columns(int k, const DenseMatrix& kept) const;
};

/// Inclusion of some of `size` cells: extends values on these cells by 0 to all cells.
SparseMatrix inclusion(const std::vector<Index>& cells, Index size);

/// The complex relative to a closed set of cells (with each cell, all its faces). Linear time.
/// Throws InvalidInput, naming the cells, if the set is not closed or does not fit the complex.
RelativeComplex relative_complex(const CellComplex& complex, const CellMarks& dropped);

/// The same, also without an open set of cells (with each cell, all its cofaces). In the dual
/// complex, where faces and cofaces are exchanged, the open set is closed. d d = 0 holds on the
/// remaining cells. Throws like the overload above, and if the second set is not open.
RelativeComplex relative_complex(const CellComplex& complex, const CellMarks& closed,
                                 const CellMarks& open);

/// The complex relative to its boundary.
RelativeComplex relative_to_boundary(const CellComplex& complex);

} // namespace polydec
