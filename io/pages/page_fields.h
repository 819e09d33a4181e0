// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "io/pages/page.h"
#include "io/pages/page_faces.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace polydec {

/// A field of a page, with the place of its values, and of its array in a step.
struct PageField {
    const VtuArray* array;
    std::string place; ///< vertex, edge, face or cell
    std::vector<VtuArray> VtuData::*list;
    std::size_t number;

    /// The array at a step; of a page without steps the only one.
    const VtuArray& at(const Page& page, std::size_t step) const {
        return page.steps.empty() ? *array : (page.steps[step].*list)[number];
    }
};

/// One row for each entry of an array.
DenseMatrix rows_of(const VtuArray& array);

/// What colors show of each entry: its number, of vectors the length. Throws
/// InvalidInput if that overflows.
Vector shown_numbers(const VtuArray& array);

/// The smallest and largest value that colors show, of vectors by their lengths: in all arrays, or
/// of a field at all steps. Zeros without values.
std::array<double, 2> range_of(const std::vector<VtuArray>& arrays);
std::array<double, 2> range_of(const Page& page, const PageField& field);

/// The unit in a description, "in units of length^2"; or empty. If the page names the unit of
/// length, by its name.
std::string unit_in(const std::string& about, const PageText& text);

/// All fields of a page that shows cells of a dimension: those with values at vertices first, those
/// on edges and faces of its cell complex last. Throws InvalidInput, naming the field, for values
/// on edges or faces without a complex or of a wrong number; and, naming the step, if steps have
/// other fields or vectors.
std::vector<PageField> page_fields(const Page& page, int dimension, const CellComplex* complex);

/// Whether the arrows of a page have other vectors at each step.
bool has_moving_arrows(const Page& page);

/// The lengths of the vectors of arrows at every step, named |field|: one for each of so many cells
/// that are drawn. Empty unless the field has values on edges or faces, and each cell has a vector.
std::vector<VtuArray> strengths(const Page& page, const std::vector<PageField>& fields,
                                const PageArrows& arrows, std::ptrdiff_t cells);

/// What colors show first.
struct ShownField {
    const PageField* field = nullptr; ///< null if the page shows no field
    /// The lengths of its vectors in cells, if they have some, are shown instead of its values. At
    /// every step, like the vectors.
    std::vector<VtuArray> strengths = {};
    std::vector<Points> vectors = {};
    std::string place = {}; ///< of what is shown, as in PageField
    std::size_t step = 0;   ///< the first one where it has its largest range, but for rounding

    const VtuArray& at(const Page& page, std::size_t at_step) const {
        return strengths.empty() ? field->at(page, at_step) : strengths[at_step];
    }
    bool has_vectors() const { return !strengths.empty() || field->array->components > 1; }
};

/// The field that the page names; if it and some that follow are constant, the first one that is
/// not. `cells` are drawn.
ShownField shown_field(const Page& page, const std::vector<PageField>& fields,
                       std::ptrdiff_t cells);

} // namespace polydec
