// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/exterior_product.h"
#include "dec/metric/geometry.h"

#include <vector>

namespace polydec {

/// The spheres of classes of n-simplices in R^n: about the mean of their circumcenters, weighted
/// by volume; flat simplices do not count. A class goes by its first member, its root.
class MeanSpheres {
public:
    /// `flat` is empty or has a mark for each n-simplex. Keeps a reference to it.
    MeanSpheres(const Geometry& geometry, const std::vector<bool>& flat);

    /// Takes the mean over other classes: roots[t] is that of n-simplex t.
    void gather(const std::vector<Index>& roots);

    /// What is known of a class, in the row of its root.
    struct Means {
        Points origins;            ///< first corner of its first simplex
        Points centers;            ///< from there
        Points terms;              ///< see Centers::of_cells
        std::vector<Index> counts; ///< of simplices
        Vector sides;              ///< sum of own_side, where simplices are flat
    };

    /// The same with means that were taken elsewhere, of classes that have members elsewhere.
    void gather(const std::vector<Index>& roots, Means means);

    /// What simplex t adds to the means, times its volume: its circumcenter, from its first corner,
    /// and its terms.
    auto own_center(Index t) const { return own_.row(t); }
    auto own_terms(Index t) const { return terms_.row(t); }

    /// Volume of simplex t, negative if it lies outside of its facets as its orientation goes; 0 if
    /// it is flat.
    double own_side(Index t) const;

    /// How far vertex v is from the sphere of a class: | |v - c|^2 - r^2 | / 2r; length.
    double distance(Index root, Index v) const;

    /// Distance of the centers of two classes.
    double between(Index root, Index other) const;

    double radius(Index root) const { return radii_[root]; }

    /// One center for each class of several simplices, its mean; others keep their own. On which
    /// side of a facet a flat simplex lies is told by the orientation that it shares with its
    /// neighbors, since it has no inside. So the heights over a facet between two simplices of a
    /// class cancel exactly.
    Centers shared_centers() const;

private:
    bool is_flat(Index t) const { return !flat_.empty() && flat_[t]; }
    Vector normal(Index t, int i) const; // of the facet that lacks corner i
    Eigen::RowVectorXd away(Index root, Index v) const;

    Pieces complex_;
    SimplexMetric metric_;
    const Points& points_; // of the metric
    CellVolumes volumes_;
    const std::vector<bool>& flat_;
    ExteriorProduct normal_;
    Points own_;     // circumcenter of each simplex, from its first corner
    Points moments_; // of its own circumcenter, see Centers
    Points terms_;
    std::vector<Index> roots_;
    Means means_;
    Vector radii_;
};

} // namespace polydec
