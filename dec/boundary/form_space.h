// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/shared.h"
#include "dec/boundary/boundary_conditions.h"
#include "dec/forms/cells.h"
#include "dec/forms/cochain.h"
#include "dec/forms/operator.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// The forms of one side and degree on some cells that obey boundary conditions: the space in which
/// an equation is posed. A form has one value per cell; the conditions fix some values, by data or
/// at 0, and the others are free. An immutable handle, computed on first use and shared by copies.
///
/// Primal forms are fixed on the essential facets and their faces. On the boundary, the star maps
/// values of a dual form to fluxes of a primal form, so dual forms are fixed on the natural facets
/// and their faces. An essential facet may have no dual (see Cells::boundary_facets_without_dual).
/// Then dual forms are also fixed on this facet, on the n-cell beside it and on cells with no other
/// cofaces, because their duals lie on the boundary. Primal n-forms are the stars of dual 0-forms,
/// which need no duals of boundary facets. Robin's condition fixes nothing.
///
/// Everything is measured in the unit of the cells; conditions are given in the unit of the input.
/// Source: Arnold, Falk, Winther 2006, sec. 2 and 7.
class FormSpace {
public:
    /// Throws InvalidInput if there are no forms of that degree; unless conditions are uniform or
    /// one per facet; for dual 0-forms, naming the facet, where three or more n-cells meet: their
    /// difference along its dual is undefined; for Robin's condition on n-forms, which have no
    /// trace, and otherwise like robin_coefficients.
    FormSpace(const Cells& cells, Side side, int degree, const BoundaryConditions& conditions);

    /// The space under the default conditions (see built_in_conditions).
    FormSpace(const Cells& cells, Side side, int degree);

    /// The forms that vanish on a closed set of cells (with each cell, all its faces); all forms if
    /// the set is empty. Throws InvalidInput like relative_complex.
    static FormSpace vanishing_on(const Cells& cells, Side side, int degree,
                                  const CellMarks& closed = {});

    Cells cells() const { return parts_->cells; }
    Side side() const { return parts_->side; }
    int degree() const { return parts_->degree; }
    /// Degree k of the cells that carry the values: degree or n - degree.
    int cell_degree() const { return parts_->k; }
    const BoundaryConditions& conditions() const& { return parts_->conditions; }
    BoundaryConditions conditions() && { return conditions(); }

    /// The conditions in words, like polydec::in_words.
    std::string in_words(const BoundaryData& data = {}) const;

    /// Throws InvalidInput, like polydec::require_use, if data on the boundary apply nowhere.
    void require_use(const NamedData& data) const;

    /// The form of the space with these values, one per cell. Throws like check.
    Cochain form(Vector values) const;

    /// Throws InvalidInput, naming both, for a form of another side, degree or number of values,
    /// and for values that are not finite.
    void check(const Cochain& form) const;

    /// Throws InvalidInput, naming `what` cannot have it, if Robin's condition holds anywhere.
    void refuse_robin(const char* what) const;

    /// Marks the cells, in every degree, at which essential data fix the primal forms, or the
    /// primal forms whose stars the dual forms are. Facets without dual add no marks here.
    const CellMarks& fixed() const& { return parts_->fixed; }
    CellMarks fixed() && { return fixed(); }

    /// Marks the cells without free values: fixed() and the cells fixed because a facet has no
    /// dual.
    const CellMarks& left_out() const&;
    CellMarks left_out() && { return left_out(); }

    /// The cells of all degrees with free values, and their numbers; the whole complex if nothing
    /// is fixed.
    const RelativeComplex& relative() const&;
    RelativeComplex relative() && { return relative(); }

    /// These cells with their stars. Operators, homology and all functions of cells act on the free
    /// values here. For dual forms Robin's layer is added to the star below, which is then a
    /// matrix; throws InvalidInput, naming the cells, if its diagonal is not positive.
    Cells inside() const;

    const std::vector<Index>& free() const& { return relative().cells[cell_degree()]; }
    std::vector<Index> free() && { return free(); }
    Index size() const { return static_cast<Index>(free().size()); } ///< of the space

    /// Restricts values on all cells to the free cells, and extends them back by 0; several forms
    /// are columns. Throw InvalidInput for a wrong number of values.
    template <class Values>
    auto restrict(const Values& all) const {
        return relative().restrict(cell_degree(), all);
    }
    template <class Values>
    auto extend(const Values& values) const {
        return relative().extend(cell_degree(), values);
    }

    /// Robin's terms for all cells: the weights are added to star Delta of primal forms, the layer
    /// to the star of the (k-1)-cells below dual forms, which it damps. Boundary stars, 0 off
    /// Robin's facets; 0 x 0 if they add nothing. Throw like Cells::boundary_star.
    const SparseMatrix& robin_weights() const&;
    SparseMatrix robin_weights() && { return robin_weights(); }
    const SparseMatrix& robin_layer() const&;
    SparseMatrix robin_layer() && { return robin_layer(); }

    /// robin_weights() restricted to the free cells; 0 x 0 likewise.
    SparseMatrix free_robin_weights() const;

    /// star Delta of primal forms (for a dual space: of the primal forms whose stars its forms
    /// are), with Robin's weights, on the free values; in cells().unit().
    Operator stiffness() const;

private:
    struct Parts {
        Cells cells;
        Side side;
        int degree, k;
        BoundaryConditions conditions;
        CellMarks fixed;
        Vector robin = {};                   // coefficients at facets
        std::vector<bool> without_dual = {}; // facets where values are given, if they matter
        Lazy<CellMarks> on_boundary = {}, left_out = {};
        Lazy<RelativeComplex> relative = {};
        Lazy<SparseMatrix> weights = {}, layer = {};
        Lazy<Cells> inside = {};
    };
    explicit FormSpace(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

    const CellMarks& on_the_boundary() const;

    Shared<const Parts> parts_;
};

} // namespace polydec
