// SPDX-License-Identifier: MIT
#include "dec/fields/interior_product.h"

#include "base/errors.h"
#include "complex/components.h"
#include "dec/forms/derivative.h"
#include "dec/merging/lift.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace polydec {

namespace {

void check_degree(int k, int largest) {
    if (k < 0 || k > largest)
        throw InvalidInput(fmt::format("a vector field is to act on {}-forms: expected a degree "
                                       "from 0 to {}",
                                       k, largest));
}

void check_field(const Pieces& complex, const Points& points, const Points& field) {
    require_straight(complex, points, "a vector field");
    if (field.rows() != points.rows() || field.cols() != points.cols())
        throw InvalidInput(fmt::format("a vector field of {} x {} numbers is given: expected {} x "
                                       "{}, a row for each point",
                                       field.rows(), field.cols(), points.rows(), points.cols()));
    for (Index v = 0; v < field.rows(); ++v)
        if (!field.row(v).allFinite())
            throw InvalidInput(
                fmt::format("the vector field at vertex {} is not finite: give it a value",
                            complex.vertex_number(v)),
                {.vertices = {complex.vertex_number(v)}});
}

/// The (k-1)-faces of n-simplices, and how the field leaves them within these.
class Contraction {
public:
    Contraction(const Pieces& complex, const Points& points, const Points& field, int k)
        : complex_(complex),
          points_(points),
          field_(field),
          k_(k),
          faces_(complex, complex.dimension(), k - 1),
          cofaces_(complex, complex.dimension(), k) {
        for (const auto& face : faces_.positions())
            extensions_.push_back(extensions_of(face));
    }

    /// The slope of the barycentric coordinate of a further vertex along the field, the coface
    /// with this vertex, and its incidence with the face.
    struct Term {
        Index coface;
        double incidence;
        double slope;
        double steepness; // length of the gradient
    };

    /// Calls visit(s, terms) for the (k-1)-faces s of n-simplex t.
    template <class Visit>
    void visit_faces(Index t, Visit visit) {
        const auto& tops = complex_.simplices(complex_.dimension());
        const DenseMatrix gradients = barycentric_gradients(points_, vertices(tops, t));
        const auto &faces = faces_.of(t), &cofaces = cofaces_.of(t);
        std::vector<Term> terms;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            Eigen::RowVectorXd X = Eigen::RowVectorXd::Zero(field_.cols());
            for (const int p : faces_.positions()[i])
                X += field_.row(tops(t, p)) / k_;
            terms.clear();
            for (const auto& extension : extensions_[i]) {
                const Index coface = cofaces[extension.coface];
                const auto gradient = gradients.row(extension.vertex);
                terms.push_back({coface, extension.sign * orientation(complex_, k_, coface),
                                 X.dot(gradient), gradient.norm()});
            }
            visit(faces[i], terms);
        }
    }

private:
    struct Extension {
        int vertex;
        std::size_t coface;
        double sign;
    };

    /// What a face becomes with each of the other vertices; the sign is that of putting it first.
    std::vector<Extension> extensions_of(const std::vector<int>& face) const {
        std::vector<Extension> extensions;
        for (int q = 0; q <= complex_.dimension(); ++q) {
            const auto place = std::lower_bound(face.begin(), face.end(), q);
            if (place != face.end() && *place == q)
                continue;
            auto extended = face;
            extended.insert(extended.begin() + (place - face.begin()), q);
            const auto& all = cofaces_.positions();
            const auto found = std::lower_bound(all.begin(), all.end(), extended);
            extensions.push_back({q, static_cast<std::size_t>(found - all.begin()),
                                  (place - face.begin()) % 2 == 0 ? 1.0 : -1.0});
        }
        return extensions;
    }

    const Pieces& complex_;
    const Points& points_;
    const Points& field_;
    int k_;
    SimplexFaces faces_, cofaces_;
    std::vector<std::vector<Extension>> extensions_; // by face of the n-simplex
};

using Terms = std::vector<Contraction::Term>;

Vector top_volumes(const Pieces& complex, const Points& points) {
    const int n = complex.dimension();
    Circumsphere sphere(points);
    Vector volumes(complex.size(n));
    for (Index t = 0; t < complex.size(n); ++t) {
        // one without volume has no weight but where it is alone
        const bool has_volume = sphere.look_at(vertices(complex.simplices(n), t));
        volumes[t] = has_volume ? sphere.volume() : std::numeric_limits<double>::min();
    }
    return volumes;
}

/// How far the opposite of the field points into a simplex, from a face of it.
double upwindness(const Terms& terms) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& term : terms)
        least = std::min(least, -term.slope / term.steepness);
    return least;
}

/// What part the n-simplices t around a (k-1)-simplex s have in its value; for each s 1 in all.
class Weights {
public:
    Weights(const Pieces& complex, const Points& points, Contraction& contraction, int k,
            Sampling sampling)
        : sampling_(sampling),
          volumes_(top_volumes(complex, points)),
          total_(Vector::Zero(complex.size(k - 1))),
          best_(complex.size(k - 1), -1) {
        Vector most = Vector::Zero(complex.size(k - 1));
        for (Index t = 0; t < complex.size(complex.dimension()); ++t)
            contraction.visit_faces(t, [&](Index s, const Terms& terms) {
                total_[s] += volumes_[t];
                const double here = upwindness(terms);
                if (best_[s] < 0 || here > most[s]) {
                    best_[s] = t;
                    most[s] = here;
                }
            });
    }

