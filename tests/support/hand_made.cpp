// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// The mesh with vertices renamed and moved: number and place of each old vertex.
Mesh glued(const Mesh& mesh, Index vertices, const std::function<Index(const Vector&)>& number,
           const std::function<Vector(const Vector&)>& place) {
    Mesh result{Points(vertices, place(mesh.points.row(0)).size()), mesh.simplices, {}};
    std::vector<Index> renamed;
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        renamed.push_back(number(mesh.points.row(v)));
        result.points.row(renamed.back()) = place(mesh.points.row(v));
    }
    for (Index& v : result.simplices.reshaped())
        v = renamed[v];
    return result;
}

} // namespace

Mesh made_of(std::vector<std::vector<double>> points, std::vector<std::vector<Index>> simplices) {
    Mesh mesh{Points(points.size(), points.front().size()),
              Simplices(simplices.size(), simplices.front().size()),
              {}};
    for (std::size_t v = 0; v < points.size(); ++v)
        for (std::size_t c = 0; c < points[v].size(); ++c)
            mesh.points(v, c) = points[v][c];
    for (std::size_t s = 0; s < simplices.size(); ++s)
        for (std::size_t c = 0; c < simplices[s].size(); ++c)
            mesh.simplices(s, c) = simplices[s][c];
    return mesh;
}

Mesh united(const Mesh& first, const Mesh& second) {
    Mesh mesh = first;
    mesh.points.conservativeResize(first.points.rows() + second.points.rows(), Eigen::NoChange);
    mesh.points.bottomRows(second.points.rows()) = second.points;
    mesh.simplices.conservativeResize(first.simplices.rows() + second.simplices.rows(),
                                      Eigen::NoChange);
    mesh.simplices.bottomRows(second.simplices.rows()) =
        second.simplices.array() + static_cast<Index>(first.points.rows());
    return mesh;
}

Mesh without(const Mesh& mesh, const std::function<bool(const Vector&)>& centroid_is_left_out) {
    Mesh result{mesh.points, Simplices(mesh.simplices.rows(), mesh.simplices.cols()), {}};
    Index kept = 0;
    for (Index s = 0; s < mesh.simplices.rows(); ++s) {
        Vector centroid = Vector::Zero(mesh.points.cols());
        for (const Index v : mesh.simplices.row(s))
            centroid += mesh.points.row(v).transpose();
        if (!centroid_is_left_out(centroid / static_cast<double>(mesh.simplices.cols())))
            result.simplices.row(kept++) = mesh.simplices.row(s);
    }
    result.simplices.conservativeResize(kept, Eigen::NoChange);
    return result;
}

Mesh boundary_of(const Mesh& mesh) {
    std::map<std::vector<Index>, std::pair<int, std::vector<Index>>> facets;
    for (Index s = 0; s < mesh.simplices.rows(); ++s)
        for (Index omitted = 0; omitted < mesh.simplices.cols(); ++omitted) {
            std::vector<Index> facet;
            for (Index c = 0; c < mesh.simplices.cols(); ++c)
                if (c != omitted)
                    facet.push_back(mesh.simplices(s, c));
            auto key = facet;
            std::sort(key.begin(), key.end());
            if (omitted % 2 == 1)
                std::swap(facet[0], facet[1]);
            auto& [count, oriented] = facets[key];
            ++count;
            oriented = facet;
        }
    Mesh result{mesh.points, Simplices(facets.size(), mesh.simplices.cols() - 1), {}};
    Index kept = 0;
    for (const auto& [key, facet] : facets)
        if (facet.first == 1)
            result.simplices.row(kept++) =
                Eigen::Map<const Eigen::Matrix<Index, 1, Eigen::Dynamic>>(
                    facet.second.data(), static_cast<Index>(facet.second.size()));
    result.simplices.conservativeResize(kept, Eigen::NoChange);
    return result;
}

Mesh transformed(Mesh mesh, const DenseMatrix& A, double scale, double shift) {
    mesh.points = (scale * (mesh.points * A.transpose())).array() + shift;
    return mesh;
}

DenseMatrix random_isometry(Index N, unsigned seed) {
    std::mt19937 random(seed);
    DenseMatrix A(N, N);
    for (double& a : A.reshaped())
        a = 2.0 * random() / std::mt19937::max() - 1;
    return orthonormal_columns(A);
}

Mesh welded(const std::vector<Eigen::Matrix3d>& triangles) {
    const auto count = static_cast<Index>(triangles.size());
    Mesh soup{Points(3 * count, 3), Simplices(count, 3), {}};
    for (Index t = 0; t < count; ++t) {
        soup.points.middleRows<3>(3 * t) = triangles[t].transpose();
        soup.simplices.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    }
    return weld(std::move(soup)).mesh;
}

Mesh book_of(const Mesh& page, const std::vector<double>& angles) {
    std::optional<Mesh> pages;
    for (const double angle : angles) {
        DenseMatrix turned(3, 2);
        turned << std::cos(angle), 0, std::sin(angle), 0, 0, 1;
        const Mesh copy = transformed(page, turned);
        pages = pages ? united(*pages, copy) : copy;
    }
    return weld(std::move(*pages)).mesh;
}

