// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "dec/fields/flat_and_sharp.h"
#include "dec/fields/seams.h"
#include "dec/stars/star.h"

namespace polydec {

namespace {

/// Whether the field is along the cells of the form's side, rather than through them.
bool is_along(const Cochain& form, Proxy proxy) {
    return form.degree == 1 && proxy != Proxy::flux;
}

/// The primal form whose star a dual form is.
Cochain primal_of(const Discretization& mesh, const Cochain& form) {
    const int k = mesh.dimension() - form.degree;
    if (form.side == Side::primal)
        return form;
    const HodgeStar star = mesh.geometric_star(k).in_input_units(mesh.unit());
    return {Side::primal, k, star.solve(form.values)};
}

} // namespace

bool has_proxy(const Discretization& mesh, const Cochain& form) {
    const int n = mesh.dimension();
    return n > 1 && (form.degree == 1 || form.degree == n - 1);
}

DenseMatrix vectors_at_cells(const Discretization& mesh, const Cochain& form, Proxy proxy) {
    if (!has_proxy(mesh, form))
        return {};
    check(mesh.complex(), form);
    const Cochain primal = primal_of(mesh, form);
    if (is_along(form, proxy) == (form.side == Side::primal))
        return sharp_pd(mesh, primal);
    // a dual 1-form is along the cells that cross facets, (-1)^(n-1) times the star of their fluxes
    const bool turns = form.side == Side::dual && mesh.dimension() % 2 == 0;
    return (turns ? -1 : 1) * flux_sharp(mesh, primal);
}

DenseMatrix vectors_at_vertices(const Discretization& mesh, const Cochain& form, Proxy proxy) {
    if (!has_proxy(mesh, form))
        return {};
    if (form.side == Side::primal && is_along(form, proxy) &&
        star(mesh.input_geometry().volumes(), 0).zeros().empty())
        return sharp_pp(mesh, form);
    return means_at_vertices(mesh, vectors_at_cells(mesh, form, proxy));
}

DenseMatrix means_at_vertices(const Discretization& mesh, const DenseMatrix& at_cells) {
    const int n = mesh.dimension();
    refuse_turned_vertices(mesh, "the mean of vectors at vertices");
    check_as_many("rows", at_cells.rows(), mesh.complex().size(n));
    DenseMatrix sums = DenseMatrix::Zero(mesh.complex().size(0), at_cells.cols());
    Vector weights = Vector::Zero(sums.rows());
    for (Index cell = 0; cell < at_cells.rows(); ++cell) {
        const double volume = mesh.volumes().primal(n)[cell];
        for (const Index corner : mesh.merging().vertices(n, cell))
            if (const auto [degree, v] = mesh.merging().carriers(0)[corner]; degree == 0) {
                sums.row(v) += volume * at_cells.row(cell);
                weights[v] += volume;
            }
    }
    for (Index v = 0; v < weights.size(); ++v)
        if (weights[v] > 0)
            sums.row(v) /= weights[v];
    return sums;
}

} // namespace polydec
