// SPDX-License-Identifier: MIT
//
// Calculus on an arbitrary mesh. Obtuse triangles and flat tetrahedra have negative duals; diagonal
// stars are then no inner products, so there is no spectrum of 1-forms, no heat, no Hodge
// decomposition. Automatic stars are positive on every mesh: circumcentric where possible, and
// inner products of Whitney forms where necessary. `16_any_mesh MESH` takes your own mesh of
// triangles or tetrahedra.
#include <fstream>
#include <iostream>
#include <polydec.h>

namespace {

using polydec::Cochain;
using polydec::Index;

// its triangles, with cells of Galerkin stars in orange
void draw(const polydec::Discretization& mesh) {
    polydec::SolidFaces faces;
    faces.polygons.points = mesh.input_points();
    for (Index t = 0; t < mesh.input().size(2); ++t) {
        faces.polygons.add({mesh.input().simplices(2).row(t).data(), 3});
        const Index cell = mesh.merging().carriers(2)[t].cell;
        faces.fills.push_back(mesh.chosen_stars().galerkin[cell] ? "#f2a35e" : "#e4e9ef");
    }
    std::ofstream("any_mesh.svg") << polydec::to_svg(polydec::draw_solid(
        faces, {.line_width = 0.4, .title = "Orange: Galerkin's stars, the others circumcentric"}));
}

} // namespace

int main(int argc, char** argv) try {
    const polydec::Mesh input = argc > 1 ? polydec::read_mesh(argv[1])
                                         : polydec::perturbed(polydec::torus(40, 20), 0.035, 3);
    const auto mesh = polydec::discretize(input, {.star = polydec::StarKind::automatic});
    const auto& chosen = mesh.chosen_stars();
    std::cout << polydec::star(mesh.volumes(), 1).negatives().size() << " of "
              << mesh.complex().size(1)
              << " duals of edges are negative: " << polydec::name(chosen.kind)
              << " stars, Galerkin's on " << 100 * chosen.galerkin_share() << " % of the cells\n";

    const Index holes = polydec::betti_numbers(mesh.complex())[1];
    const auto found = polydec::spectrum({mesh, polydec::Side::primal, 1}, {.count = holes + 4});
    std::cout << "Betti number " << holes << ", smallest eigenvalues of 1-forms:";
    for (Index i = 0; i < found.eigenvalues.size(); ++i)
        std::cout << ' '
                  << (i < holes && found.eigenvalues[i] <= found.radii[i] ? 0
                                                                          : found.eigenvalues[i]);
    std::cout << (found.certificate.complete ? ", none is missing\n" : "\n");

    const auto wind = polydec::de_rham(mesh, 1, [](const polydec::Vector& p) {
        return polydec::Vector(Eigen::Vector3d(-p[1], p[0], p[0] > 0 ? 0.5 * p[0] : 0.0));
    });
    const auto parts = polydec::hodge_decomposition({mesh, polydec::Side::primal, 1}, wind);
    const auto energy = [&](const Cochain& a, const Cochain& b) {
        return polydec::inner_product(mesh, a, b);
    };
    const double all = energy(wind, wind);
    std::cout << "of the energy of a wind " << energy(parts.exact, parts.exact) / all
              << " is exact, " << energy(parts.coexact, parts.coexact) / all << " coexact, "
              << energy(parts.harmonic, parts.harmonic) / all << " harmonic; orthogonal to 1e-10: "
              << (std::abs(energy(parts.exact, parts.coexact)) < 1e-10 * all &&
                          std::abs(energy(parts.exact, parts.harmonic)) < 1e-10 * all &&
                          std::abs(energy(parts.coexact, parts.harmonic)) < 1e-10 * all
                      ? "yes\n"
                      : "no\n");
    if (mesh.dimension() == 2)
        draw(mesh);
} catch (const polydec::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
