// SPDX-License-Identifier: MIT
//
// DEC preserves Stokes' theorem: the integral of dw over a region equals the integral of w over its
// boundary, to the last digit, on any mesh, before and after merging. Only the integration of w
// over edges is approximate, and it is exact for polynomials of low degree.
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::uv_sphere(24, 12));
    const auto& P = sphere.complex();

    // the circulation of (-y, x, 0), with curl 2 along the axis
    const auto w = polydec::de_rham(sphere, 1, [](const polydec::Vector& p) {
        return polydec::Vector(Eigen::Vector3d(-p[1], p[0], 0));
    });

    // the northern hemisphere as a chain of merged cells
    const auto centers = polydec::cell_centers(sphere, 2);
    polydec::Chain north{polydec::Side::primal, 2, (centers.col(2).array() > 0).cast<double>()};

    const double inside = polydec::pairing(polydec::d(P, w), north);
    const double along = polydec::pairing(w, polydec::boundary(P, north));
    std::cout << "integral of dw over the north: " << inside
              << "\nintegral of w along the equator: " << along << "\ndifference "
              << (std::abs(inside - along) < 1e-13 ? "0" : "not 0")
              << ", on the round sphere both are " << 2 * std::acos(-1.0) << '\n';
}
