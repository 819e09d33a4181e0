// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/inertia.h"
#include "shape/barycentric.h"
#include "shape/gluing.h"
#include "shape/measured_simplex.h"

#include <functional>
#include <memory>
#include <vector>

namespace polydec {

/// The contribution of one simplex to a family of quadratic forms Q(s), in the unknowns of the
/// simplex: the positive semidefinite `parts`, with factors that depend on s, and `robin`.
struct LocalForms {
    std::vector<LongMatrix> parts;
    LongMatrix robin; ///< 0 x 0: none
    LongMatrix cell;  ///< a column, see FormFamily; 0 x 0: no unknown of the cell
    double mass = 0;  ///< of the cell
    double reach = 0; ///< C^2 rho / kappa: factors take s reach
    double error = 0; ///< of these long double matrices, relative to their diagonal
};

/// A symmetric matrix for an inertia count, and a bound on its error.
struct CountedMatrix {
    std::shared_ptr<const SparseMatrix> matrix;
    Doubt doubt;
    Index eliminated = 0; ///< negative eigenvalues of the eliminated block
};

/// Quadratic forms Q(s) = sum over simplices of sum_p factor_p(s, s reach) P_p on unknowns shared
/// by simplices. Q(s) decreases as s grows; its number of negative eigenvalues bounds the number of
/// eigenvalues of a shape below s. With an unknown u of each cell, the parts apply to y = m - u
/// cell for the other unknowns m, so that constants are in the kernel, and - s mass u^2 is added; u
/// is eliminated.
class FormFamily {
public:
    using Factors = std::function<std::vector<double>(double s, double s_reach)>;

    FormFamily(const Shape& shape, Unknowns unknowns, Factors factors,
               const std::function<LocalForms(Index simplex)>& local);

    Index size() const { return unknowns_.count; }
    const Unknowns& unknowns() const { return unknowns_; }
    int domain_dimension() const { return domain_dimension_; } ///< of the simplices

    /// The forms are bounds for s below this limit; infinite if there is no limit.
    double limit() const { return limit_; }

    /// The simplices with a limit below s.
    std::vector<Index> beyond(double s) const;

    /// Q(s), in time linear in its size.
    CountedMatrix at(double s) const { return sum(factors_, s); }

    /// The same with other factors.
    CountedMatrix sum(const Factors& factors, double s) const;

    /// The sum of parts with these factors in each simplex, summed over the columns of X. The
    /// unknowns of cells make Q(s) stationary.
    Vector local_values(const Factors& factors, double s, const DenseMatrix& X) const;

    /// Bounds the rounding of at(t) in a simplex, as a form: factors of the squares of its
    /// unknowns.
    Vector doubt(Index simplex, double t) const;

    /// A lower bound of Q(s) - Q(t) of one simplex for s < t, less this doubt: `form` for
    /// y = m - u cell, and `mass` for u.
    void drop(Index simplex, double s, double t, const Vector& doubt, DenseMatrix& form,
              double& mass) const;

    Index simplices() const { return static_cast<Index>(reach_.size()); }
    Index width() const { return width_; }               ///< unknowns of a simplex
    const Vector& summands() const { return summands_; } ///< simplices of each unknown

    /// The rows of X of the unknowns of a simplex, and the transposed map.
    void restrict_to(Index simplex, const DenseMatrix& X, DenseMatrix& Y) const;
    void add_to(DenseMatrix& X, Index simplex, const DenseMatrix& Y) const;

    /// LocalForms::cell; no entries without unknowns of cells.
    const Vector& cell(Index simplex) const;

    /// Where Q(s) is stationary in the unknown of a cell, it is weights . m. Q(s) has pivot times
    /// its square.
    struct Elimination {
        Vector weights;
        double pivot;
    };
    Elimination elimination(Index simplex, double s) const;

private:
    struct Cell {
        Vector column;
        double mass;
    };

    Eigen::Map<const DenseMatrix> part(Index simplex, Index p) const {
        const std::size_t entries = std::size_t(width_) * width_;
        return {values_.data() + entries * (std::size_t(parts_) * simplex + p), width_, width_};
    }
    Index unknown(Index simplex, Index i) const {
        return unknowns_.of_simplices[std::size_t(width_) * simplex + i];
    }
    int sign(Index simplex, Index i) const {
        return unknowns_.signs[std::size_t(width_) * simplex + i];
    }
    DenseMatrix combined(const Factors& factors, Index simplex, double s) const;
    void add_local(const Factors& factors, Index simplex, double s, DenseMatrix& Q, Vector& sizes,
                   double& error) const;
    void make_pattern();

    int domain_dimension_;
    Unknowns unknowns_;
    Factors factors_;
    std::vector<double> values_; // of parts, simplex by simplex
    std::vector<Cell> cells_;    // empty: no unknowns of cells
    std::vector<double> reach_, errors_;
    Index width_, parts_ = 0;
    std::vector<DenseMatrix> robin_; // of each simplex; 0 x 0: none
    double limit_;
    SparseMatrix pattern_;
    std::vector<Index> slots_; // of local entries in the values of the pattern, or -1
    Vector summands_;          // of each unknown
    double most_summands_ = 0;
};

} // namespace polydec
