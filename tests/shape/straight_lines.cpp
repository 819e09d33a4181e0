// SPDX-License-Identifier: MIT
//
// Exact distances against all chains of straight lines, found without windows and without pruning.
#include "tests/shape/shapes.h"
#include "tests/solvers/glued_samples.h"

#include <complex>

namespace polydec::test::in_straight_lines {

using Point = std::complex<double>;

double cross(Point a, Point b) {
    return std::imag(std::conj(a) * b);
}

/// The lengths of the straight lines from a vertex to others, the least for each, through every
/// triangle once at most.
class StraightLines {
public:
    StraightLines(const MeasuredSurface& shape, double longest)
        : shape_(shape), longest_(longest), sides_(std::size_t(shape.surface.edges())) {
        for (Index h = 0; h < 3 * shape.surface.triangles(); ++h)
            sides_[shape.surface.edge(h)].push_back(h);
    }

    Vector from(Index v) {
        const Triangles& of = shape_.surface;
        found_ = Vector::Constant(of.vertices(), std::numeric_limits<double>::infinity());
        found_[v] = 0;
        for (Index h = 0; h < 3 * of.triangles(); ++h)
            if (of.tail(h) == v) {
                const Point a(length(h), 0), b = apex(0, a, h, 1);
                see(of.head(h), a);
                see(of.tail(of.previous(h)), b);
                passed_.assign(1, Triangles::triangle(h));
                leave(of.next(h), a, b, a, b);
            }
        return found_;
    }

private:
    double length(Index h) const { return shape_.lengths[shape_.surface.edge(h)]; }

    /// To the left (1) or right (-1) of the line from a to b, along which half-edge h runs.
    Point apex(Point a, Point b, Index h, int side) const {
        const double l = length(h), back = length(Triangles::previous(h)),
                     on = length(Triangles::next(h));
        const double x = (l * l + (back - on) * (back + on)) / (2 * l);
        const double y = std::sqrt(std::max((back - x) * (back + x), 0.0));
        return a + (b - a) / l * Point(x, side * y);
    }

    void see(Index v, Point place) { found_[v] = std::min(found_[v], std::abs(place)); }

    /// By half-edge g from a to b, as far as these lie between the directions right and left.
    void leave(Index g, Point a, Point b, Point right, Point left) {
        const auto [first, last] = cross(a, b) > 0 ? std::pair(a, b) : std::pair(b, a);
        right = cross(right, first) > 0 ? first : right;
        left = cross(last, left) > 0 ? last : left;
        if (!(cross(right, left) > 1e-14 * std::abs(right) * std::abs(left)) ||
            cross(first, last) / std::abs(b - a) > longest_)
            return;
        const Triangles& of = shape_.surface;
        for (const Index h : sides_[of.edge(g)]) {
            const Index t = Triangles::triangle(h);
            if (std::find(passed_.begin(), passed_.end(), t) != passed_.end())
                continue;
            passed_.push_back(t);
            of.sign(h) == of.sign(g) ? enter(h, a, b, right, left) : enter(h, b, a, right, left);
            passed_.pop_back();
        }
    }

    /// By half-edge h from a to b, on whose other side the vertex lies.
    void enter(Index h, Point a, Point b, Point right, Point left) {
        const Point c = apex(a, b, h, cross(b - a, -a) > 0 ? -1 : 1);
        const double rounding = 1e-13 * std::abs(c);
        if (cross(right, c) >= -rounding * std::abs(right) &&
            cross(c, left) >= -rounding * std::abs(left))
            see(shape_.surface.tail(Triangles::previous(h)), c);
        leave(Triangles::next(h), b, c, right, left);
        leave(Triangles::previous(h), c, a, right, left);
    }

