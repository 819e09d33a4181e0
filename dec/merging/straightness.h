// SPDX-License-Identifier: MIT
#pragma once

#include "complex/components.h"
#include "dec/metric/angle_sums.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/geometry.h"
#include "dec/metric/simplex_faces.h"

#include <optional>
#include <vector>

namespace polydec {

/// Decides whether k-simplices f and g form one flat piece across their common (k-1)-face s. Their
/// circumcenters must coincide, also relative to their heights over s, and their duals agree. They
/// must lie in one k-plane up to an angle: the tolerance, or on the boundary `angle`. Curved
/// complexes, and lengths alone, have no such plane: for k = n-1 the angles of the n-simplices
/// around s, from f to g on each side, must sum to pi; for smaller k there is no third condition.
class StraightnessTest {
public:
    StraightnessTest(const Geometry& geometry, double tolerance, double angle);

    // no copies: their references would point into another object
    StraightnessTest(const StraightnessTest&) = delete;
    StraightnessTest& operator=(const StraightnessTest&) = delete;

    /// f and g are all that remains of the k-simplices around s.
    bool operator()(int k, Index s, Index f, Index g);

private:
    /// Geometry of f or g relative to s.
    struct Wing {
        Index apex;      ///< the simplex's vertex that is not in s
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

    /// Whether the angles sum to pi.
    bool is_unfolded(Index s, Index f, Index g, double limit);

    Geometry geometry_;
    const Pieces& complex_;
    std::vector<Degree> degrees_; // at k - 1: for k = 1, .., n
    double tolerance_, angle_;
    SimplexLayout layout_;
    Circumsphere sphere_;   // looks at one simplex at a time
    Heights heights_;       // over s
    CellMarks on_boundary_; // where n > 2

    /// What is known of n-simplices without a common space.
    struct Angles {
        SimplexFaces faces; ///< of dimension n-2
        DenseMatrix of;     ///< each simplex (row) at each of these faces
        Cofaces cofaces;    ///< of facets
    };
    std::optional<Angles> angles_; // unless the complex is flat
};

} // namespace polydec
