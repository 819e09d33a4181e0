// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::uv_sphere(16, 8));
    const auto modes = polydec::spectrum({sphere, polydec::Side::dual, 0}, {.count = 4});

    std::cout << "polydec " << CONSUMER_EXPECTS_VERSION << ": on the sphere 2 is about "
              << modes.eigenvalues[3] << ", factorized by " << modes.linear_solver << '\n';
    return modes.certificate.complete && std::abs(modes.eigenvalues[3] - 2) < 0.2 ? 0 : 1;
}
