// SPDX-License-Identifier: MIT
#include "dec/fields/lie_derivative.h"

#include "base/errors.h"
#include "complex/components.h"
#include "dec/fields/transfer.h"
#include "dec/forms/input_units.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace polydec {

namespace {

/// Throws InvalidInput unless 0 <= k <= largest.
void check_degree_of_contraction(int k, int largest) {
    if (k < 0 || k > largest)
        throw InvalidInput(fmt::format(
            "a vector field cannot act on {}-forms here: expected a degree from 0 to {}", k,
            largest));
}

/// Throws InvalidInput for upwind transport of functions with values at vertices that splits have
/// added: carried to the input and back, these would follow their neighbors only.
void check_transport(const Discretization& mesh, int k, Sampling sampling) {
    const Index added = mesh.pieces().size(0) - mesh.input().size(0);
    if (k == 0 && sampling == Sampling::upwind && added > 0)
        throw InvalidInput(fmt::format(
            "upwind transport of functions is not monotone at the {} vertices that splits have "
            "added: use Delaunay::flips, which add none, or centered sampling",
            added));
}

/// Vectors at the vertices of the input, from vectors at the points of a mesh, in its unit. Throws
/// InvalidInput, naming the vertex, unless the field has one finite vector per point, and if only
/// lengths are known.
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

/// Value of a form on the far side of an inflow boundary.
enum class Beyond {
    the_same, ///< as if the nearest simplex continued
    nothing,
};

/// Contractions of k-forms with vector fields, k = 1..n: precomputes everything independent of the
/// field. Visits the matrix entries, so they can be collected or applied on the fly.
class Contraction {
public:
    Contraction(const Pieces& complex, const PlacedSimplices& places, int k)
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

    int degree() const { return k_; }

    /// Calls visit(s, c, value) with the contribution of k-simplex c to the contraction at its face
    /// s.
    template <class Visit>
    void visit_entries(const Points& field, Sampling sampling, Beyond beyond, Visit visit) const {
        const bool cut = sampling == Sampling::upwind && beyond == Beyond::nothing;
        const auto nearest =
            sampling == Sampling::upwind ? upwind_simplices(field) : std::vector<Index>();
        visit_faces(field, [&](Index t, Index s, const std::vector<Term>& terms) {
            if (!nearest.empty() && nearest[s] != t)
                return;
            const double weight = nearest.empty() ? volumes_[t] / volumes_around_[s] : 1;
            for (const auto& term : terms)
                if (!cut || term.slope <= 0)
                    visit(s, term.coface, -k_ * weight * term.slope * term.incidence);
        });
    }

    /// Calls visit(s, rate) for the boundary (k-1)-simplices where the field flows in, with the
    /// rate at which outside values of a (k-1)-form come in.
    template <class Visit>
    void visit_inflow(const Points& field, Visit visit) const {
        const auto nearest = upwind_simplices(field);
        visit_faces(field, [&](Index t, Index s, const std::vector<Term>& terms) {
            if (!on_boundary_[s] || nearest[s] != t)
                return;
            double rate = 0;
            for (const auto& term : terms)
                rate += k_ * std::max(term.slope, 0.0);
            if (rate > 0)
                visit(s, rate);
        });
    }

private:
    /// Slope along the field of the barycentric coordinate of a further vertex, the coface with
    /// this vertex, and its incidence with the face.
    struct Term {
        Index coface;
        double incidence;
        double slope;
        double steepness; // length of the gradient
    };
    struct Extension {
        int vertex;
        std::size_t coface;
        double sign;
    };

