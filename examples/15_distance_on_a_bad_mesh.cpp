// SPDX-License-Identifier: MIT
//
// The distance along a badly triangulated surface, exact and by the heat method, without and with
// intrinsic Delaunay flips. The exact distance does not depend on the triangles; the heat method
// does. The mesh is the side of a drill: points of a square grid around a prism, but triangles in
// helices around it, eight steps up for one to the side. Each triangle lies in a flat side of the
// prism, so the surface equals that of the straight grid, and unrolling it gives the distance.
// Flips recover the squares of the grid; nothing moves. `15_distance_on_a_bad_mesh MESH` takes
// your own mesh, and measures from its vertex 0.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

using polydec::Index;
constexpr int around = 256, rows = 80, steep = 8;
const double side = 2 * std::sin(std::numbers::pi / around);

Index number(int i, int j) {
    return i % around * (rows + 1) + j;
}

// walks up both rims of each side, the right rim `steep` points ahead where possible
polydec::Mesh drill() {
    polydec::Mesh mesh;
    mesh.points.resize(around * (rows + 1), 3);
    mesh.simplices.resize(2 * around * rows, 3);
    Index triangle = 0;
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around;
        for (int j = 0; j <= rows; ++j)
            mesh.points.row(number(i, j)) << std::cos(angle), std::sin(angle), side * j;
        for (int left = 0, right = 0; left + right < 2 * rows;) {
            const bool ahead = right < std::min(left + steep, rows);
            mesh.simplices.row(triangle++) << number(i, left), number(i + 1, right),
                ahead ? number(i + 1, right + 1) : number(i, left + 1);
            ++(ahead ? right : left);
        }
    }
    return mesh;
}

polydec::Vector unrolled() {
    polydec::Vector distance(around * (rows + 1));
    for (int i = 0; i < around; ++i)
        for (int j = 0; j <= rows; ++j)
            distance[number(i, j)] =
                std::hypot(side * std::min(i, around - i), side * (j - rows / 2));
    return distance;
}

} // namespace

int main(int count, char** words) {
    const polydec::Mesh mesh = count > 1 ? polydec::read_mesh(words[1]) : drill();
    const auto before = polydec::discretize(mesh);
    const auto after = polydec::discretize(mesh, {.delaunay = polydec::Delaunay::flips});
    const auto& done = after.passage().flips().statistics;
    std::cout << done.negative_before << " of " << before.input().size(1)
              << " edges have a negative dual; after " << done.flips << " flips "
              << done.negative_interior << " have\n"
              << before.input().size(2) << " triangles merge into " << before.complex().size(2)
              << " polygons, after the flips into " << after.complex().size(2) << '\n';

    const std::vector<Index> source{count > 1 ? 0 : number(0, rows / 2)};
    std::vector<polydec::NamedForm> fields;
    for (const auto& [name, surface] : {std::pair("without", &before), {"with", &after}}) {
        const polydec::Vector exact = polydec::geodesic_distance(*surface, source);
        const polydec::Vector heat =
            polydec::geodesic_distance(*surface, source, {.method = polydec::DistanceMethod::heat});
        std::cout << name << " flips: distances up to " << exact.maxCoeff();
        if (count == 1)
            std::cout << ", mean error " << (exact - unrolled()).cwiseAbs().mean() << ", of heat "
                      << (heat - unrolled()).cwiseAbs().mean();
        std::cout << '\n';
        fields.push_back({name, {polydec::Side::primal, 0, heat}, "distance by the heat method"});
    }
    polydec::write_page("distance.html",
                        polydec::draw_page(before, fields, "By heat, without and with flips"));
}
