// SPDX-License-Identifier: MIT
//
// The code of docs/pages.md: several fields in one picture.
#include <iostream>
#include <polydec.h>

int main() {
    using polydec::Side;

    const auto sphere = polydec::discretize(polydec::goldberg(4));
    const polydec::Points& x = sphere.points();
    polydec::Points wind = polydec::Points::Zero(x.rows(), 3);
    wind.col(0) = -x.col(1);
    wind.col(1) = x.col(0);
    const polydec::Vector height = x.col(2);
    const polydec::Vector pressure = polydec::cell_centroids(sphere, 2).col(2);

    const std::vector<polydec::NamedForm> fields{{"wind", Side::primal, wind, "metres per second"},
                                                 {"height", {Side::primal, 0, height}},
                                                 {"pressure", {Side::dual, 0, pressure}}};
    polydec::write_vtu("wind.vtu", polydec::draw_fields(sphere, fields));
    polydec::write_page("wind.html", polydec::draw_page(sphere, fields, "A wind"));

    const polydec::VtuGrid grid = polydec::draw_fields(sphere, fields);
    std::cout << grid.point_data.size() << " arrays at vertices, " << grid.cell_data.size()
              << " at cells\n";
}
