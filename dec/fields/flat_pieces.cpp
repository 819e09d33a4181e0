// SPDX-License-Identifier: MIT
#include "dec/fields/flat_pieces.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/metric/centers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

void refuse_flat_pieces(const Discretization& mesh, std::string_view what) {
    const auto& flat = mesh.geometry().flat();
    const auto first = std::find(flat.begin(), flat.end(), true);
    if (first == flat.end())
        return;
    const int n = mesh.dimension();
    const auto t = static_cast<Index>(first - flat.begin());
    const auto corners = mesh.pieces().vertex_numbers(n, t);
    throw InvalidInput(fmt::format("{} is not defined in cells with flat pieces, such as the "
                                   "{}-simplex with vertices {}: remove these from the mesh",
                                   what, n, fmt::join(corners, " ")),
                       {.degree = n, .cells = {t}, .vertices = corners});
}

void fill_flat_pieces(const Discretization& mesh, Points& rows) {
    const int n = mesh.dimension();
    check_as_many("rows of pieces", rows.rows(), mesh.pieces().size(n));
    for (Index t = 0; t < rows.rows(); ++t) {
        if (!mesh.geometry().is_flat(t))
            continue;
        Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(rows.cols());
        double volume = 0;
        const Index cell = mesh.merging().carriers(n)[t].cell;
        for (const Index other : mesh.merging().pieces_of(n, cell)) {
            if (mesh.geometry().is_flat(other))
                continue;
            sum += mesh.geometry().volumes().primal(n)[other] * rows.row(other);
            volume += mesh.geometry().volumes().primal(n)[other];
        }
        rows.row(t) = sum / volume;
    }
}

Points at_centers(const Discretization& mesh, const Places& places, const Points& values, int k) {
    const Points coordinates =
        center_coordinates(mesh.pieces(), mesh.geometry().metric(), mesh.geometry().centers(), k);
    Points rows = places.at(k, coordinates, values);
    if (k == mesh.dimension())
        fill_flat_pieces(mesh, rows);
    return rows;
}

} // namespace polydec
