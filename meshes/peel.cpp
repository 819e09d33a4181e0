// SPDX-License-Identifier: MIT
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/listed.h"
#include "complex/simplicial_complex.h"
#include "meshes/edges.h"
#include "meshes/tidy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// Volume of a simplex times the factorial of its dimension.
double parallelepiped(const Points& points, const std::vector<Index>& corners) {
    return std::abs(
        triangular_factor(edges_at_first(points, corners).transpose()).diagonal().prod());
}

class Peeling {
public:
    explicit Peeling(const Mesh& mesh)
        : mesh_(mesh),
          complex_(mesh.simplices),
          n_(complex_.dimension()),
          around_(complex_.coface_counts(n_ - 1).begin(), complex_.coface_counts(n_ - 1).end()),
          is_left_out_(static_cast<std::size_t>(mesh.simplices.rows()), false) {
        for (int k = 0; k < n_; ++k)
            on_boundary_.emplace_back(static_cast<std::size_t>(complex_.size(k)), 0);
        for (Index f = 0; f < complex_.size(n_ - 1); ++f)
            if (around_[f] == 1)
                count_faces(f, 1);
        find_flat();
    }

    /// Marks the rows to be left out.
    const std::vector<bool>& run() {
        std::vector<Index> last_round(complex_.size(0), -1);
        bool any = true;
        for (Index round = 0; any; ++round) {
            any = false;
            std::vector<Index> stay;
            for (const Index t : flat_) {
                const auto corners = complex_.simplices(n_).row(t);
                const bool is_free = std::none_of(corners.begin(), corners.end(),
                                                  [&](Index v) { return last_round[v] == round; });
                if (!is_free || !can_go(t)) {
                    stay.push_back(t);
                    continue;
                }
                take_away(t);
                any = true;
                for (const Index v : corners)
                    last_round[v] = round;
            }
            flat_ = std::move(stay);
        }
        return is_left_out_;
    }

private:
    /// The face of t that has the corners of a set of bits alone.
    Index face(Index t, unsigned corners) const {
        for (int k = n_, i = n_; i >= 0; --i)
            if ((corners >> i & 1U) == 0)
                t = complex_.face(k--, t, i);
        return t;
    }

    /// Adds to the number of facets on the boundary that the faces of one belong to.
    void count_faces(Index facet, Index change) {
        std::vector<std::pair<int, Index>> faces{{n_ - 1, facet}};
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const auto [k, s] = faces[i];
            on_boundary_[k][s] += change;
            for (int omitted = 0; omitted <= k && k > 0; ++omitted)
                faces.emplace_back(k - 1, complex_.face(k, s, omitted));
            std::sort(faces.begin() + static_cast<std::ptrdiff_t>(i) + 1, faces.end(),
                      std::greater<>());
            faces.erase(
                std::unique(faces.begin() + static_cast<std::ptrdiff_t>(i) + 1, faces.end()),
                faces.end());
        }
    }

    void find_flat();

    bool can_go(Index t) const {
        unsigned apexes = 0;
        int free = 0;
        for (int i = 0; i <= n_; ++i)
            if (around_[complex_.face(n_, t, i)] == 1) {
                apexes |= 1U << i;
                ++free;
            }
        return free > 0 && free < n_ && on_boundary_[free - 1][face(t, apexes)] == 0;
    }

    void take_away(Index t) {
        is_left_out_[complex_.input_row(t)] = true;
        for (int i = 0; i <= n_; ++i) {
            const Index f = complex_.face(n_, t, i);
            if (around_[f]-- <= 2)
                count_faces(f, around_[f] == 1 ? 1 : -1);
        }
    }

    const Mesh& mesh_;
    SimplicialComplex complex_;
    int n_;
    std::vector<Index> around_; // cells at each facet
    std::vector<bool> is_left_out_;
    std::vector<std::vector<Index>> on_boundary_; // facets there, by degree and face
    std::vector<Index> flat_;
};

void Peeling::find_flat() {
    constexpr double low = 1e-2; // of an edge
    Vector shortest = Vector::Constant(complex_.size(0), std::numeric_limits<double>::infinity());
    for (const auto& edge : complex_.simplices(1).rowwise()) {
        const double length = distance(mesh_.points, complex_.vertex_number(edge[0]),
                                       complex_.vertex_number(edge[1]));
        for (const Index v : edge)
            shortest[v] = std::min(shortest[v], length);
    }
    for (Index t = 0; t < complex_.size(n_); ++t) {
        const auto corners = complex_.vertex_numbers(n_, t);
        double edge = std::numeric_limits<double>::infinity(), facet = 0;
        for (int i = 0; i <= n_; ++i) {
            edge = std::min(edge, shortest[complex_.simplices(n_)(t, i)]);
            facet = std::max(
                facet, parallelepiped(mesh_.points,
                                      complex_.vertex_numbers(n_ - 1, complex_.face(n_, t, i))));
        }
        if (parallelepiped(mesh_.points, corners) <= low * edge * facet)
            flat_.push_back(t);
    }

    // by the ascending places of their corners
    const auto before = [this](Index v, Index w) {
        const auto a = mesh_.points.row(v), b = mesh_.points.row(w);
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::vector<std::pair<std::vector<Index>, Index>> order;
    for (const Index t : flat_) {
        order.emplace_back(complex_.vertex_numbers(n_, t), t);
        std::sort(order.back().first.begin(), order.back().first.end(), before);
    }
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
        return std::lexicographical_compare(a.first.begin(), a.first.end(), b.first.begin(),
                                            b.first.end(), before);
    });
    for (std::size_t i = 0; i < order.size(); ++i)
        flat_[i] = order[i].second;
}

} // namespace

Mesh peeled(Mesh mesh) {
    mesh = tidy(std::move(mesh), CellsWithoutVolume::keep);
    if (mesh.dimension() < 2 || mesh.ambient_dimension() != mesh.dimension())
        throw InvalidInput(
            fmt::format("cannot peel cells of dimension {} between points of {} coordinates: "
                        "expected as many coordinates as dimensions, and at least 2",
                        mesh.dimension(), mesh.ambient_dimension()));
    const auto is_left_out = Peeling(mesh).run();
    const auto count = std::count(is_left_out.begin(), is_left_out.end(), true);
    if (count == 0)
        return mesh;
    keep_rows(mesh, is_left_out);
    mesh.warnings.push_back(
        fmt::format("peeled {} off the boundary", counted(count, "flat cell", "flat cells")));
    return mesh;
}

} // namespace polydec
