// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <polydec.h>
#include <string>
#include <vector>

namespace polydec::paper {

using Function = std::function<double(const Vector& point)>;

/// The function at each row of points.
Vector values(const Function& function, const Points& sites);

/// Franke's function on the unit square. The last term of the paper's Eq. 9 is misprinted: it is
/// -1/5 exp(-(9x-4)^2 - (9y-7)^2). Source: Franke 1979.
double franke(const Vector& point);

/// -div grad of Franke's function.
double franke_laplacian(const Vector& point);

/// The spherical harmonic (x^2 - y^2)(7 z^2 - r^2) / r^4 of degree 4: an eigenfunction of the
/// Laplacian on the unit sphere for eigenvalue 20. The paper prints 7 y^2, not an eigenfunction.
double harmonic(const Vector& point);

/// discretize with circumcentric stars of any sign, as in the paper.
Discretization discretized(Mesh mesh, DiscretizeOptions options = {});

/// A family of refined meshes.
struct Family {
    std::string name;
    std::function<Mesh(int level)> make;
};

/// The four families of the unit square in section 9.1, with 8, 16, 32 .. cells per side.
std::vector<Family> planar_families();

/// Spheres of quads (UV) and of hexagons with twelve pentagons (Goldberg).
std::vector<Family> sphere_families();

/// Lengths of the edges of the merged mesh; without boundary edges if there are interior edges.
Vector inner_edge_lengths(const Discretization& mesh);
double median(Vector numbers);

/// The volumes that belong to values of primal or dual 0-forms.
const Vector& masses(const Discretization& mesh, Side side);

/// Square root of the mass-weighted sum of squares.
double weighted_norm(const Vector& masses, const Vector& values);

/// Error of the paper's Eq. 12. The problem is solved for the normalized exact function, so the
/// error is relative to its norm.
double relative_error(const Vector& masses, const Vector& computed, const Vector& exact);

/// Two readings of the error of a solution of Delta u = 20 Y, Y the harmonic.
struct SphereError {
    double relative;   ///< relative_error
    double normalized; ///< u is also normalized, which hides an error in its size
};
SphereError sphere_error(const SparseMatrix& mass, const Vector& u, const Vector& Y);

/// The errors of this library on a sphere.
SphereError sphere_error(const Discretization& sphere, Side side);

/// The observed order between a level and the one before it.
double order_between(const std::vector<double>& sizes, const std::vector<double>& errors,
                     int level);

/// A missing number.
constexpr double none = std::numeric_limits<double>::quiet_NaN();

} // namespace polydec::paper
