// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/vtu.h"
#include "solvers/spectra/spectrum.h"

#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// A field in a picture, with its name there, and a description in words, with units: a form, or
/// vectors. Vectors are rows, of N numbers or of three, one for each value of a primal 0-form
/// (vertices) or of a dual 0-form (n-cells).
struct NamedForm {
    std::string name;
    Cochain form; ///< for vectors: side and degree 0 alone
    std::string about = {};
    DenseMatrix vectors = {};

    NamedForm(std::string title, Cochain values, std::string words = {})
        : name(std::move(title)), form(std::move(values)), about(std::move(words)) {}
    NamedForm(std::string title, Side side, DenseMatrix rows, std::string words = {})
        : name(std::move(title)),
          form{side, 0, {}},
          about(std::move(words)),
          vectors(std::move(rows)) {}
};

/// The degree of the cells in a picture of these fields: their common one, or, if they have
/// several, the dimension n.
int drawn_degree(const Discretization& mesh, const std::vector<NamedForm>& fields);

/// Adds a field to a picture with cells of degree k: values at vertices as point data, values on
/// k-cells as cell data, and values on other cells as field data, with their degree; see
/// drawn_values. If `about` is empty, the array's description gives side and degree. Throws
/// InvalidInput, naming the field, for a wrong number of rows, and for a form of another mesh.
void add_field(VtuData& picture, const Discretization& mesh, int k, const NamedForm& field);

/// Adds all fields, of their drawn_degree, each form followed by its add_vectors.
void add_fields(VtuData& picture, const Discretization& mesh, const std::vector<NamedForm>& fields);

/// The picture of any number of fields together: forms of all degrees on both sides, and vectors.
/// Throws like draw_cells and add_field.
VtuGrid draw_fields(const Discretization& mesh, const std::vector<NamedForm>& fields);

/// The modes of a spectrum as fields mode_0, mode_1, .., described by their eigenvalues. Their
/// arbitrary signs make the largest value positive; of several, the first one.
std::vector<NamedForm> shown_modes(const Spectrum& spectrum);

/// Adds the certificate of a spectrum to the field data: eigenvalues, their radii and residuals,
/// the certificate by shift, below_shift, returned_below_shift and complete (1 or 0), and degree
/// and is_dual (1 or 0) of the forms.
void add_spectrum(VtuData& picture, const Spectrum& spectrum);

/// The modes of a spectrum on their merged cells, as arrays mode_0, mode_1, ..: point data for
/// forms on vertices, else cell data; with add_vectors and add_spectrum. Throws like draw_cells.
VtuGrid draw_modes(const Discretization& discretization, const Spectrum& spectrum);

} // namespace polydec