    double operator()(Index t, Index s) const {
        if (sampling_ == Sampling::centered)
            return volumes_[t] / total_[s];
        return best_[s] == t ? 1 : 0;
    }

private:
    Sampling sampling_;
    Vector volumes_, total_;
    std::vector<Index> best_;
};

/// What a form is on the far side of an inflow boundary.
enum class Beyond {
    the_same, ///< as if the nearest simplex went on
    nothing,
};

SparseMatrix contraction(const Pieces& complex, const Points& points, const Points& field, int k,
                         Sampling sampling, Beyond beyond) {
    check_degree(k, complex.dimension() + 1);
    check_field(complex, points, field);
    SparseMatrix result(complex.size(k - 1), complex.size(k));
    if (result.rows() == 0 || result.cols() == 0)
        return result;

    const bool cut = sampling == Sampling::upwind && beyond == Beyond::nothing;
    Contraction contraction(complex, points, field, k);
    const Weights weights(complex, points, contraction, k, sampling);
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index t = 0; t < complex.size(complex.dimension()); ++t)
        contraction.visit_faces(t, [&](Index s, const Terms& terms) {
            const double weight = weights(t, s);
            if (weight == 0)
                return;
            for (const auto& term : terms)
                if (!cut || term.slope <= 0)
                    entries.emplace_back(s, term.coface, -k * weight * term.slope * term.incidence);
        });
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// i_X d + d i_X, with interior(k) the interior product of k-forms.
template <class Interior>
SparseMatrix cartan(const CellComplex& complex, int k, Interior interior) {
    check_degree(k, complex.dimension());
    const SparseMatrix upper = interior(k + 1) * derivative(complex, k);
    const SparseMatrix lower = derivative(complex, k - 1) * interior(k);
    return upper + lower;
}

} // namespace

SparseMatrix interior_product(const Pieces& complex, const Points& points, const Points& field,
                              int k, Sampling sampling) {
    return contraction(complex, points, field, k, sampling, Beyond::the_same);
}

SparseMatrix lie_derivative(const Pieces& complex, const Points& points, const Points& field, int k,
                            Sampling sampling) {
    const SparseMatrix L = cartan(complex, k, [&](int degree) {
        return contraction(complex, points, field, degree, sampling, Beyond::nothing);
    });
    return sampling == Sampling::upwind ? SparseMatrix(L + inflow(complex, points, field, k)) : L;
}

SparseMatrix inflow(const Pieces& complex, const Points& points, const Points& field, int k) {
    const int n = complex.dimension();
    check_degree(k, n);
    check_field(complex, points, field);
    SparseMatrix rates(complex.size(k), complex.size(k));
    if (k == n) // an n-simplex has two sides inside
        return rates;
    const auto boundary = boundary_cells(complex);
    Contraction contraction(complex, points, field, k + 1);
    const Weights weights(complex, points, contraction, k + 1, Sampling::upwind);
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index t = 0; t < complex.size(n); ++t)
        contraction.visit_faces(t, [&](Index s, const Terms& terms) {
            if (!boundary[k][s] || weights(t, s) == 0)
                return;
            double rate = 0;
            for (const auto& term : terms)
                rate += (k + 1) * std::max(term.slope, 0.0);
            if (rate > 0)
                entries.emplace_back(s, s, rate);
        });
    rates.setFromTriplets(entries.begin(), entries.end());
    return rates;
}

namespace {

/// The vectors at the vertices of the input.
Points on_input(const Discretization& mesh, const Points& field) {
    require_points(mesh.points().cols(), "a vector field");
    return mesh.passage().back(0, field);
}

/// An operator on the input's simplices, from k-forms to j-forms, for those on the cells.
SparseMatrix on_cells(const Discretization& mesh, const SparseMatrix& fine, int k, int j) {
    if (fine.rows() == 0 || fine.cols() == 0)
        return SparseMatrix(mesh.complex().size(j), mesh.complex().size(k));
    const SparseMatrix& lift = mesh.lift()[k];
    if (mesh.passage().is_identity())
        return mesh.merging().diamond(j).cast<double>() * SparseMatrix(fine * lift);
    const SparseMatrix back = mesh.passage().matrix_back(k) * lift;
    const SparseMatrix there = mesh.passage().matrix(j) * SparseMatrix(fine * back);
    return mesh.merging().diamond(j).cast<double>() * there;
}

} // namespace

SparseMatrix interior_product(const Discretization& mesh, const Points& field, int k,
                              Sampling sampling) {
    return on_cells(
        mesh,
        interior_product(mesh.input(), mesh.input_points(), on_input(mesh, field), k, sampling), k,
        k - 1);
}

SparseMatrix lie_derivative(const Discretization& mesh, const Points& field, int k,
                            Sampling sampling) {
    return on_cells(
        mesh, lie_derivative(mesh.input(), mesh.input_points(), on_input(mesh, field), k, sampling),
        k, k);
}

SparseMatrix inflow(const Discretization& mesh, const Points& field, int k) {
    return on_cells(mesh, inflow(mesh.input(), mesh.input_points(), on_input(mesh, field), k), k,
                    k);
}

} // namespace polydec
