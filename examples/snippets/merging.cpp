// SPDX-License-Identifier: MIT
//
// The code on docs/merging.md: merged cells, the maps between both complexes, the lift, operators
// on the input simplices, consistent dual forms.
#include <cstdlib>
#include <iostream>
#include <polydec.h>

namespace {

void print_cells(const char* name, const polydec::CellComplex& complex) {
    std::cout << name;
    for (int k = 0; k <= complex.dimension(); ++k)
        std::cout << ' ' << complex.size(k);
    std::cout << '\n';
}

void two_cubes() {
    const auto cubes = polydec::discretize(polydec::kuhn({2, 1, 1}));
    print_cells("simplices:", cubes.input());
    print_cells("merged:   ", cubes.complex());
    for (polydec::Index e = 0; e < cubes.input().size(1); ++e) {
        const auto carrier = cubes.merging().carriers(1)[e];
        if (carrier.dimension == 3) // a space diagonal
            std::cout << "edge " << cubes.input().simplices(1).row(e) << " lies in cell "
                      << carrier.cell << '\n';
    }
}

double norm(const polydec::SparseMatrix& matrix) {
    return matrix.norm() < 1e-12 ? 0 : matrix.norm();
}

void laws_of_the_maps() {
    const auto mesh = polydec::discretize(polydec::uv_sphere(12, 6));
    const auto& K = mesh.input();
    const auto& P = mesh.complex();
    const auto dia = [&](int k) { return polydec::primal_to_merged(mesh.merging(), k); };
    const auto R = [&](int k) {
        return polydec::primal_to_input(mesh.merging(), mesh.geometry().volumes(), k);
    };
    const auto& S = mesh.merged().lift();

    const polydec::SparseMatrix dK = polydec::derivative(K, 1), dP = polydec::derivative(P, 1);
    std::cout << "dia d - d dia:     " << norm(dia(2) * dK - dP * dia(1)) << '\n'
              << "d S - S d:         " << norm(dK * S[1] - S[2] * dP) << '\n'
              << "d R - R d:         " << norm(dK * R(1) - R(2) * dP) << '\n';
    const polydec::Vector x = polydec::Vector::Random(P.size(1));
    std::cout << "dia S x - x:       " << ((dia(1) * S[1] * x - x).norm() < 1e-12 ? 0 : 1) << '\n'
              << "dia R x - x:       " << ((dia(1) * R(1) * x - x).norm() < 1e-12 ? 0 : 1) << '\n';
}

void on_the_triangles() {
    const auto mesh = polydec::discretize(polydec::grid(4, 4));
    const polydec::SparseMatrix inverse_star(polydec::star(mesh, 1).inverse().asDiagonal());
    const polydec::SparseMatrix on_triangles =
        polydec::on_input(mesh, inverse_star, {polydec::Side::dual, 1}, {polydec::Side::primal, 1});
    std::cout << "on the merged edges " << inverse_star.rows() << ", on the edges "
              << on_triangles.rows() << ", largest entry " << on_triangles.coeffs().maxCoeff()
              << '\n';
}

void consistent_forms() {
    const auto mesh = polydec::discretize(polydec::grid(4, 4));
    const polydec::Cochain copied =
        polydec::to_input(mesh, {polydec::Side::dual, 0, polydec::Vector::LinSpaced(16, 1, 16)});
    polydec::Cochain spoiled = copied;
    spoiled.values[0] += 0.25;
    for (const auto& form : {copied, spoiled}) {
        const auto report = polydec::consistency(mesh, form);
        std::cout << "worst deviation " << report.worst << ' ' << report.description << '\n';
    }
}

} // namespace

int main() {
    std::srand(1);
    two_cubes();
    laws_of_the_maps();
    on_the_triangles();
    consistent_forms();
}
