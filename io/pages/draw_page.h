// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"
#include "solvers/spectra/spectrum.h"

#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// A form on a mesh, by the name that it has in pictures, and what it is in words, with units.
struct NamedForm {
    std::string name;
    Cochain form;
    std::string about = {};

    NamedForm(std::string title, Cochain values, std::string words = {})
        : name(std::move(title)), form(std::move(values)), about(std::move(words)) {}
};

/// A page of the merged cells, with their tags, volumes and numbers of corners to be chosen; after
/// intrinsic flips as they lie over the input's triangles. Throws like draw_cells.
Page draw_page(const Discretization& mesh, std::string title = {});

/// A page of forms that live on the same cells: all primal or dual, on k-cells of one k. 1-forms
/// have arrows too, where a sharp gives them. Throws InvalidInput for no form, and like draw_cells
/// and add_form.
Page draw_page(const Discretization& mesh, const std::vector<NamedForm>& forms,
               std::string title = {});

/// A page of modes as draw_modes names them, with the table of eigenvalues, radii and residuals,
/// and the certificate. Throws like draw_cells.
Page draw_page(const Discretization& mesh, const Spectrum& spectrum, std::string title = {});

/// What a certificate proves, in words.
std::string in_words(const Certificate& certificate);

} // namespace polydec