    const MeasuredSurface& shape_;
    double longest_;
    std::vector<std::vector<Index>> sides_; // of edges
    Vector found_;
    std::vector<Index> passed_;
};

/// Distances between all vertices, along chains of straight lines; infinite between components.
DenseMatrix along_straight_lines(const MeasuredSurface& shape) {
    const Index n = shape.surface.vertices();
    DenseMatrix d = DenseMatrix::Constant(n, n, std::numeric_limits<double>::infinity());
    for (Index h = 0; h < 3 * shape.surface.triangles(); ++h) {
        const Index a = shape.surface.tail(h), b = shape.surface.head(h);
        d(a, b) = d(b, a) = std::min(d(a, b), shape.lengths[shape.surface.edge(h)]);
    }
    d.diagonal().setZero();
    const auto join = [&] {
        for (Index k = 0; k < n; ++k)
            for (Index j = 0; j < n; ++j)
                d.col(j) = d.col(j).cwiseMin((d.col(k).array() + d(k, j)).matrix());
    };
    join();
    // no line of use is longer than the longest chain of edges
    const double longest =
        d.unaryExpr([](double x) { return std::isfinite(x) ? x : 0; }).maxCoeff();
    StraightLines lines(shape, longest);
    for (Index v = 0; v < n; ++v)
        d.col(v) = d.col(v).cwiseMin(lines.from(v));
    join();
    return d;
}

struct Laws {
    MeasuredSurface shape;
    DenseMatrix exact; ///< column v: from vertex v
};

/// From every vertex of a shape, and from the first vertices of the components it is not on.
Laws laws_on(const MeasuredSurface& shape) {
    Laws laws{shape, {}};
    const Index n = laws.shape.surface.vertices();
    laws.exact.resize(n, n);
    const auto firsts = one_of_each_component(laws.shape.surface);
    const Vector from_firsts = exact_distance(laws.shape.surface, laws.shape.lengths, firsts);
    for (Index v = 0; v < n; ++v) {
        std::vector<Index> sources = firsts;
        sources.push_back(v);
        laws.exact.col(v) = exact_distance(laws.shape.surface, laws.shape.lengths, sources);
        // the least of the distances from each
        EXPECT_LE((laws.exact.col(v) - from_firsts).maxCoeff(), 1e-13);
        EXPECT_EQ(laws.exact(v, v), 0);
        if (firsts.size() == 1)
            laws.exact.col(v) =
                exact_distance(laws.shape.surface, laws.shape.lengths, std::vector<Index>{v});
    }
    return laws;
}

struct NamedShape {
    std::string name;
    MeasuredSurface shape;
};

/// Few triangles, glued in any way, of random lengths: no points have these distances.
MeasuredSurface from_nowhere(Index n, Closing closing, std::uint64_t seed) {
    auto [surface, lengths, points] = flat(n, closing);
    Random random(seed);
    for (double& length : lengths)
        length *= 1 + 0.15 * (2 * random.fraction() - 1);
    return {surface, lengths, {}};
}

std::vector<NamedShape> surfaces() {
    std::vector<NamedShape> result;
    for (const auto& [name, mesh] : meshes())
        if (mesh.simplices.cols() == 3 && mesh.simplices.rows() <= 400)
            result.push_back({name, measured(mesh)});
    result.push_back({"cube", measured(cube_surface(2))});
    result.push_back({"walls_of_cubes", measured(walls_of_cubes(2))});
    result.push_back({"touching_tetrahedra", measured(touching_tetrahedra())});
    for (const std::uint64_t seed : {1, 2, 3}) {
        result.push_back({"rough_hills", measured(perturbed(hills(3, 5), 0.15, seed))});
        result.push_back({"rough_torus", measured(perturbed(torus(8, 5), 0.2, seed))});
        result.push_back({"rough_sphere", measured(perturbed(icosphere(2), 0.3, seed))});
        result.push_back({"rough_moebius", measured(perturbed(moebius(9, 2), 0.15, seed))});
        result.push_back({"rough_walls", measured(perturbed(walls_of_cubes(1), 0.2, seed))});
        for (const Index n : {1, 2, 5})
            for (const Closing closing : {Closing::torus, Closing::klein_bottle})
                result.push_back({"from_nowhere", from_nowhere(n, closing, seed)});
    }
    return result;
}

TEST(StraightLines, in_chains_are_no_shorter_than_exact_distances_and_one_is_as_long) {
    for (const auto& [name, shape] : surfaces()) {
        if (shape.surface.triangles() > 130)
            continue;
        const Laws laws = laws_on(shape);
        const DenseMatrix chains = along_straight_lines(laws.shape);
        const auto firsts = one_of_each_component(laws.shape.surface);
        double worst = 0;
        for (Index v = 0; v < chains.cols(); ++v) {
            Vector expected = chains.col(v);
            if (firsts.size() > 1)
                for (const Index first : firsts)
                    expected = expected.cwiseMin(chains.col(first));
            worst = std::max(worst, (laws.exact.col(v) - expected).cwiseAbs().maxCoeff());
        }
        EXPECT_LE(worst, 1e-12 * chains.col(0).norm()) << name;
    }
}

TEST(ExactDistance, is_symmetric_and_grows_no_faster_than_the_way) {
    for (const auto& [name, shape] : surfaces()) {
        const Laws laws = laws_on(shape);
        const auto& d = laws.exact;
        const double size = d.maxCoeff();
        if (one_of_each_component(laws.shape.surface).size() == 1) {
            EXPECT_WITHIN(d, d.transpose(), 1e-13 * size) << name;
        }
        for (Index h = 0; h < 3 * laws.shape.surface.triangles(); ++h) {
            const Index a = laws.shape.surface.tail(h), b = laws.shape.surface.head(h);
            EXPECT_WITHIN(d.row(a), d.row(b),
                          laws.shape.lengths[laws.shape.surface.edge(h)] + 1e-13 * size)
                << name;
        }
    }
}

} // namespace polydec::test::in_straight_lines
