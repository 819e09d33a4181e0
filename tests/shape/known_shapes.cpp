// SPDX-License-Identifier: MIT
#include "tests/shape/known_shapes.h"

namespace polydec::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * (random() / 4294967296.0);
}

/// Points of a box, inner ones moved by up to `amplitude` cells.
void shake(Mesh& mesh, std::mt19937& random, const std::vector<int>& cells,
           const std::vector<double>& sides, double amplitude) {
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        bool inner = true;
        for (Eigen::Index c = 0; c < mesh.points.cols(); ++c)
            inner = inner && mesh.points(v, c) > 1e-9 && mesh.points(v, c) < sides[c] - 1e-9;
        for (Eigen::Index c = 0; inner && c < mesh.points.cols(); ++c)
            mesh.points(v, c) += uniform(random, -amplitude, amplitude) * sides[c] / cells[c];
    }
}

std::vector<double> repeated(std::vector<double> values, int times) {
    std::vector<double> result;
    for (const double value : values)
        result.insert(result.end(), times, value);
    return result;
}

} // namespace

Shape unmerged(const Mesh& mesh, const BoundaryConditions& conditions) {
    return shape_of(discretize(mesh, {.criterion = MergeCriterion::none}), conditions);
}

Shape unmerged(const PeriodicMesh& mesh) {
    return shape_of(discretize(mesh, {.criterion = MergeCriterion::none}));
}

Shape glued_bottle(const Mesh& box, double a, double b) {
    const Isometry across = [a](const Vector& p) { return Vector{{p[0] + a, p[1]}}; };
    const Isometry turned = [a, b](const Vector& p) { return Vector{{a - p[0], p[1] + b}}; };
    return unmerged(glue(box, {across, turned}));
}

BoundaryConditions conditions_of(const Mesh& mesh, const std::vector<PartOfBoundary>& parts) {
    const auto on = discretize(mesh, {.criterion = MergeCriterion::none});
    const Points centroids = cell_centroids(on, on.dimension() - 1);
    BoundaryConditions conditions;
    for (const auto& centroid : centroids.rowwise()) {
        conditions.facets.push_back(BoundaryCondition::natural);
        conditions.coefficients.push_back(1);
        for (const PartOfBoundary& part : parts)
            if (part.where(centroid)) {
                conditions.facets.back() = part.condition;
                conditions.coefficients.back() = part.coefficient;
            }
    }
    return conditions;
}

