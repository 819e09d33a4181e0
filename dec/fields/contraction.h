// SPDX-License-Identifier: MIT
#pragma once

#include "complex/components.h"
#include "dec/fields/lie_derivative.h"
#include "dec/metric/simplex_faces.h"

#include <algorithm>
#include <vector>

namespace polydec {

/// Throws InvalidInput unless 0 <= k <= largest.
void check_degree_of_contraction(int k, int largest);

/// Vectors at the vertices of the input, from vectors at the points of a mesh, in its unit. Throws
/// InvalidInput, naming the vertex, unless the field has one finite vector per point, and if only
/// lengths are known.
Points field_on_input(const Discretization& mesh, const Points& field);

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

    template <class Visit>
    void visit_faces(const Points& field, Visit visit) const;
    std::vector<Extension> extensions_of(const std::vector<int>& face,
                                         const std::vector<std::vector<int>>& cofaces) const;
    std::vector<Index> upwind_simplices(const Points& field) const;

    Pieces complex_;
    int k_;
    std::vector<std::vector<Extension>> extensions_; // by face of the n-simplex
    Points gradients_;                               // n + 1 rows for each n-simplex
    Vector steepness_;                               // their lengths
    Vector volumes_, volumes_around_;                // of n-simplices; of those around each face
    std::vector<bool> on_boundary_;                  // of faces
};

/// Calls visit(t, s, terms) for the (k-1)-faces s of the n-simplices t.
template <class Visit>
void Contraction::visit_faces(const Points& field, Visit visit) const {
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
                terms.push_back(
                    {coface, extension.sign * side, X.dot(gradients_.row(row)), steepness_[row]});
            }
            visit(t, sides[i], terms);
        }
    }
}

} // namespace polydec
