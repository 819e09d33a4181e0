// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/fields/lie_derivative.h"
#include "dec/metric/simplex_faces.h"

#include <algorithm>
#include <vector>

namespace polydec {

/// Value of a form on the far side of an inflow boundary.
enum class Beyond {
    the_same, ///< as if the nearest simplex continued
    nothing,
};

/// Contractions of k-forms with vector fields, k = 1..n: precomputes everything independent of the
/// field. Visits the matrix entries, so they can be collected or applied on the fly.
class Contraction {
public:
    Contraction(const Pieces& complex, const PlacedSimplices& places, int k);

    int degree() const { return k_; }

    /// Calls visit(s, c, value) with the contribution of k-simplex c to the contraction at its face
    /// s.
    template <class Visit>
    void visit_entries(const Points& field, Sampling sampling, Beyond beyond, Visit visit) const {
        const bool cut = sampling == Sampling::upwind && beyond == Beyond::nothing;
        visit_samples(field, sampling, [&](const Place& at, double share) {
            for (const auto& term : at.terms)
                if (!cut || term.slope <= 0)
                    visit(at.s, term.coface, -k_ * share * term.slope * term.incidence);
        });
    }

    /// Calls visit(s, rate) for the boundary (k-1)-simplices where the field flows in, with the
    /// rate at which outside values of a (k-1)-form come in.
    template <class Visit>
    void visit_inflow(const Points& field, Visit visit) const {
        visit_samples(field, Sampling::upwind, [&](const Place& at, double share) {
            double rate = 0;
            for (const auto& term : at.terms)
                rate += k_ * share * std::max(term.slope, 0.0);
            if (on_boundary_[at.s] && rate > 0)
                visit(at.s, rate);
        });
    }

private:
    /// Difference of distances, of vectors of length 1, that are equal up to rounding.
    static constexpr double rounding = 1e-12;

    /// Slope along the field of the barycentric coordinate of a further vertex, the coface with
    /// this vertex, and its incidence with the face.
    struct Term {
        Index coface;
        double incidence;
        double slope;
        Eigen::Index gradient; // of the coordinate, a row
    };
    struct Extension {
        int vertex;
        std::size_t coface;
        double sign;
    };
    /// The i-th (k-1)-face of n-simplex t is s; the field there, and the terms of other vertices.
    struct Place {
        Index t, i, s;
        Eigen::RowVectorXd X;
        std::vector<Term> terms;
    };

    /// The n-simplices nearest to the opposite of a field, seen from their faces as cones.
    struct Nearest {
        DenseMatrix distance; // of n-simplices (rows) from their faces (columns)
        Vector least, volume; // at each face: the least of them, and the volume where it is

        bool has(Index t, Index i, Index s) const { return distance(t, i) <= least[s] + rounding; }
    };

    /// Calls visit(place, share) for the n-simplices around each face whose values are used. Their
    /// shares are in proportion to their volumes and sum to 1.
    template <class Visit>
    void visit_samples(const Points& field, Sampling sampling, Visit visit) const {
        const bool is_upwind = sampling == Sampling::upwind;
        const Nearest samples = is_upwind ? nearest(field) : Nearest();
        const Vector& around = is_upwind ? samples.volume : around_;
        visit_faces(
            field, [&](Index t, Index i, Index s) { return !is_upwind || samples.has(t, i, s); },
            [&](const Place& at) { visit(at, volumes_[at.t] / around[at.s]); });
    }

    /// Calls visit(place) for the (k-1)-faces of the n-simplices where wanted(t, i, s).
    template <class Wanted, class Visit>
    void visit_faces(const Points& field, Wanted wanted, Visit visit) const {
        const int n = complex_.dimension();
        const auto& tops = complex_.simplices(n);
        SimplexFaces faces(complex_, n, k_ - 1), cofaces(complex_, n, k_);
        Place at;
        at.X.resize(field.cols());
        for (at.t = 0; at.t < complex_.size(n); ++at.t) {
            const auto &sides = faces.of(at.t), &around = cofaces.of(at.t);
            for (at.i = 0; at.i < std::ssize(sides); ++at.i) {
                at.s = sides[at.i];
                if (!wanted(at.t, at.i, at.s))
                    continue;
                at.X.setZero();
                for (const int p : faces.positions()[at.i])
                    at.X += field.row(tops(at.t, p)) / k_;
                at.terms.clear();
                for (const auto& extension : extensions_[at.i]) {
                    const Index coface = around[extension.coface];
                    const Eigen::Index row = Eigen::Index{at.t} * (n + 1) + extension.vertex;
                    const double side = k_ == n ? complex_.orientation(coface) : 1;
                    at.terms.push_back(
                        {coface, extension.sign * side, at.X.dot(gradients_.row(row)), row});
                }
                visit(at);
            }
        }
    }

    /// The cofaces of a face with each other vertex; the sign is for putting this vertex first.
    std::vector<Extension> extensions_of(const std::vector<int>& face,
                                         const std::vector<std::vector<int>>& cofaces) const;

    /// Of the field's opposite at length 1. Distances are infinite for simplices without volume,
    /// and beside one that contains it.
    Nearest nearest(const Points& field) const;

    Pieces complex_;
    int k_;
    std::vector<std::vector<Extension>> extensions_; // by face of the n-simplex
    Points gradients_;                               // n + 1 rows for each n-simplex
    Points normals_;                                 // N rows, in columns
    Vector volumes_;                                 // of n-simplices
    Vector around_;                                  // sums of these around each face
    std::vector<bool> on_boundary_;                  // of faces
};

} // namespace polydec
