// SPDX-License-Identifier: MIT
//
// The metric enters through the Hodge star. It maps the integral of a form over a cell to an
// integral over the dual cell, which connects circumcenters. Dual volumes are signed, so triangles
// may be obtuse. The sum of |s| |*s| is C(n,k) times the area on every mesh.
#include <iostream>
#include <polydec.h>

int main() {
    const auto mesh = polydec::discretize(polydec::well_centered(8));
    const auto& P = mesh.complex();

    const double binomial[] = {1, 2, 1}; // 2 over k
    for (int k = 0; k <= 2; ++k) {
        const polydec::Vector star = polydec::star(mesh, k).diagonal();
        std::cout << "star_" << k << " from " << star.minCoeff() << " to " << star.maxCoeff()
                  << "; sum |s||*s| / C(2," << k
                  << ") = " << mesh.volumes().primal(k).dot(mesh.volumes().dual(k)) / binomial[k]
                  << '\n';
    }

    // the flux of the field (2,1) through dual edges, from its circulation along edges
    const auto circulation = polydec::de_rham(
        mesh, 1, [](const polydec::Vector&) { return polydec::Vector(Eigen::Vector2d(2, 1)); });
    const auto flux = polydec::star({P, mesh.volumes()}, circulation);
    const auto back = polydec::star({P, mesh.volumes()}, flux);
    std::cout << "|X|^2 times the area: "
              << polydec::inner_product({P, mesh.volumes()}, circulation, circulation) << '\n';
    std::cout << "star star = " << back.values[0] / circulation.values[0]
              << " on 1-forms in the plane\n";
}
