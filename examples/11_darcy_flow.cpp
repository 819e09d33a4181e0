// SPDX-License-Identifier: MIT
//
// Water flows through a box around a block of clay, from pressure 1 at the left to pressure 0 at
// the right. The merged cells are the octahedra and tetrahedra of a face-centered cubic lattice,
// with one pressure each at the circumcenter. Every cell is in exact balance: the inflow at the
// left equals the outflow at the right.
#include <cmath>
#include <fstream>
#include <iostream>
#include <polydec.h>

int main() {
    const auto box = polydec::discretize(polydec::fcc({16, 8, 8}, 0.125), // 2 x 1 x 1
                                         {.star = polydec::StarKind::circumcentric});
    const polydec::Points places = polydec::dual_sites(box);
    polydec::Vector kappa = polydec::Vector::Ones(places.rows());
    for (polydec::Index cell = 0; cell < kappa.size(); ++cell) // a block from the floor upwards
        if (std::abs(places(cell, 0) - 1) < 0.3 && places(cell, 2) < 0.6)
            kappa[cell] = 1e-4;

    // pressures are given left and right; the other walls are impermeable
    const polydec::Points facets = polydec::facet_sites(box);
    const auto ends = polydec::essential_where(
        facets, [](const auto& x) { return x[0] < 1e-9 || x[0] > 2 - 1e-9; });
    const auto rock =
        polydec::with_conductivity(box, polydec::Side::dual, polydec::CellData::on_cells(kappa));
    const polydec::PoissonSolver solver({rock, polydec::Side::dual, 0, ends});
    const auto flow = solver.solve({polydec::Side::dual, 0, polydec::Vector::Zero(places.rows())},
                                   {.values = 1 - facets.col(0).array() / 2});

    // a flux is outward if the facet is oriented as the boundary of its cell
    const polydec::SparseMatrix divergence = polydec::derivative(box.complex(), 2);
    const polydec::Vector outward = divergence.transpose() * polydec::Vector::Ones(places.rows());
    double in = 0, out = 0;
    for (polydec::Index f = 0; f < facets.rows(); ++f) {
        in -= facets(f, 0) < 1e-9 ? outward[f] * flow.flux.values[f] : 0;
        out += facets(f, 0) > 2 - 1e-9 ? outward[f] * flow.flux.values[f] : 0;
    }
    std::cout << "inflow " << in << ", outflow " << out << ", without the block 0.5\n"
              << "every cell balances to 1e-12: "
              << ((divergence * flow.flux.values).cwiseAbs().maxCoeff() < 1e-12 ? "yes" : "no")
              << '\n';

    // the rear half, cut open, with velocities on the cut
    const polydec::SolidView view{.eye = Eigen::Vector3d(0.25, -1, 0.4),
                                  .title = "Pressure around a block of clay"};
    auto solid = polydec::kept_faces(
        box, [](const auto& x) { return x[1] > 0.5; }, flow.form.values);
    for (const polydec::Index cell : solid.cells)
        solid.fills.push_back(kappa[cell] < 1 ? "#9a948a" : "");
    auto drawing = polydec::draw_solid(solid, view);
    const polydec::DenseMatrix velocity = polydec::flux_sharp(box, flow.flux);
    for (polydec::Index cell = 0; cell < places.rows(); ++cell)
        if (kappa[cell] == 1 && std::abs(places(cell, 1) - 0.5) < 1e-9 && places(cell, 2) > 1e-9 &&
            places(cell, 0) > 1e-9) {
            const polydec::Vector p = places.row(cell), v = 0.25 * velocity.row(cell);
            drawing.shapes.push_back(polydec::SvgArrow{polydec::seen_at(view, p - v / 2),
                                                       polydec::seen_at(view, p + v / 2)});
        }
    std::ofstream("darcy_flow.svg") << polydec::to_svg(drawing);

    auto page = polydec::draw_page(box, {{"pressure", flow.form, "arrows: velocity"}},
                                   "Water around a block of clay");
    page.arrows.push_back({"pressure", places, velocity});
    polydec::write_page("darcy_flow.html", page);
}
