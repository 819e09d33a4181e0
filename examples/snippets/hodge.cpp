// SPDX-License-Identifier: MIT
//
// The code on docs/hodge.md: decomposition, harmonic forms and generators on a flat ring.
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

/// The ring 1 <= r <= 2 in quads, each split into two concyclic triangles.
polydec::Mesh ring(int around, int across) {
    polydec::Mesh mesh;
    mesh.points.resize(around * (across + 1), 2);
    mesh.simplices.resize(2 * around * across, 3);
    const auto at = [&](int i, int j) { return (i % around) * (across + 1) + j; };
    int row = 0;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j <= across; ++j) {
            const double angle = 2 * std::numbers::pi * i / around, r = 1 + double(j) / across;
            mesh.points.row(at(i, j)) << r * std::cos(angle), r * std::sin(angle);
            if (j == across)
                continue;
            mesh.simplices.row(row++) << at(i, j), at(i, j + 1), at(i + 1, j + 1);
            mesh.simplices.row(row++) << at(i, j), at(i + 1, j + 1), at(i + 1, j);
        }
    return mesh;
}

void decompose() {
    const auto mesh = polydec::discretize(ring(48, 8));
    const auto w = polydec::de_rham(mesh, 1, polydec::circulation_form([](const auto& p) {
                                        return polydec::Vector{{p[0] - p[1], p[0]}};
                                    }));
    const auto parts = polydec::hodge_decomposition({mesh, polydec::Side::primal, 1}, w);

    const auto energy = [&](const polydec::Cochain& form) {
        return polydec::inner_product(mesh, form, form);
    };
    std::cout << energy(w) << " = " << energy(parts.exact) << " + " << energy(parts.coexact)
              << " + " << energy(parts.harmonic) << '\n';
}

void harmonic() {
    const auto mesh = polydec::discretize(ring(48, 8));
    const polydec::DenseMatrix h = polydec::harmonic_forms({mesh, polydec::Side::primal, 1});
    const polydec::SparseMatrix loops = polydec::homology_generators(mesh.complex(), 1);
    const polydec::Vector period = loops.transpose() * h.col(0);
    const double exact = std::sqrt(2 * std::numbers::pi / std::log(2.0));
    std::cout << h.cols() << " harmonic 1-form of period " << std::abs(period[0]) << ", exact "
              << exact << '\n';
}

void relative() {
    const auto mesh = polydec::discretize(ring(48, 8));
    std::cout << "harmonic forms of degree 0, 1, 2:";
    for (const auto condition :
         {polydec::BoundaryCondition::natural, polydec::BoundaryCondition::essential}) {
        std::cout << (condition == polydec::BoundaryCondition::natural ? " absolute"
                                                                       : ", relative");
        for (int k = 0; k <= 2; ++k)
            std::cout
                << ' '
                << polydec::harmonic_forms({mesh, polydec::Side::primal, k, {condition}}).cols();
    }
    std::cout << '\n';
}

} // namespace

int main() {
    decompose();
    harmonic();
    relative();
}
