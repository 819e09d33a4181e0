// SPDX-License-Identifier: MIT
#include "meshes/delaunay.h"

#include "base/decompositions.h"
#include "base/errors.h"
#include "base/random.h"
#include "meshes/edges.h"
#include "meshes/generate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace polydec {

namespace {

[[noreturn]] void refuse_rounding() {
    throw InvalidInput("delaunay_in_cube: points nearly coincide, and rounding spoils the "
                       "triangulation; use another seed");
}

constexpr int most_dimensions = 6;
constexpr Index nobody = -1;

// Extended precision makes the random heights visible in slivers, too.
using Real = long double;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, most_dimensions + 1,
                                 most_dimensions + 1>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, most_dimensions + 1, 1>;
using SimplexCorners =
    std::array<Index, most_dimensions + 1>; // of a simplex, nobody behind the last

class Triangulation {
public:
    /// Of the unit cube's corners, which are the first points, in the order of kuhn(n, 1).
    Triangulation(const Points& points, Vector heights)
        : points_(points), heights_(std::move(heights)), n_(static_cast<int>(points.cols())) {
        const Mesh cube = kuhn(n_, 1);
        for (Index c = 0; c < cube.simplices.rows(); ++c) {
            SimplexCorners corners = none();
            for (int i = 0; i <= n_; ++i)
                corners[i] = cube.simplices(c, i);
            add_cell(corners);
        }
        connect_new_cells();
    }

    /// Replaces the cells whose circumsphere holds vertex p by cones over what bounds them.
    void insert(Index p) {
        find_cavity(p);
        find_bases(p);
        for (const Index c : cavity_) {
            in_cavity_[c] = false;
            cells_[c] = none();
            unused_.push_back(c);
        }
        for (const Base& base : bases_) {
            const Index c = add_cell(base.corners);
            neighbors_[c][base.apex] = base.outside;
            if (base.outside != nobody)
                neighbors_[base.outside][base.back] = c;
        }
        connect_new_cells();
    }

    Simplices cells() const {
        Simplices result(static_cast<Eigen::Index>(cells_.size() - unused_.size()), n_ + 1);
        Eigen::Index row = 0;
        for (const SimplexCorners& corners : cells_)
            if (corners[0] != nobody) {
                for (int i = 0; i <= n_; ++i)
                    result(row, i) = corners[i];
                ++row;
            }
        return result;
    }

private:
    /// A facet around the cavity, with the new vertex at its apex.
    struct Base {
        SimplexCorners corners;
        int apex;
        Index outside;
        int back; ///< place of the facet in the cell outside
    };
    /// A facet of a new cell, known by its corners.
    struct NewFacet {
        SimplexCorners corners; ///< ascending
        Index cell;
        int opposite;
    };

    static SimplexCorners none() {
        SimplexCorners result;
        result.fill(nobody);
        return result;
    }

    RealVector edge(Index from, Index to) const {
        return (points_.row(to) - points_.row(from)).cast<Real>().transpose();
    }

    Index add_cell(const SimplexCorners& corners) {
        if (unused_.empty()) {
            unused_.push_back(static_cast<Index>(cells_.size()));
            cells_.emplace_back();
            neighbors_.emplace_back();
            in_cavity_.push_back(false);
        }
        const Index c = unused_.back();
        unused_.pop_back();
        cells_[c] = corners;
        neighbors_[c] = none();
        new_cells_.push_back(c);
        return c;
    }

    /// Facets that two new cells have in common make them neighbors.
    void connect_new_cells() {
        new_facets_.clear();
        for (const Index c : new_cells_)
            for (int i = 0; i <= n_; ++i)
                if (neighbors_[c][i] == nobody) {
                    SimplexCorners corners = cells_[c];
                    corners[i] = nobody;
                    std::sort(corners.begin(), corners.end());
                    new_facets_.push_back({corners, c, i});
                }
        const auto by_corners = [](const NewFacet& a, const NewFacet& b) {
            return a.corners < b.corners;
        };
        std::sort(new_facets_.begin(), new_facets_.end(), by_corners);
        for (std::size_t i = 1; i < new_facets_.size(); ++i) {
            const NewFacet &a = new_facets_[i - 1], &b = new_facets_[i];
            if (a.corners == b.corners) {
                neighbors_[a.cell][a.opposite] = b.cell;
                neighbors_[b.cell][b.opposite] = a.cell;
            }
        }
        last_ = new_cells_.back();
        new_cells_.clear();
    }

    /// Walks towards vertex p, always through the facet that p is farthest behind.
    Index cell_with(Index p) const {
        Index c = last_;
        for (std::size_t steps = 0; steps <= cells_.size(); ++steps) {
            const SimplexCorners& corners = cells_[c];
            RealMatrix edges(n_, n_);
            for (int i = 1; i <= n_; ++i)
                edges.col(i - 1) = edge(corners[0], corners[i]);
            RealVector weights(n_ + 1);
            weights.tail(n_) = edges.partialPivLu().solve(edge(corners[0], p));
            weights[0] = 1 - weights.tail(n_).sum();
            int worst = 0;
            const Real least = weights.minCoeff(&worst);
            if (least >= -1e-15L || neighbors_[c][worst] == nobody)
                break;
            c = neighbors_[c][worst];
        }
        return c;
    }

