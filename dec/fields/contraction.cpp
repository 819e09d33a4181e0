// SPDX-License-Identifier: MIT
#include "dec/fields/contraction.h"

#include "base/errors.h"
#include "dec/forms/input_units.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <fmt/format.h>

#include <limits>

namespace polydec {

void check_degree_of_contraction(int k, int largest) {
    if (k < 0 || k > largest)
        throw InvalidInput(fmt::format(
            "a vector field cannot act on {}-forms here: expected a degree from 0 to {}", k,
            largest));
}

Points field_on_input(const Discretization& mesh, const Points& field) {
    const Pieces& complex = mesh.pieces();
    const int N = mesh.ambient_dimension();
    require_points(N, "a vector field");
    if (field.rows() != complex.size(0) || field.cols() != N)
        throw InvalidInput(fmt::format("a vector field of {} x {} numbers is given: expected {} x "
                                       "{}, a row for each point",
                                       field.rows(), field.cols(), complex.size(0), N));
    for (Index v = 0; v < field.rows(); ++v)
        if (!field.row(v).allFinite())
            throw InvalidInput(
                fmt::format("the vector field at vertex {} is not finite: give it a value",
                            complex.vertex_number(v)),
                {.vertices = {complex.vertex_number(v)}});
    return in_input_units(Points(mesh.passage().back(0, field)), mesh.unit(), -1, "vectors");
}

namespace {

Vector top_volumes(const PlacedSimplices& places) {
    Circumsphere sphere;
    Vector volumes(places.corners.rows());
    for (Index t = 0; t < volumes.size(); ++t) {
        // a simplex without volume has weight only if it is alone
        const bool has_volume = sphere.look_at({places.points, vertices(places.corners, t)});
        volumes[t] = has_volume ? sphere.volume() : std::numeric_limits<double>::min();
    }
    return volumes;
}

} // namespace

Contraction::Contraction(const Pieces& complex, const PlacedSimplices& places, int k)
    : complex_(complex),
      k_(k),
      volumes_(top_volumes(places)),
      volumes_around_(Vector::Zero(complex.size(k - 1))),
      on_boundary_(boundary_cells(complex)[k - 1]) {
    const int n = complex.dimension();
    SimplexFaces faces(complex, n, k - 1);
    const SimplexFaces cofaces(complex, n, k);
    for (const auto& face : faces.positions())
        extensions_.push_back(extensions_of(face, cofaces.positions()));
    gradients_.resize(Eigen::Index{complex.size(n)} * (n + 1), places.points.cols());
    for (Index t = 0; t < complex.size(n); ++t) {
        gradients_.middleRows(Eigen::Index{t} * (n + 1), n + 1) =
            barycentric_gradients(places.points, vertices(places.corners, t));
        for (const Index s : faces.of(t))
            volumes_around_[s] += volumes_[t];
    }
    steepness_ = gradients_.rowwise().norm();
}

/// The cofaces of a face with each other vertex; the sign is for putting this vertex first.
std::vector<Contraction::Extension>
Contraction::extensions_of(const std::vector<int>& face,
                           const std::vector<std::vector<int>>& cofaces) const {
    std::vector<Extension> extensions;
    for (const int q : complement(complex_.dimension() + 1, face)) {
        const auto place = std::lower_bound(face.begin(), face.end(), q);
        auto extended = face;
        extended.insert(extended.begin() + (place - face.begin()), q);
        const auto found = std::lower_bound(cofaces.begin(), cofaces.end(), extended);
        extensions.push_back({q, static_cast<std::size_t>(found - cofaces.begin()),
                              (place - face.begin()) % 2 == 0 ? 1.0 : -1.0});
    }
    return extensions;
}

/// For each face the n-simplex into which the opposite of the field points farthest.
std::vector<Index> Contraction::upwind_simplices(const Points& field) const {
    std::vector<Index> best(complex_.size(k_ - 1), -1);
    Vector most = Vector::Zero(complex_.size(k_ - 1));
    visit_faces(field, [&](Index t, Index s, const std::vector<Term>& terms) {
        double here = std::numeric_limits<double>::infinity(); // how far it points into t
        for (const auto& term : terms)
            here = std::min(here, -term.slope / term.steepness);
        if (best[s] < 0 || here > most[s]) {
            best[s] = t;
            most[s] = here;
        }
    });
    return best;
}

} // namespace polydec
