// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"
#include "solvers/spectra/spectrum.h"

#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// A form on a mesh, with its name in pictures, and a description in words, with units.
struct NamedForm {
    std::string name;
    Cochain form;
    std::string about = {};

    NamedForm(std::string title, Cochain values, std::string words = {})
        : name(std::move(title)), form(std::move(values)), about(std::move(words)) {}
};

/// A page of the merged cells, with selectable tags, volumes and numbers of corners; after
/// intrinsic flips, the cells are drawn over the input's triangles. Throws like draw_cells.
Page draw_page(const Discretization& mesh, std::string title = {});

/// A page of forms on the same cells: all primal or dual, on k-cells of one k. 1-forms also have
/// arrows, if they have a sharp. Throws InvalidInput without forms, and like draw_cells and
/// add_form.
Page draw_page(const Discretization& mesh, const std::vector<NamedForm>& forms,
               std::string title = {});

/// A page of modes, named as in draw_modes, with the table of eigenvalues, radii and residuals, and
/// the certificate. Throws like draw_cells.
Page draw_page(const Discretization& mesh, const Spectrum& spectrum, std::string title = {});

/// A certificate's statement in words.
std::string in_words(const Certificate& certificate);

} // namespace polydec