std::vector<double> sums(const std::vector<std::vector<double>>& lists, double limit) {
    std::vector<double> result{0};
    for (const auto& list : lists) {
        std::vector<double> next;
        for (const double before : result)
            for (const double value : list)
                if (before + value < limit)
                    next.push_back(before + value);
        result = std::move(next);
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<double> interval_eigenvalues(double length, double left, double right, double limit) {
    std::vector<double> result;
    for (int k = 0;; ++k) { // root of mu length - k pi = atan(left / mu) + atan(right / mu)
        double low = k * pi / length, high = (k + 1) * pi / length;
        if (left == 0 && right == 0)
            high = low;
        for (int step = 0; step < 200 && low < high; ++step) {
            const double mu = (low + high) / 2;
            const bool is_below =
                mu * length - k * pi < std::atan2(left, mu) + std::atan2(right, mu);
            (is_below ? low : high) = mu;
        }
        if (!(high * high < limit))
            return result;
        result.push_back(high * high);
    }
}

KnownShape random_box(std::mt19937& random, const std::vector<int>& cells) {
    const auto n = static_cast<Eigen::Index>(cells.size());
    std::vector<double> sides;
    for (Eigen::Index c = 0; c < n; ++c)
        sides.push_back(uniform(random, 0.5, 1.5));
    Mesh mesh = kuhn(cells, sides);
    shake(mesh, random, cells, sides, 0.3);
    const double limit = 2000;
    std::vector<std::vector<double>> lists;
    std::vector<PartOfBoundary> parts;
    for (Eigen::Index c = 0; c < n; ++c) {
        double coefficients[2];
        for (int end = 0; end < 2; ++end) {
            const auto kind = random() % 3;
            coefficients[end] = kind == 0 ? 0 : kind == 1 ? infinity : uniform(random, 0.1, 10);
            const double at = end == 0 ? 0 : sides[c];
            if (kind != 0)
                parts.push_back(
                    {[c, at](const Eigen::RowVectorXd& p) { return std::abs(p[c] - at) < 1e-9; },
                     kind == 1 ? BoundaryCondition::essential : BoundaryCondition::robin,
                     kind == 1 ? 1 : coefficients[end]});
        }
        lists.push_back(interval_eigenvalues(sides[c], coefficients[0], coefficients[1], limit));
    }
    return {"box", unmerged(mesh, conditions_of(mesh, parts)), sums(lists, limit)};
}

KnownShape random_torus(std::mt19937& random) {
    const std::vector<int> cells{static_cast<int>(3 + random() % 3),
                                 static_cast<int>(3 + random() % 3)};
    const double a = uniform(random, 0.7, 1.4), b = uniform(random, 0.7, 1.4);
    const double shear = uniform(random, -2, 2);
    Mesh mesh = kuhn(cells, {a, b});
    shake(mesh, random, cells, {a, b}, 0.2);
    mesh.points.col(0) += shear * mesh.points.col(1);
    const double limit = 2000;
    std::vector<double> values; // 4 pi^2 |w|^2, w.(a, 0) and w.(shear b, b) integers
    for (int i = -60; i <= 60; ++i)
        for (int j = -60; j <= 60; ++j) {
            const double x = i / a, y = (j - i * shear * b / a) / b;
            if (const double value = 4 * pi * pi * (x * x + y * y); value < limit)
                values.push_back(value);
        }
    std::sort(values.begin(), values.end());
    return {"torus", unmerged(periodic(mesh, {Vector{{a, 0}}, Vector{{shear * b, b}}})), values};
}

KnownShape klein_bottle(std::mt19937& random, ShapeFunctions functions) {
    const std::vector<int> cells{static_cast<int>(4 + 2 * (random() % 2)), 4};
    const double a = uniform(random, 0.7, 1.4), b = uniform(random, 0.7, 1.4);
    Mesh mesh = split_boxes(cells, {a, b});
    shake(mesh, random, cells, {a, b}, 0.2);
    KnownShape result{"Klein bottle", glued_bottle(mesh, a, b), {}};
    result.shape.functions = functions;
    const double limit = 2000;
    const bool is_twisted = functions == ShapeFunctions::twisted;
    for (int m = 0; m < 20; ++m)     // cos (m > = 0) and sin (m > 0) of 2 pi m (x - a / 2) / a
        for (int k = 0; k < 40; ++k) // times cos and sin of pi k y / b
            for (const bool is_cosine : {true, false}) {
                const bool is_periodic = is_cosine != is_twisted;
                if ((m == 0 && !is_cosine) || (k % 2 == 0) != is_periodic)
                    continue;
                const double value = pi * pi * (4.0 * m * m / (a * a) + 1.0 * k * k / (b * b));
                if (value < limit)
                    result.eigenvalues.insert(result.eigenvalues.end(), k == 0 ? 1 : 2, value);
            }
    std::sort(result.eigenvalues.begin(), result.eigenvalues.end());
    return result;
}

KnownShape book(std::mt19937& random, int pages, int cells) {
    const double a = uniform(random, 0.7, 1.4), b = uniform(random, 0.7, 1.4);
    std::vector<double> angles;
    for (int page = 0; page < pages; ++page)
        angles.push_back(2 * pi * page / pages);
    const Mesh mesh = book_of(kuhn({cells, cells}, {a, b}), angles);
    const double limit = 2000;
    auto across = interval_eigenvalues(a, 0, 0, limit);
    const auto odd = repeated(interval_eigenvalues(a, infinity, 0, limit), pages - 1);
    across.insert(across.end(), odd.begin(), odd.end());
    return {"book", unmerged(mesh), sums({across, interval_eigenvalues(b, 0, 0, limit)}, limit)};
}

Mesh l_shape(int n) {
    return without(kuhn({2 * n, 2 * n}, {2, 2}),
                   [](const Vector& x) { return x[0] > 1 && x[1] < 1; });
}

Mesh pillow(int n) {
    const Mesh front = kuhn({n, n});
    Mesh both = united(front, front);
    const Index count = static_cast<Index>(front.points.rows());
    both.points.conservativeResize(Eigen::NoChange, 3);
    both.points.col(0).tail(count) = 1 - front.points.col(0).array(); // diagonals are mirrored
    for (Index v = 0; v < 2 * count; ++v) {                           // inner points keep apart
        const double x = both.points(v, 0), y = both.points(v, 1);
        const bool inner = std::min({x, y, 1 - x, 1 - y}) > 0.5 / n;
        both.points(v, 2) = !inner ? 0 : v < count ? 1 : -1;
    }
    Mesh mesh = weld(std::move(both)).mesh;
    mesh.points.col(2).setZero();
    return mesh;
}

Vector divided(const Pieces& pieces, const Vector& values) {
    const Simplices& edges = pieces.simplices(1);
    Vector result(values.size() + edges.rows());
    result.head(values.size()) = values;
    for (Index e = 0; e < edges.rows(); ++e)
        result[values.size() + e] = (values[edges(e, 0)] + values[edges(e, 1)]) / 2;
    return result;
}

Mesh divided(const Mesh& mesh) {
    const SimplicialComplex pieces(mesh.simplices);
    const auto& edges = pieces.simplices(1);
    const auto& triangles = pieces.simplices(2);
    const Index vertices = pieces.size(0);
    Mesh result;
    result.points.resize(vertices + edges.rows(), mesh.points.cols());
    for (Index v = 0; v < vertices; ++v)
        result.points.row(v) = mesh.points.row(pieces.vertex_number(v));
    for (Index e = 0; e < edges.rows(); ++e)
        result.points.row(vertices + e) =
            (result.points.row(edges(e, 0)) + result.points.row(edges(e, 1))) / 2;
    result.simplices.resize(4 * triangles.rows(), 3);
    for (Index t = 0; t < triangles.rows(); ++t) {
        Index middle[3];
        for (int i = 0; i < 3; ++i)
            middle[i] = vertices + pieces.face(2, t, i);
        for (int i = 0; i < 3; ++i)
            result.simplices.row(4 * t + i) << triangles(t, i), middle[(i + 1) % 3],
                middle[(i + 2) % 3];
        result.simplices.row(4 * t + 3) << middle[0], middle[1], middle[2];
    }
    return result;
}

KnownShape random_shape(std::mt19937& random) {
    switch (random() % 8) {
    case 0:
    case 1:
        return random_torus(random);
    case 2:
        return klein_bottle(random, ShapeFunctions::ordinary);
    case 3:
        return klein_bottle(random, ShapeFunctions::twisted);
    case 4:
        return book(random, static_cast<int>(3 + random() % 2), 2);
    case 5:
        return random_box(random, {2, 2, static_cast<int>(1 + random() % 2)});
    case 6:
        return random_box(random, {static_cast<int>(6 + random() % 3)});
    default:
        return random_box(random, {3, static_cast<int>(2 + random() % 3)});
    }
}

void expect_enclosed(const ShapeSpectrum& found, const std::vector<double>& eigenvalues,
                     double share) {
    const auto count = std::min<Index>(found.upper.size(), std::ssize(eigenvalues));
    for (Index j = 0; j < count; ++j) {
        EXPECT_LE(found.lower[j], eigenvalues[j] * (1 + share)) << j;
        EXPECT_GE(found.upper[j], eigenvalues[j] * (1 - share)) << j;
    }
}

std::vector<std::pair<std::string, Shape>> small_shapes() {
    const BoundaryConditions dirichlet{BoundaryCondition::essential};
    const BoundaryConditions robin{BoundaryCondition::robin, {}, {2.5}};
    Shape materials = unmerged(kuhn(2, 5));
    materials.conductivity = materials.density = Vector::Ones(50);
    materials.conductivity.head(20).setConstant(10);
    materials.density.tail(20).setConstant(3);
    return {{"square", unmerged(kuhn(2, 5))},
            {"fixed square", unmerged(kuhn(2, 5), dirichlet)},
            {"Robin's square", unmerged(kuhn(2, 5), robin)},
            {"materials", materials},
            {"tetrahedron", unmerged(tetrahedron_surface(4))},
            {"pillow", unmerged(pillow(4))},
            {"cube", unmerged(kuhn(3, 3))}};
}

} // namespace polydec::test
