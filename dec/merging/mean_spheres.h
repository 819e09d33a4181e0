// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/exterior_product.h"
#include "dec/metric/geometry.h"

#include <vector>

namespace polydec {

/// Spheres of classes of n-simplices in R^n, centered at the mean of their circumcenters weighted
/// by volume; flat simplices do not count. A class is represented by its first member, its root.
class MeanSpheres {
public:
    /// `flat`: empty, or one mark per n-simplex. Keeps a reference to it.
    MeanSpheres(const Geometry& geometry, const std::vector<bool>& flat);

    /// Computes the means over other classes: roots[t] is the root of n-simplex t.
    void gather(const std::vector<Index>& roots);

    /// Data of a class, in the row of its root.
    struct Means {
        Points origins;            ///< first corner of its first simplex
        Points centers;            ///< relative to the origin
        Points terms;              ///< see Centers::of_cells
        std::vector<Index> counts; ///< of simplices
        Vector sides;              ///< sum of own_side, if any simplices are flat
    };

    /// The same with means computed elsewhere, of classes with members elsewhere.
    void gather(const std::vector<Index>& roots, Means means);

    /// Contribution of simplex t to the means, times its volume: its circumcenter, relative to its
    /// first corner, and its terms.
    auto own_center(Index t) const { return own_.row(t); }
    auto own_terms(Index t) const { return terms_.row(t); }

    /// Volume of simplex t, negative if by its orientation it lies outside its facets; 0 if flat.
    double own_side(Index t) const;

    /// Distance of vertex v from the sphere of a class: | |v - c|^2 - r^2 | / 2r; length.
    double distance(Index root, Index v) const;

    /// Distance between the centers of two classes.
    double between(Index root, Index other) const;

    double radius(Index root) const { return radii_[root]; }

    /// One center for each class of several simplices, its mean; others keep their own center. A
    /// flat simplex has no inside, so the orientation shared with its neighbors decides on which
    /// side of a facet it lies. So the heights over a facet between two simplices of a class cancel
    /// exactly.
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
