// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/circumsphere.h"
#include "dec/metric/geometry.h"

namespace polydec {

/// Decides whether k-simplices f and g form one flat piece across their common (k-1)-face s. Their
/// circumcenters must coincide, also relative to their heights over s, and their duals agree. If s
/// is on the boundary, they must lie in one k-plane up to an angle; inside, this follows. Curved
/// complexes, and lengths alone, have no such plane: for k = n-1 the angles of the n-simplices
/// around s must sum to pi; for smaller k there is no third condition.
class StraightnessTest {
public:
    StraightnessTest(const Geometry& geometry, double tolerance, double angle);

    // no copies: their references would point into another object
    StraightnessTest(const StraightnessTest&) = delete;
    StraightnessTest& operator=(const StraightnessTest&) = delete;

    bool operator()(int k, Index s, Index f, Index g);

private:
    /// Geometry of f or g relative to s.
    struct Wing {
        int apex;        ///< the simplex's vertex that is not in s
        double height;   ///< signed distance from the circumcenter of s to the simplex's
        double terms;    ///< terms that cancel in it
        double altitude; ///< of the apex over s
    };
    Wing look(int k, Index s, Index f);

    /// Looked up once.
    struct Degree {
        FaceTable faces;
        const Vector &primal, &dual;
        const Bounds& terms;
    };

    /// The unit vector orthogonal to s from s to the apex.
    Vector upwards(int k, Index s, Index f, int apex) const;

    Geometry geometry_;
    const Pieces& complex_;
    std::vector<Degree> degrees_; // at k - 1: for k = 1, .., n
    double tolerance_, angle_;
    SimplexLayout layout_;
    Circumsphere sphere_; // looks at one simplex at a time
    bool is_flat_ = false;
    std::vector<std::vector<bool>> must_be_coplanar_; // by degree of s
    Vector angles_;                                   // around (n-2)-simplices, unless it is flat
};

} // namespace polydec
