// SPDX-License-Identifier: MIT
#include "dec/fields/periodic_fields.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/simplicial_complex.h"
#include "dec/fields/transfer.h"

#include <algorithm>
#include <map>
#include <vector>

namespace polydec {

namespace {

/// Corners in ascending order; the sign is that of the order they were in.
double sort_corners(std::vector<Index>& corners) {
    double sign = 1;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = i + 1; j < corners.size(); ++j)
            sign = corners[i] > corners[j] ? -sign : sign;
    std::sort(corners.begin(), corners.end());
    return sign;
}

std::vector<Index> corners_of(const Pieces& pieces, int k, Index s) {
    const auto row = pieces.simplices(k).row(s);
    return {row.begin(), row.end()};
}

} // namespace

Cochain de_rham(const PeriodicMesh& periodic, const Discretization& mesh, int k,
                const SmoothForm& form, int quadrature_degree) {
    const SimplicialComplex box(periodic.box.simplices);
    const SimplicialComplex& quotient = mesh.input();
    check_as_many("cells of a quotient", quotient.size(quotient.dimension()),
                  periodic.quotient.simplices.rows());
    check_as_many("vertices of a quotient", quotient.size(0), periodic.quotient.vertices);
    const Vector of_box =
        de_rham(box, periodic.box.points / mesh.unit(), k, form, quadrature_degree);
    std::map<std::vector<Index>, Index> places;
    for (Index s = 0; s < quotient.size(k); ++s)
        places[corners_of(quotient, k, s)] = s;

    Vector values = Vector::Zero(quotient.size(k));
    const bool tops = k == quotient.dimension();
    for (Index s = 0; s < box.size(k); ++s) {
        auto corners = corners_of(box, k, s);
        for (Index& v : corners)
            v = periodic.vertices[box.vertex_number(v)];
        const double sign = sort_corners(corners);
        const auto place = places.find(corners);
        if (place == places.end())
            throw InvalidInput("a form on a periodic box is given with a mesh of another: expected "
                               "discretize(periodic.quotient)");
        // tops have an orientation of their own against the order of corners
        const int turned = tops ? box.orientation(s) * quotient.orientation(place->second) : 1;
        values[place->second] = turned * sign * of_box[s];
    }
    return to_merged(mesh, {Side::primal, k, std::move(values)});
}

} // namespace polydec
