// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"
#include "io/pictures/draw_fields.h"
#include "solvers/spectra/spectrum.h"

#include <string>
#include <vector>

namespace polydec {

/// A page of the merged cells, with selectable tags, volumes and numbers of corners; after
/// intrinsic flips, the cells are drawn over the input's triangles. Throws like draw_cells.
Page draw_page(const Discretization& mesh, std::string title = {});

/// A page of any number of fields together, which shows the first one first. Vectors have arrows,
/// and so have 1-forms and (n-1)-forms, see add_arrows. Throws InvalidInput without fields, and
/// like draw_fields.
Page draw_page(const Discretization& mesh, const std::vector<NamedForm>& fields,
               std::string title = {});

/// The same fields at another time, for the steps of a page that draw_page made of fields with
/// these names and of these kinds. Throws like draw_fields.
PageStep draw_step(const Page& page, std::string time, const std::vector<NamedForm>& fields);

/// A page of modes, named as in draw_modes, with the table of eigenvalues, radii and residuals, and
/// the certificate. Throws like draw_cells.
Page draw_page(const Discretization& mesh, const Spectrum& spectrum, std::string title = {});

/// A certificate's statement in words.
std::string in_words(const Certificate& certificate);

} // namespace polydec
