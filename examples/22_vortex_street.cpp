// SPDX-License-Identifier: MIT
//
// Flow past a cylinder of diameter 1 with speed 1, on quads or triangles. The wake oscillates at
// the frequency that Williamson (J. Fluid Mech. 206, 1989) measured. Arguments: shape, cells
// around the cylinder, Reynolds number, time.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <polydec.h>
#include <vector>

namespace {

constexpr double pi = std::numbers::pi, far = 30;

/// Rows of vertices between the cylinder and a circle far away. Their ratio makes the quads square,
/// or the triangles of rotated rows regular.
polydec::Mesh around_the_cylinder(const std::string& shape, int around) {
    const double width = 2 * pi / around;
    const double turn = shape == "triangles" ? 0.5 : 0;
    const double growth = std::exp(shape == "triangles" ? std::sqrt(0.75) * width : width);
    const int rows = static_cast<int>(std::ceil(std::log(2 * far) / std::log(growth)));
    polydec::Mesh mesh;
    mesh.points.resize(around * (rows + 1), 2);
    mesh.simplices.resize(2 * around * rows, 3);
    const auto vertex = [&](int row, int i) { return row * around + (i + around) % around; };
    for (int row = 0; row <= rows; ++row)
        for (int i = 0; i < around; ++i) {
            const double radius = 0.5 * std::pow(growth, row);
            const double angle = width * (i + (row % 2) * turn);
            mesh.points.row(vertex(row, i)) << radius * std::cos(angle), radius * std::sin(angle);
            if (row == rows)
                continue;
            const int shift = turn > 0 ? row % 2 : 0; // of the outer row against this row
            const auto first = 2 * vertex(row, i);
            mesh.simplices.row(first) << vertex(row, i), vertex(row + 1, i + shift),
                vertex(row, i + 1);
            mesh.simplices.row(first + 1) << vertex(row, i + 1), vertex(row + 1, i + shift),
                vertex(row + 1, i + shift + 1);
        }
    return mesh;
}

/// The flux of the flow with this stream function.
template <typename Stream>
polydec::Vector flow_of(const polydec::Discretization& mesh, Stream stream) {
    polydec::Vector values(mesh.complex().size(0));
    for (polydec::Index v = 0; v < values.size(); ++v)
        values[v] = stream(mesh.points()(v, 0), mesh.points()(v, 1));
    return polydec::d(mesh.complex(), {polydec::Side::primal, 0, values}).values;
}

/// Times when the values rise through 0.
std::vector<double> rises(const std::vector<double>& values, double step) {
    std::vector<double> times;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (values[i - 1] < 0 && values[i] >= 0)
            times.push_back(step * (i - values[i] / (values[i] - values[i - 1])));
    return times;
}

} // namespace

int main(int argc, char** argv) {
    const std::string shape = argc > 1 ? argv[1] : "quads";
    const int around = argc > 2 ? std::atoi(argv[2]) : 32;
    const double reynolds = argc > 3 ? std::atof(argv[3]) : 100;
    const double until = argc > 4 ? std::atof(argv[4]) : 40;
    const auto mesh = polydec::discretize(around_the_cylinder(shape, around));

    polydec::FlowOptions options{.viscosity = 1 / reynolds};
    options.boundary_flux = flow_of(mesh, [](double x, double y) {
        return x * x + y * y > 1 ? y : 0; // the cylinder is impermeable
    });
    const polydec::Points facets = polydec::facet_sites(mesh);
    for (polydec::Index f = 0; f < facets.rows(); ++f)
        options.facets.push_back(facets.row(f).norm() < 0.6 ? polydec::FlowBoundary::no_slip
                                 : facets(f, 0) > 0         ? polydec::FlowBoundary::open
                                                            : polydec::FlowBoundary::free_slip);
    const polydec::IncompressibleFlow flow(mesh, options);
    const polydec::Vector start = flow.project(flow_of(mesh, [](double x, double y) {
        return y + std::exp(-4 * (std::pow(x - 1, 2) + std::pow(y - 0.5, 2))); // a first push
    }));

    const int steps = static_cast<int>(std::ceil(until / (0.6 * flow.exchange_time(start))));
    const double step = until / steps;
    polydec::Flow street(flow, start, {.time_step = step, .scheme = polydec::FlowScheme::imex});
    polydec::Index behind = 0;
    const polydec::Points cells = polydec::cell_centroids(mesh, 2);
    (cells.rowwise() - Eigen::RowVector2d(2, 0.1)).rowwise().norm().minCoeff(&behind);
    std::vector<double> across;
    street.march(until, [&](double) {
        across.push_back(polydec::flux_sharp(mesh, street.form(0))(behind, 1));
    });

    const std::vector<double> times = rises(across, step);
    if (times.size() < 2) {
        std::cout << "no swing yet: give more time\n";
        return 1;
    }
    const std::size_t swings = std::min<std::size_t>(times.size() - 1, 5); // the last
    const double frequency = swings / (times.back() - times[times.size() - 1 - swings]);
    const double measured = 0.1816 - 3.3265 / reynolds + 1.6e-4 * reynolds;
    std::cout << cells.rows() << ' ' << shape << ", Reynolds number " << reynolds << ", " << steps
              << " steps: Strouhal number " << frequency << ", measured " << measured << '\n';
}