Mesh shaken_inside(Mesh mesh, double amplitude, std::uint64_t seed) {
    const Mesh moved = perturbed(mesh, amplitude, seed);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if (mesh.points.row(v).minCoeff() > 1e-9 && mesh.points.row(v).maxCoeff() < 1 - 1e-9)
            mesh.points.row(v) = moved.points.row(v);
    return mesh;
}

Mesh kite(double up, double down) {
    return made_of({{0, 0}, {2, 0}, {1, up}, {1, -down}}, {{0, 1, 2}, {1, 0, 3}});
}

Mesh polygon_curve() {
    Mesh mesh{Points(9, 3), Simplices(9, 2), {}};
    for (Index i = 0; i < 9; ++i) {
        const double t = turn * (i + 0.2 * std::sin(i)) / 9;
        mesh.points.row(i) << std::cos(t), std::sin(t), 0.3 * std::cos(3 * t);
        mesh.simplices.row(i) << i, (i + 1) % 9;
    }
    return mesh;
}

Mesh theta_graph() {
    return made_of({{0, 0}, {2, 0}, {1, 1}, {0.5, -1}, {1.5, -1}},
                   {{0, 1}, {0, 2}, {2, 1}, {0, 3}, {3, 4}, {1, 4}});
}

Mesh two_components() {
    return united(icosphere(1), transformed(torus(7, 4), DenseMatrix::Identity(3, 3), 1, 5));
}

Mesh obtuse_planar() {
    DenseMatrix shear(2, 2);
    shear << 3, 1.7, 0, 1;
    return transformed(perturbed(grid(7, 6), 0.032, 5), shear);
}

Mesh obtuse_solid() {
    DenseMatrix shear(3, 3);
    shear << 2, 1.1, 0.3, 0, 1, -0.7, 0, 0, 0.8;
    return transformed(perturbed(kuhn(3, 2), 0.06, 7), shear);
}

Mesh projective_plane() {
    Mesh mesh = made_of({{}}, {{0, 1, 2},
                               {0, 2, 3},
                               {0, 3, 4},
                               {0, 4, 5},
                               {0, 1, 5},
                               {1, 2, 4},
                               {2, 3, 5},
                               {1, 3, 4},
                               {2, 4, 5},
                               {1, 3, 5}});
    mesh.points = Points::Identity(6, 6);
    return mesh;
}

Mesh klein_bottle() {
    const int m = 8;
    const auto number = [](const Vector& x) {
        const auto i = static_cast<Index>(std::lround(m * x[0]));
        auto j = static_cast<Index>(std::lround(m * x[1]));
        if (i == m)
            j = m - j;
        return i % m * m + j % m;
    };
    const auto place = [](const Vector& x) {
        const double u = turn * x[0], v = turn * x[1];
        Vector p(4);
        p << (1 + 0.4 * std::cos(v)) * std::cos(u), (1 + 0.4 * std::cos(v)) * std::sin(u),
            0.4 * std::sin(v) * std::cos(u / 2), 0.4 * std::sin(v) * std::sin(u / 2);
        return p;
    };
    return glued(grid(m, m), m * m, number, place);
}

Mesh genus_two() {
    return boundary_of(without(kuhn({5, 3, 1}, {5, 3, 1}), [](const Vector& x) {
        return (std::floor(x[0]) == 1 || std::floor(x[0]) == 3) && std::floor(x[1]) == 1;
    }));
}

Mesh hollow_cube() {
    return without(kuhn({3, 3, 3}, {3, 3, 3}),
                   [](const Vector& x) { return x.array().floor().isOnes(); });
}

Mesh clifford_torus() {
    // rows are shifted by half a column each, so the last one meets the first half way around
    const int m = 8;
    const auto number = [](const Vector& x) {
        const auto i = static_cast<Index>(std::lround(m * x[0]));
        const auto j = static_cast<Index>(std::lround(m * x[1]));
        const Index turned = j == m ? i + m / 2 : i;
        return turned % m * m + j % m;
    };
    const auto place = [](const Vector& x) {
        const double u = turn * (x[0] - x[1] / 2), v = turn * x[1];
        Vector p(4);
        p << std::cos(u), std::sin(u), std::cos(v), std::sin(v);
        return p;
    };
    return glued(grid(m, m), m * m, number, place);
}

Mesh cubical_torus(int n) {
    const int m = 4;
    const auto number = [](const Vector& x) {
        Index result = 0;
        for (const double coordinate : x)
            result = result * m + static_cast<Index>(std::lround(m * coordinate)) % m;
        return result;
    };
    const auto place = [](const Vector& x) {
        Vector p(2 * x.size());
        p << (turn * x.array()).cos().matrix(), (turn * x.array()).sin().matrix();
        return p;
    };
    return glued(kuhn(n, m), static_cast<Index>(std::lround(std::pow(m, n))), number, place);
}

