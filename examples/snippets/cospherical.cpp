// SPDX-License-Identifier: MIT
//
// The code on docs/cospherical.md: cubes, octahedra, tetrahedra and tesseracts merged from
// simplices, the duals that vanish, and the operators. Writes the page's picture of the cells.
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <polydec.h>

namespace {

// number of k-cells with a dual of zero volume, in the interior and on the boundary
void print_zeros(const char* name, const polydec::CellComplex& complex,
                 const polydec::CellVolumes& volumes) {
    const auto boundary = polydec::boundary_cells(complex);
    std::cout << name;
    for (int k = 0; k <= complex.dimension(); ++k) {
        const polydec::Vector& dual = volumes.dual(k);
        polydec::Index inside = 0, outside = 0;
        for (polydec::Index s = 0; s < complex.size(k); ++s)
            if (std::abs(dual[s]) < 1e-9 * dual.maxCoeff())
                ++(boundary[k][s] ? outside : inside);
        std::cout << "  " << inside << '+' << outside << " of " << complex.size(k);
    }
    std::cout << '\n';
}

void all_zeros() {
    for (const auto& [name, mesh] : {std::pair("Kuhn", polydec::kuhn(3, 4)),
                                     {"BCC ", polydec::bcc(4)},
                                     {"FCC ", polydec::fcc(4)},
                                     {"4D  ", polydec::kuhn(4, 3)}}) {
        const auto result = polydec::discretize(mesh);
        print_zeros(name, result.input(), result.input_geometry().volumes());
        print_zeros("      ->", result.complex(), result.volumes());
    }
}

void shared_square() {
    const auto cubes = polydec::discretize(polydec::kuhn({2, 1, 1}, {2, 1, 1}));
    for (polydec::Index e = 0; e < cubes.input().size(1); ++e) {
        const auto carrier = cubes.merging().carriers(1)[e];
        const auto ends = cubes.input().simplices(1).row(e);
        const polydec::Points places = cubes.points()({ends[0], ends[1]}, Eigen::indexing::all);
        if (carrier.dimension == 2 && (places.col(0).array() == 1).all())
            std::cout << "the diagonal " << ends << " has a dual of area "
                      << std::abs(cubes.input_geometry().volumes().dual(1)[e])
                      << "; it lies in square " << carrier.cell << ", whose dual has the length "
                      << cubes.volumes().dual(2)[carrier.cell] << '\n';
    }
}

void shapes() {
    const auto lattice = polydec::discretize(polydec::fcc(4));
    std::map<std::size_t, int> shapes;
    for (polydec::Index cell = 0; cell < lattice.complex().size(3); ++cell)
        ++shapes[lattice.merging().vertices(3, cell).size()];
    for (const auto& [corners, cells] : shapes)
        std::cout << cells << " cells with " << corners << " corners\n";
}

void stencils() {
    const auto cubes = polydec::discretize(polydec::kuhn(3, 4));
    const double h = 0.25;
    const polydec::SparseMatrix laplacian = h * h * polydec::laplacian(cubes, 0).matrix();
    std::cout << "the vertex in the middle:";
    for (polydec::SparseMatrix::InnerIterator entry(laplacian, 62); entry; ++entry)
        std::cout << ' ' << entry.value();
    std::cout << '\n';

    const auto inside = polydec::relative_to_boundary(cubes.complex());
    const auto volumes = polydec::relative_volumes(inside, cubes.volumes());
    const polydec::SparseMatrix curl = polydec::derivative(inside.complex, 1);
    const polydec::SparseMatrix curl_curl =
        h * h * polydec::codifferential({inside.complex, volumes}, 2).matrix() * curl;
    polydec::Index edge = 0; // one in the middle
    while (curl_curl.outerIndexPtr()[edge + 1] - curl_curl.outerIndexPtr()[edge] < 13)
        ++edge;
    std::cout << "an edge in the middle: ";
    for (polydec::SparseMatrix::InnerIterator entry(curl_curl, edge); entry; ++entry)
        std::cout << ' ' << entry.value();
    std::cout << '\n';
}

// the cells of a mesh, separated and colored by number of corners
polydec::SvgDrawing pulled_apart(const polydec::Discretization& mesh, double front) {
    auto cells = polydec::kept_cells(
        mesh, [=](const auto& centroid) { return centroid[1] > front; }, 0.25);
    for (const polydec::Index cell : cells.cells)
        switch (mesh.merging().vertices(3, cell).size()) {
        case 4:
            cells.fills.push_back("#a9cfe8");
            break;
        case 5:
            cells.fills.push_back("#f7c98b");
            break;
        default:
            cells.fills.push_back("#b8dcae");
        }
    return polydec::draw_solid(cells, {.eye = Eigen::Vector3d(0.7, -1.6, 0.9)});
}

void draw_lattices() {
    polydec::SvgDrawing all{.width = 900};
    const auto add = [&](polydec::SvgDrawing drawing, double x, double y) {
        for (auto& shape : drawing.shapes) {
            for (auto& p : std::get<polydec::SvgPolygon>(shape).points)
                p = {p[0] + x, p[1] + y};
            all.shapes.push_back(std::move(shape));
        }
    };
    double x = 0;
    const std::pair<const char*, polydec::Mesh> lattices[] = {{"cubes", polydec::kuhn(3, 2)},
                                                              {"body-centered", polydec::bcc(2)},
                                                              {"face-centered", polydec::fcc(2)}};
    for (const auto& [name, mesh] : lattices) {
        const auto label = [&](const std::string& text, double y, double size) {
            all.shapes.push_back(polydec::SvgText{{x + 0.55, y}, text, size});
        };
        label(name, 3.15, 17);
        label("tetrahedra", 1.38, 14);
        label("merged", -0.32, 14);
        add(pulled_apart(polydec::discretize(mesh, {polydec::MergeCriterion::none}), 0), x, 1.7);
        add(pulled_apart(polydec::discretize(mesh), 0.2), x, 0);
        x += 1.7;
    }
    all.shapes.push_back(polydec::SvgText{
        {2.25, -0.6}, "blue: tetrahedra; orange: 5 corners; green: 6 or more corners", 15});
    std::ofstream("cospherical_cells.svg") << polydec::to_svg(all);
}

} // namespace

int main() {
    shared_square();
    all_zeros();
    shapes();
    stencils();
    draw_lattices();
}
