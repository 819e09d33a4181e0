// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/boundary_conditions.h"
#include "dec/forms/cells.h"
#include "dec/forms/cochain.h"
#include "dec/forms/operator.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

/// The forms of one side and degree on some cells that obey conditions on the boundary: the space
/// that an equation is posed in. A form has a value for each cell; the conditions fix some of them,
/// by data or at 0, and the others are free. A handle on what never changes, made when it is first
/// asked for: copies share it.
///
/// Primal forms are fixed on the essential facets and their faces. The star takes a dual form's
/// values on the boundary to what flows out of a primal one, so dual forms are fixed on the natural
/// facets and their faces; and where an essential facet has no dual (see
/// Cells::boundary_facets_without_dual) on it, on the n-cell beside it and on what has no other
/// cofaces: the duals of these cells lie on the boundary. Primal n-forms are the stars of dual
/// 0-forms, which do without the duals of boundary facets. Robin's condition fixes nothing.
///
/// All is measured in the unit of the cells; conditions are given in that of the input.
/// Source: Arnold, Falk, Winther 2006, sec. 2 and 7.
class FormSpace {
public:
    /// Throws InvalidInput if there are no forms of that degree; if there are conditions but not
    /// one for each facet; for dual 0-forms where three n-cells or more meet, naming the facet:
    /// they have no difference along its dual; for Robin's condition like robin_coefficients.
    FormSpace(const Cells& cells, Side side, int degree, const BoundaryConditions& conditions);

    /// Under the conditions that hold where nothing is done about the boundary (see
    /// built_in_conditions).
    FormSpace(const Cells& cells, Side side, int degree);

    /// The forms that vanish on a closed set of cells alone (with each cell, all its faces), with
    /// an empty one all of them. Throws InvalidInput like relative_complex.
    static FormSpace vanishing_on(const Cells& cells, Side side, int degree,
                                  const CellMarks& closed = {});

    Cells cells() const;
    Side side() const;
    int degree() const;
    int cell_degree() const; ///< k, of the cells that carry the values: degree or n - degree
    const BoundaryConditions& conditions() const&;
    BoundaryConditions conditions() && { return conditions(); }

    /// What the conditions mean, like polydec::in_words.
    std::string in_words() const;

    /// A form of the space by a value for each cell. Throws like check.
    Cochain form(Vector values) const;

    /// Throws InvalidInput, naming both, for a form of another side, degree or number of values,
    /// and for values that are not finite.
    void check(const Cochain& form) const;

    /// Throws InvalidInput, naming what cannot have it, where Robin's condition holds.
    void refuse_robin(const char* what) const;

    /// Marks the cells, in every degree, at which essential data fix primal forms, or those whose
    /// stars dual forms are: not those of facets without dual.
    const CellMarks& fixed() const&;
    CellMarks fixed() && { return fixed(); }

    /// Marks the cells without free values: these, and those of facets without dual.
    const CellMarks& left_out() const&;
    CellMarks left_out() && { return left_out(); }

    /// The cells of all degrees with free values, and their numbers: the whole complex where
    /// nothing is fixed.
    const RelativeComplex& relative() const&;
    RelativeComplex relative() && { return relative(); }

    /// These cells with their stars; Robin's layer is part of the star below dual forms, which is a
    /// matrix then. Operators, homology and whatever takes cells act on the free values here.
    Cells inside() const;

    const std::vector<Index>& free() const& { return relative().cells[cell_degree()]; }
    std::vector<Index> free() && { return free(); }
    Index size() const { return static_cast<Index>(free().size()); } ///< of the space

    /// From values of all cells to the free ones, and back with 0 for the others; of several forms
    /// a column each. Throw InvalidInput for another number of values.
    template <class Values>
    auto restrict(const Values& all) const {
        return relative().restrict(cell_degree(), all);
    }
    template <class Values>
    auto extend(const Values& values) const {
        return relative().extend(cell_degree(), values);
    }

    /// What Robin's condition adds, for all cells: to star Delta of primal forms, and to the star
    /// of (k-1)-cells below dual ones, which it holds back as by a layer. Boundary stars, 0 off its
    /// facets; 0 x 0 where it adds nothing. Throw like Cells::boundary_star.
    const SparseMatrix& robin_weights() const&;
    SparseMatrix robin_weights() && { return robin_weights(); }
    const SparseMatrix& robin_layer() const&;
    SparseMatrix robin_layer() && { return robin_layer(); }

    /// The first, of the free cells alone; empty likewise.
    SparseMatrix free_robin_weights() const;

    /// star Delta of primal forms, or of those whose stars dual ones are, with Robin's weights, on
    /// the free values.
    Operator stiffness() const;

private:
    struct Parts;
    explicit FormSpace(std::shared_ptr<const Parts> parts);
    SparseMatrix free_part(int k, const SparseMatrix& of_all) const;

    std::shared_ptr<const Parts> parts_;
};

} // namespace polydec