    /// Calls visit(t, s, terms) for the (k-1)-faces s of the n-simplices t.
    template <class Visit>
    void visit_faces(const Points& field, Visit visit) const {
        const int n = complex_.dimension();
        const auto& tops = complex_.simplices(n);
        SimplexFaces faces(complex_, n, k_ - 1), cofaces(complex_, n, k_);
        std::vector<Term> terms;
        Eigen::RowVectorXd X(field.cols());
        for (Index t = 0; t < complex_.size(n); ++t) {
            const auto &sides = faces.of(t), &around = cofaces.of(t);
            for (std::size_t i = 0; i < sides.size(); ++i) {
                X.setZero();
                for (const int p : faces.positions()[i])
                    X += field.row(tops(t, p)) / k_;
                terms.clear();
                for (const auto& extension : extensions_[i]) {
                    const Index coface = around[extension.coface];
                    const Eigen::Index row = Eigen::Index{t} * (n + 1) + extension.vertex;
                    const double side = k_ == n ? complex_.orientation(coface) : 1;
                    terms.push_back({coface, extension.sign * side, X.dot(gradients_.row(row)),
                                     steepness_[row]});
                }
                visit(t, sides[i], terms);
            }
        }
    }

    /// The cofaces of a face with each other vertex; the sign is for putting this vertex first.
    std::vector<Extension> extensions_of(const std::vector<int>& face,
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
    std::vector<Index> upwind_simplices(const Points& field) const {
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

    Pieces complex_;
    int k_;
    std::vector<std::vector<Extension>> extensions_; // by face of the n-simplex
    Points gradients_;                               // n + 1 rows for each n-simplex
    Vector steepness_;                               // their lengths
    Vector volumes_, volumes_around_;                // of n-simplices; of those around each face
    std::vector<bool> on_boundary_;                  // of faces
};

namespace {

SparseMatrix contraction(const Pieces& complex, const PlacedSimplices& places, const Points& field,
                         int k, Sampling sampling, Beyond beyond) {
    check_degree_of_contraction(k, complex.dimension() + 1);
    SparseMatrix result(complex.size(k - 1), complex.size(k));
    if (result.rows() == 0 || result.cols() == 0)
        return result;
    std::vector<Eigen::Triplet<double, Index>> entries;
    Contraction(complex, places, k)
        .visit_entries(field, sampling, beyond, [&](Index s, Index coface, double value) {
            entries.emplace_back(s, coface, value);
        });
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

SparseMatrix inflow(const Pieces& complex, const PlacedSimplices& places, const Points& field,
                    int k) {
    const int n = complex.dimension();
    check_degree_of_contraction(k, n);
    SparseMatrix rates(complex.size(k), complex.size(k));
    if (k == n) // both sides of an n-simplex are interior
        return rates;
    std::vector<Eigen::Triplet<double, Index>> entries;
    Contraction(complex, places, k + 1).visit_inflow(field, [&](Index s, double rate) {
        entries.emplace_back(s, s, rate);
    });
    rates.setFromTriplets(entries.begin(), entries.end());
    return rates;
}

/// i_X d + d i_X, plus the inflow.
SparseMatrix lie_derivative(const Pieces& complex, const PlacedSimplices& places,
                            const Points& field, int k, Sampling sampling) {
    check_degree_of_contraction(k, complex.dimension());
    const auto interior = [&](int degree) {
        return contraction(complex, places, field, degree, sampling, Beyond::nothing);
    };
    const SparseMatrix upper = interior(k + 1) * derivative(complex, k);
    const SparseMatrix lower = derivative(complex, k - 1) * interior(k);
    const SparseMatrix L = upper + lower;
    return sampling == Sampling::upwind ? SparseMatrix(L + inflow(complex, places, field, k)) : L;
}

/// Maps an operator on the input's simplices, from k-forms to j-forms, to the cells.
SparseMatrix on_cells(const Discretization& mesh, const SparseMatrix& fine, int k, int j) {
    if (fine.rows() == 0 || fine.cols() == 0)
        return SparseMatrix(mesh.complex().size(j), mesh.complex().size(k));
    const SparseMatrix back = mesh.passage().matrix_back(k) * mesh.merged().lift()[k];
    const SparseMatrix there = mesh.passage().matrix(j) * SparseMatrix(fine * back);
    return mesh.merging().diamond(j).cast<double>() * there;
}

} // namespace

SparseMatrix interior_product(const Discretization& mesh, const Points& field, int k,
                              Sampling sampling) {
    const Points here = field_on_input(mesh, field);
    return on_cells(mesh,
                    contraction(mesh.input(), mesh.places(), here, k, sampling, Beyond::the_same),
                    k, k - 1);
}

SparseMatrix lie_derivative(const Discretization& mesh, const Points& field, int k,
                            Sampling sampling) {
    check_transport(mesh, k, sampling);
    const Points here = field_on_input(mesh, field);
    return on_cells(mesh, lie_derivative(mesh.input(), mesh.places(), here, k, sampling), k, k);
}

SparseMatrix inflow(const Discretization& mesh, const Points& field, int k) {
    const Points here = field_on_input(mesh, field);
    return on_cells(mesh, inflow(mesh.input(), mesh.places(), here, k), k, k);
}

struct LieDerivative::Parts {
    Discretization mesh;
    SimplicialComplex complex;
    int k;
    Sampling sampling;
    std::optional<Contraction> lower, upper; // of k-forms and of their derivatives

    Parts(const Discretization& on, int degree, Sampling how)
        : mesh(on), complex(mesh.input()), k(degree), sampling(how) {
        const PlacedSimplices places = mesh.places();
        check_degree_of_contraction(k, complex.dimension());
        require_points(mesh.ambient_dimension(), "a vector field");
        check_transport(mesh, k, sampling);
        if (k > 0)
            lower.emplace(complex, places, k);
        if (k < complex.dimension())
            upper.emplace(complex, places, k + 1);
    }

    /// Checks the form and returns its values on the simplices.
    Cochain checked(const Cochain& form) const {
        if (form.side != Side::primal || form.degree != k)
            throw InvalidInput(
                fmt::format("a {} {}-form is given: this Lie derivative acts on primal {}-forms",
                            name(form.side), form.degree, k));
        return lifted(mesh, form);
    }

    Cochain contract(const Contraction& by, const Points& field, const Cochain& form,
                     Beyond beyond) const {
        Vector values = Vector::Zero(complex.size(by.degree() - 1));
        by.visit_entries(field, sampling, beyond, [&](Index s, Index coface, double value) {
            values[s] += value * form.values[coface];
        });
        return {Side::primal, by.degree() - 1, std::move(values)};
    }

    void add_inflow(const Points& field, const Cochain& outside, Vector& to) const {
        if (upper && sampling == Sampling::upwind)
            upper->visit_inflow(field,
                                [&](Index s, double rate) { to[s] += rate * outside.values[s]; });
    }
};

LieDerivative::LieDerivative(const Discretization& mesh, int k, Sampling sampling)
    : parts_(std::make_shared<Parts>(mesh, k, sampling)) {}

Cochain LieDerivative::interior_product(const Points& field, const Cochain& form) const {
    const Points X = field_on_input(parts_->mesh, field);
    const Cochain a = parts_->checked(form);
    if (!parts_->lower)
        return {Side::primal, -1, {}};
    return to_merged(parts_->mesh, parts_->contract(*parts_->lower, X, a, Beyond::the_same));
}

Cochain LieDerivative::operator()(const Points& field, const Cochain& form) const {
    const Points X = field_on_input(parts_->mesh, field);
    const Cochain a = parts_->checked(form);
    Cochain result{Side::primal, a.degree, Vector::Zero(a.values.size())};
    if (parts_->upper)
        result.values +=
            parts_->contract(*parts_->upper, X, d(parts_->complex, a), Beyond::nothing).values;
    if (parts_->lower)
        result.values +=
            d(parts_->complex, parts_->contract(*parts_->lower, X, a, Beyond::nothing)).values;
    parts_->add_inflow(X, a, result.values);
    return to_merged(parts_->mesh, result);
}

Cochain LieDerivative::inflow(const Points& field, const Cochain& outside) const {
    const Points X = field_on_input(parts_->mesh, field);
    const Cochain g = parts_->checked(outside);
    Cochain result{Side::primal, g.degree, Vector::Zero(g.values.size())};
    parts_->add_inflow(X, g, result.values);
    return to_merged(parts_->mesh, result);
}

} // namespace polydec