    /// Whether vertex p lies in the circumsphere of cell c. On the paraboloid over R^n, raised by
    /// the heights, that is to be below the plane through the corners.
    bool holds(Index c, Index p) const {
        RealMatrix lifted(n_ + 1, n_ + 1);
        for (int i = 0; i <= n_; ++i) {
            const RealVector arm = edge(p, cells_[c][i]);
            lifted.row(i).head(n_) = arm.transpose();
            lifted(i, n_) = arm.squaredNorm() + heights_[cells_[c][i]] - Real(heights_[p]);
        }
        return (n_ % 2 == 0 ? 1 : -1) * lifted.determinant() > 0;
    }

    void find_cavity(Index p) {
        cavity_.assign(1, cell_with(p));
        in_cavity_[cavity_[0]] = true;
        for (std::size_t next = 0; next < cavity_.size(); ++next)
            for (int i = 0; i <= n_; ++i) {
                const Index other = neighbors_[cavity_[next]][i];
                if (other != nobody && !in_cavity_[other] && holds(other, p)) {
                    in_cavity_[other] = true;
                    cavity_.push_back(other);
                }
            }
    }

    /// Facets around the cavity but those in a side of the cube that vertex p lies in itself.
    void find_bases(Index p) {
        bases_.clear();
        for (const Index c : cavity_)
            for (int i = 0; i <= n_; ++i) {
                const Index outside = neighbors_[c][i];
                if (outside == nobody ? lies_beside(c, i, p) : in_cavity_[outside])
                    continue;
                Base base{cells_[c], i, outside, 0};
                base.corners[i] = p;
                while (outside != nobody && neighbors_[outside][base.back] != c)
                    if (++base.back > n_)
                        refuse_rounding();
                bases_.push_back(base);
            }
    }

    bool lies_beside(Index c, int opposite, Index p) const {
        for (int axis = 0; axis < n_; ++axis) {
            bool is_flat = true;
            for (int i = 0; i <= n_; ++i)
                is_flat =
                    is_flat && (i == opposite || points_(cells_[c][i], axis) == points_(p, axis));
            if (is_flat)
                return true;
        }
        return false;
    }

    const Points& points_;
    Vector heights_;
    int n_;
    std::vector<SimplexCorners> cells_, neighbors_; // neighbor i misses corner i
    std::vector<Index> unused_;                     // places for new cells
    std::vector<char> in_cavity_;
    std::vector<Index> cavity_, new_cells_;
    std::vector<Base> bases_;
    std::vector<NewFacet> new_facets_;
    Index last_ = 0;
};

/// The points from `first` on in random rounds, each twice the one before and sorted along a curve
/// that fills the cube: so that walks are short, and yet the order is random.
std::vector<Index> insertion_order(const Points& points, Index first, Random& random) {
    std::vector<Index> order = random.order(points.rows() - first);
    for (Index& p : order)
        p += first;
    const auto n = points.cols();
    const auto bits_per_axis = 60 / n;
    std::vector<std::uint64_t> morton(points.rows(), 0);
    for (const Index p : order)
        for (auto bit = bits_per_axis; bit-- > 0;)
            for (Eigen::Index axis = 0; axis < n; ++axis) {
                const auto digits =
                    static_cast<std::uint64_t>(std::ldexp(points(p, axis), bits_per_axis));
                morton[p] = morton[p] << 1U | (digits >> bit & 1U);
            }
    for (std::size_t end = order.size(); end > 0; end /= 2)
        std::sort(order.begin() + static_cast<std::ptrdiff_t>(end / 2),
                  order.begin() + static_cast<std::ptrdiff_t>(end),
                  [&](Index a, Index b) { return morton[a] < morton[b]; });
    return order;
}

void check_volumes(const Mesh& mesh) {
    double sum = 0.0, least = 1.0, unit = 1.0;
    for (int k = 2; k <= mesh.dimension(); ++k)
        unit /= k;
    for (Eigen::Index c = 0; c < mesh.simplices.rows(); ++c) {
        const double volume =
            unit * edges_at_first(mesh.points, mesh.simplices.row(c)).determinant();
        sum += volume;
        least = std::min(least, volume);
    }
    if (!(least > 0.0) || !(std::abs(sum - 1.0) <= 1e-9))
        refuse_rounding();
}

} // namespace

Mesh delaunay_in_cube(const Points& points, double spacing, std::uint64_t seed) {
    Random random(seed);
    const Vector heights = 1e-7 * spacing * spacing * random.point(static_cast<int>(points.rows()));
    Triangulation triangulation(points, heights);
    const Index corners = Index(1) << points.cols();
    for (const Index p : insertion_order(points, corners, random))
        triangulation.insert(p);

    Mesh mesh;
    mesh.points = points;
    mesh.simplices = triangulation.cells();
    check_volumes(mesh);
    return mesh;
}

} // namespace polydec
