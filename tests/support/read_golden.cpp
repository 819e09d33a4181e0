// SPDX-License-Identifier: MIT
#include "tests/support/read_golden.h"

#include "tests/support/test.h"

namespace polydec::test {

namespace {

void read_points(std::istream& file, Points& points) {
    for (Index v = 0; v < points.rows(); ++v)
        for (Index c = 0; c < points.cols(); ++c)
            file >> points(v, c);
}

Mesh read_nsc(std::istream& file) {
    Index N = 0, n = 0, vertices = 0, cells = 0;
    file >> N >> n >> vertices >> cells;
    Mesh mesh{Points(vertices, N), Simplices(cells, n + 1), {}};
    read_points(file, mesh.points);
    for (Index s = 0; s < cells; ++s)
        for (Index c = 0; c <= n; ++c)
            file >> mesh.simplices(s, c);
    return mesh;
}

/// Polygons become fans from their first corner.
Mesh read_off(std::istream& file) {
    std::string header;
    Index vertices = 0, faces = 0, edges = 0;
    file >> header >> vertices >> faces >> edges;
    Mesh mesh{Points(vertices, 3), Simplices(0, 3), {}};
    read_points(file, mesh.points);

    std::vector<Index> corners;
    for (Index f = 0; f < faces; ++f) {
        Index count = 0, first = 0, last = 0, next = 0;
        file >> count >> first >> last;
        for (Index c = 2; c < count; ++c, last = next) {
            file >> next;
            corners.insert(corners.end(), {first, last, next});
        }
    }
    mesh.simplices =
        Eigen::Map<const Simplices>(corners.data(), static_cast<Index>(corners.size() / 3), 3);
    return mesh;
}

} // namespace

std::string test_file(const std::string& name) {
    return POLYDEC_TEST_FILES "/" + name;
}

Mesh read_golden(const std::string& name) {
    std::ifstream file(test_file("golden/" + name));
    Mesh mesh = name.ends_with(".off") ? read_off(file) : read_nsc(file);
    if (!file)
        throw std::runtime_error("golden mesh " + name + " cannot be read");
    return mesh;
}

} // namespace polydec::test
