// SPDX-License-Identifier: MIT
//
// Water in a square box with a moving lid, Re = 100. The backflow on the vertical center line
// reaches 0.2109 (Ghia, Ghia, Shin 1982).
#include <iostream>
#include <polydec.h>

int main() {
    const auto square = polydec::discretize(polydec::grid(32, 32));
    const polydec::Points walls = polydec::facet_sites(square);
    polydec::Points lid = polydec::Points::Zero(walls.rows(), 2);
    lid.col(0) = (walls.col(1).array() > 0.999).cast<double>();
    const auto sticky = polydec::FlowBoundary::no_slip;
    const polydec::IncompressibleFlow flow(
        square, {.viscosity = 0.01, .everywhere = sticky, .wall_velocity = lid});
    const polydec::Vector rest = polydec::Vector::Zero(walls.rows());
    polydec::Flow water(flow, rest, {0.02, polydec::FlowScheme::imex});
    water.march(8);
    const polydec::Points u = polydec::flux_sharp(square, water.form(0));
    const polydec::Vector x = polydec::cell_centers(square, 2).col(0);
    const auto back = ((x.array() - 0.5).abs() < 0.02).select(-u.col(0), 0);
    std::cout << "back with " << back.maxCoeff() << '\n';
}
