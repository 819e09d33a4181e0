// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// What a 1-form on a surface holds of a vector field: circulations along cells, or fluxes through
/// them. In space 1-forms hold circulations and 2-forms fluxes.
enum class Proxy { automatic, flux };

/// Whether a form has proxy vectors: 1-forms and (n-1)-forms for n > 1.
bool has_proxy(const Discretization& mesh, const Cochain& form);

/// Proxy vectors of a form at the merged n-cells: the field whose circulations a 1-form holds, or
/// whose fluxes an (n-1)-form holds, by sharp_pd or flux_sharp; of a dual form after the inverse
/// star. Attach them to cell_centroids. One row per n-cell, N columns; units: values over
/// length^degree. No rows without has_proxy. Throws InvalidInput like these functions.
DenseMatrix vectors_at_cells(const Discretization& mesh, const Cochain& form,
                             Proxy proxy = Proxy::automatic);

/// The same at the vertices, one row for each: by sharp_pp for circulations of primal forms on
/// meshes that have it, else means_at_vertices of the vectors at cells.
DenseMatrix vectors_at_vertices(const Discretization& mesh, const Cochain& form,
                                Proxy proxy = Proxy::automatic);

/// Means by volume of rows at the n-cells around each vertex. Exact for constants.
DenseMatrix means_at_vertices(const Discretization& mesh, const DenseMatrix& at_cells);

} // namespace polydec
