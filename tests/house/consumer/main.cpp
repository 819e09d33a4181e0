// SPDX-License-Identifier: MIT
#include <iostream>
#include <polydec.h>

int main() {
    polydec::Mesh mesh;
    mesh.points.resize(3, 2);
    mesh.points << 0, 0, 1, 0, 0, 1;
    mesh.simplices.resize(1, 3);
    mesh.simplices << 0, 1, 2;

    std::cout << "polydec " << CONSUMER_EXPECTS_VERSION << ": a mesh of dimension "
              << mesh.dimension() << " in dimension " << mesh.ambient_dimension() << '\n';
    return mesh.dimension() == 2 && mesh.ambient_dimension() == 2 ? 0 : 1;
}