Mesh tilted_tetrahedra() {
    return made_of({{0, 0, 0, 0},
                    {1, 0, 0, 0},
                    {0.4, 1, 0, 0},
                    {0.4, 0.3, 1, 0},
                    {0.5, 0.2, -0.7, 0.4},
                    {0.3, 0.4, -0.5, -0.8}},
                   {{0, 1, 2, 3}, {1, 0, 2, 4}, {0, 1, 2, 5}});
}

Mesh pinched() {
    return made_of({{0, 0, 0},
                    {1, 0, 0},
                    {0.3, 1, 0},
                    {0.3, 0.2, 1},
                    {0.5, -1, 0.1},
                    {0.4, -0.5, -1},
                    {2, 0.1, 0},
                    {2, 1, 0.2},
                    {1.7, 0.3, 1}},
                   {{0, 1, 2, 3}, {0, 1, 4, 5}, {1, 6, 7, 8}});
}

Mesh with_isolated_vertices() {
    const Mesh dense = grid(3, 3);
    Mesh mesh{Points::Constant(2 * dense.points.rows() + 3, 2, 7.0),
              (2 * dense.simplices.array() + 1).matrix(),
              {}};
    for (Index v = 0; v < dense.points.rows(); ++v)
        mesh.points.row(2 * v + 1) = dense.points.row(v);
    return mesh;
}

Mesh triangle_soup() {
    std::mt19937 random(11);
    Mesh mesh{Points(24, 3), Simplices(8, 3), {}};
    for (double& x : mesh.points.reshaped())
        x = 1.0 * random() / std::mt19937::max();
    std::iota(mesh.simplices.data(), mesh.simplices.data() + mesh.simplices.size(), 0);
    return mesh;
}

Mesh annulus(int segments, int layers) {
    const auto number = [&](const Vector& x) {
        const auto i = static_cast<Index>(std::lround(segments * x[0])) % segments;
        return (layers + 1) * i + static_cast<Index>(std::lround(layers * x[1]));
    };
    const auto place = [](const Vector& x) {
        return Vector((1 + x[1]) * Eigen::Vector2d(std::cos(turn * x[0]), std::sin(turn * x[0])));
    };
    return glued(grid(segments, layers), (layers + 1) * segments, number, place);
}

Mesh spherical_ring() {
    return made_of({{-0.354038071149735, 0.8436540738317317, -0.40361472704015217},
                    {0.6135526656786505, -0.7498595376640791, 0.24751525248524492},
                    {0.19007440964872513, 0.08654894401804542, 0.9779473396282904},
                    {-0.5052939537049506, -0.13733473047018913, -0.8519490549063965},
                    {-0.8870347416630258, -0.4047542614930441, -0.2221336419501401},
                    {-0.05687371920682086, 0.826522960428387, 0.5600224780741188},
                    {0.5871877307244187, -0.7872450141104633, 0.18829725607381403},
                    {0.1903005877464278, -0.9814655782791702, -0.022605418741867264}},
                   {{2, 4, 6, 7},
                    {1, 2, 6, 7},
                    {3, 4, 6, 7},
                    {0, 3, 4, 5},
                    {3, 4, 5, 6},
                    {0, 3, 5, 6},
                    {0, 1, 5, 6},
                    {1, 2, 5, 6}});
}

Mesh handle_and_cavity() {
    return made_of(
        {{0, -1, 2, -2, 0},
         {2, 0, 0, 2, -1},
         {1, 0, 0, 2, -2},
         {-1, 0, 2, -2, 0},
         {1, 2, 0, -2, 0},
         {0, -2, 1, 0, -2},
         {-1, 0, -2, 0, 2},
         {2, 2, 0, 0, -1},
         {-2, 1, 0, 0, 2},
         {2, 0, 0, -2, 1},
         {2, 0, 2, 0, 1},
         {2, 0, 0, 1, 2}},
        {{0, 1, 2, 4, 5, 6},   {0, 1, 2, 4, 5, 7},   {0, 1, 2, 5, 7, 10},  {0, 1, 4, 5, 7, 9},
         {0, 1, 5, 7, 9, 10},  {0, 1, 2, 5, 6, 8},   {0, 1, 2, 5, 8, 10},  {0, 1, 2, 4, 6, 8},
         {0, 1, 4, 7, 9, 11},  {0, 1, 7, 9, 10, 11}, {0, 4, 7, 9, 10, 11}, {0, 1, 4, 6, 9, 11},
         {0, 1, 4, 6, 8, 11},  {0, 1, 5, 6, 9, 11},  {0, 1, 5, 9, 10, 11}, {0, 1, 5, 6, 8, 11},
         {0, 1, 5, 8, 10, 11}, {0, 1, 2, 3, 4, 7},   {0, 1, 2, 3, 4, 8},   {0, 1, 3, 4, 7, 11},
         {0, 1, 3, 4, 8, 11},  {0, 3, 4, 9, 10, 11}, {0, 3, 4, 8, 9, 11}});
}

} // namespace polydec::test
