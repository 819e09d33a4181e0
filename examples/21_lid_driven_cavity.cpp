// SPDX-License-Identifier: MIT
//
// Water in a square with a lid that moves at speed 1, on quads, triangles or hexagons. Compares the
// velocities along the vertical center line with Ghia, Ghia and Shin (J. Comput. Phys. 48, 1982,
// table I). Arguments: shape, cells per side, Reynolds number, time.
#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <polydec.h>

namespace {

constexpr std::array heights{0.9766, 0.9688, 0.9609, 0.9531, 0.8516, 0.7344, 0.6172, 0.5,
                             0.4531, 0.2813, 0.1719, 0.1016, 0.0703, 0.0625, 0.0547};
const std::map<int, std::array<double, 15>> velocities{
    {100,
     {0.84123, 0.78871, 0.73722, 0.68717, 0.23151, 0.00332, -0.13641, -0.20581, -0.21090, -0.15662,
      -0.10150, -0.06434, -0.04775, -0.04192, -0.03717}},
    {400,
     {0.75837, 0.68439, 0.61756, 0.55892, 0.29093, 0.16256, 0.02135, -0.11477, -0.17119, -0.32726,
      -0.24299, -0.14612, -0.10338, -0.09266, -0.08186}},
    {1000,
     {0.65928, 0.57492, 0.51117, 0.46604, 0.33304, 0.18719, 0.05702, -0.06080, -0.10648, -0.27805,
      -0.38289, -0.29730, -0.22220, -0.20196, -0.18109}}};

/// The value at a point of a quadratic polynomial fitted to nearby values.
double value_at(const Eigen::RowVector2d& place, const polydec::Points& sites,
                const polydec::Vector& values, double width) {
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(6, 6);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(6);
    for (polydec::Index i = 0; i < sites.rows(); ++i) {
        const Eigen::RowVector2d x = (sites.row(i) - place) / width;
        if (x.squaredNorm() > 9)
            continue;
        Eigen::VectorXd terms(6);
        terms << 1, x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1];
        const double weight = std::exp(-x.squaredNorm());
        M += weight * terms * terms.transpose();
        b += weight * values[i] * terms;
    }
    return M.ldlt().solve(b)[0];
}

} // namespace

int main(int argc, char** argv) {
    const std::string shape = argc > 1 ? argv[1] : "quads";
    const int cells = argc > 2 ? std::atoi(argv[2]) : 24;
    const int reynolds = argc > 3 ? std::atoi(argv[3]) : 100;
    const double time = argc > 4 ? std::atof(argv[4]) : 10;
    const auto square =
        polydec::discretize(shape == "quads"       ? polydec::grid(cells, cells)
                            : shape == "triangles" ? polydec::well_centered(cells / 2)
                                                   : polydec::hexagons(cells));

    const polydec::Points walls = polydec::facet_sites(square);
    polydec::FlowOptions options{.viscosity = 1.0 / reynolds,
                                 .everywhere = polydec::FlowBoundary::no_slip};
    options.wall_velocity = polydec::Points::Zero(walls.rows(), 2);
    for (polydec::Index f = 0; f < walls.rows(); ++f)
        options.wall_velocity(f, 0) = walls(f, 1) > 0.999 ? 1 : 0;
    const polydec::IncompressibleFlow flow(square, options);

    const int steps = static_cast<int>(std::ceil(time * cells / 0.7));
    polydec::Flow water(flow, flow.project(polydec::Vector::Zero(walls.rows())),
                        {.time_step = time / steps, .scheme = polydec::FlowScheme::imex});
    water.march(time);

    const polydec::Points sites = polydec::cell_centroids(square, 2);
    const polydec::Vector u = polydec::flux_sharp(square, water.form(0)).col(0);
    double worst = 0, sum = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double found = value_at({0.5, heights[i]}, sites, u, 1.0 / cells);
        const double off = std::abs(found - velocities.at(reynolds)[i]);
        worst = std::max(worst, off);
        sum += off * off;
    }
    std::cout << sites.rows() << ' ' << shape << ", Reynolds number " << reynolds
              << ": velocities off by at most " << worst << ", in the mean "
              << std::sqrt(sum / heights.size()) << (worst < 0.02 ? "; as in the table\n" : "\n");
}
