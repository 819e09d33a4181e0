// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/circumsphere.h"
#include "dec/metric/geometry.h"

namespace polydec {

/// Decides whether two k-simplices f and g are one flat piece across their common (k-1)-face s:
/// their circumcenters coincide, also against their heights over s, their duals agree, and, where s
/// lies on the boundary, they lie in one k-plane, but for an angle. Inside, the first two imply the
/// third. On a curved complex, and where only lengths are known, there is no such plane: the angles
/// of the n-simplices around s add up to pi, for k = n-1, and for smaller k nothing is asked.
class StraightnessTest {
public:
    StraightnessTest(const Geometry& geometry, double tolerance, double angle);

    // no copies, whose parts would refer to those of another
    StraightnessTest(const StraightnessTest&) = delete;
    StraightnessTest& operator=(const StraightnessTest&) = delete;

    bool operator()(int k, Index s, Index f, Index g);

private:
    /// What f and g look like from s.
    struct Wing {
        int apex;        ///< which of the simplex's vertices is not in s
        double height;   ///< signed distance from the circumcenter of s to that of the simplex
        double terms;    ///< what cancels in it
        double altitude; ///< of the apex over s
    };
    Wing look(int k, Index s, Index f);

    /// What of the edge from s to the apex is orthogonal to s: its length, and a unit vector.
    struct Altitude {
        double length;
        Vector direction;
    };
    Altitude altitude(int k, Index s, Index f, int apex) const;

    Geometry geometry_;
    const Pieces& complex_;
    const CellVolumes& volumes_;
    double tolerance_, angle_;
    SimplexLayout layout_;
    Circumsphere sphere_; // looks at one simplex after the other
    bool is_flat_ = false;
    std::vector<std::vector<bool>> must_be_coplanar_; // by degree of s
    Vector angles_;                                   // around (n-2)-simplices, unless it is flat
};

} // namespace polydec
