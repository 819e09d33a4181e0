// SPDX-License-Identifier: MIT
//
// The eigenvalues of the Laplacian on the unit sphere are l (l + 1), with multiplicity 2 l + 1.
// Iterative eigensolvers may silently miss copies of such multiple eigenvalues; here every answer
// is proved complete. The mesh has planar hexagons and pentagons. Each is input as a fan of
// triangles, and merged again because its corners lie on one circle.
#include <iostream>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::goldberg(8));
    for (const auto side : {polydec::Side::primal, polydec::Side::dual}) {
        const auto modes = polydec::spectrum({sphere, side, 0}, {.count = 16});
        std::cout << polydec::name(side) << " 0-forms, " << modes.certificate.below_shift
                  << " eigenvalues below " << modes.certificate.shift << " by inertia, "
                  << modes.certificate.returned_below_shift << " computed\n";
        for (polydec::Index l = 0; l <= 3; ++l)
            std::cout << "  l = " << l << ": " << 2 * l + 1 << " eigenvalues from "
                      << modes.eigenvalues[l * l] << " to "
                      << modes.eigenvalues[(l + 1) * (l + 1) - 1] << ", exact " << l * (l + 1)
                      << '\n';
    }
}
