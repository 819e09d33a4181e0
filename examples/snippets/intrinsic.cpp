// SPDX-License-Identifier: MIT
//
// The code on docs/intrinsic.md: flips of a flattened sphere, maps of forms to the flipped
// triangulation and back, the common refinement of both triangulations, splits of boundary edges.
#include <iostream>
#include <polydec.h>

namespace {

/// Multiplies by a factor along an oblique direction.
void stretch(polydec::Points& points, double factor) {
    const Eigen::RowVector3d direction = Eigen::RowVector3d(1, 2, 3).normalized();
    points += (factor - 1) * (points * direction.transpose()) * direction;
}

/// A flattened sphere, with triangles that are no longer equilateral.
polydec::Mesh pebble(int frequency) {
    polydec::Mesh mesh = polydec::icosphere(frequency);
    stretch(mesh.points, 0.25);
    return mesh;
}

void print_spectrum(const char* name, const polydec::Discretization& surface) {
    const auto modes = polydec::spectrum({surface, polydec::Side::dual, 0}, {.count = 3});
    std::cout << name << modes.eigenvalues.transpose() << '\n';
}

double largest(const polydec::Vector& values) {
    return values.cwiseAbs().maxCoeff();
}

void flips() {
    const polydec::Mesh mesh = pebble(8);
    const auto before = polydec::discretize(mesh, {.star = polydec::StarKind::circumcentric});
    const auto after = polydec::discretize(
        mesh, {.delaunay = polydec::Delaunay::flips, .star = polydec::StarKind::circumcentric});
    const polydec::IntrinsicStatistics& done = after.passage().flips().statistics;
    std::cout << done.negative_before << " negative dual edges, " << done.flips << " flips\n"
              << "smallest star_1 " << polydec::star(before, 1).diagonal().minCoeff()
              << ", after it " << polydec::star(after, 1).diagonal().minCoeff() << '\n';
    print_spectrum("dual 0-forms before: ", before);
    print_spectrum("dual 0-forms after:  ", after);
}

void forms() {
    const auto mesh = polydec::discretize(pebble(8), {.delaunay = polydec::Delaunay::flips});
    const polydec::CellComplex& P = mesh.complex();
    polydec::Cochain u{polydec::Side::primal, 0, mesh.points().col(0)};
    const polydec::Cochain du = polydec::d(mesh.input(), u);
    const polydec::Cochain there = polydec::to_merged(mesh, du);
    const polydec::Cochain back = polydec::to_input(mesh, there);
    const polydec::Cochain other = polydec::d(P, polydec::to_merged(mesh, u));
    std::cout << "d after, minus d before: " << largest(other.values - there.values)
              << "\nthere and back: " << largest(back.values - du.values) << '\n';
}

void pieces() {
    const auto mesh = polydec::discretize(pebble(8), {.delaunay = polydec::Delaunay::flips});
    const polydec::Overlay pieces = polydec::overlay(mesh.passage(), mesh.points());
    std::cout << mesh.input().size(2) << " triangles in " << pieces.size() << " pieces of area "
              << pieces.areas.sum() << " = " << mesh.input_geometry().volumes().primal(2).sum()
              << '\n';
    polydec::write_vtu("pieces.vtu", polydec::draw_overlay(mesh));
}

void splits() {
    polydec::Mesh mesh = polydec::grid(4, 4);
    mesh.points.col(0) += 2.3 * mesh.points.col(1); // a parallelogram
    for (const auto delaunay : {polydec::Delaunay::flips, polydec::Delaunay::flips_and_splits}) {
        const auto surface = polydec::discretize(
            mesh, {.delaunay = delaunay, .star = polydec::StarKind::circumcentric});
        const auto& done = surface.passage().flips().statistics;
        std::cout << done.flips << " flips, " << done.splits
                  << " splits: " << done.negative_boundary
                  << " negative duals on the boundary, smallest star_1 "
                  << polydec::star(surface, 1).diagonal().minCoeff() << '\n';
    }
}

void centers() {
    for (const int frequency : {8, 16, 32, 64}) {
        const auto mesh =
            polydec::discretize(pebble(frequency), {.delaunay = polydec::Delaunay::flips});
        polydec::Points places = polydec::cell_centers(mesh, 2);
        stretch(places, 4); // the round sphere again
        std::cout << "centers off the round sphere by up to "
                  << largest(1 - places.rowwise().norm().array()) << '\n';
    }
}

} // namespace

int main() {
    flips();
    forms();
    pieces();
    splits();
    centers();
}
