// SPDX-License-Identifier: MIT
// Kelvin's theorem: without viscosity the circulation around a loop that the flow carries is kept.
#include "tests/solvers/flow_samples.h"

namespace polydec::test::in_kelvin {

/// Velocities anywhere in the unit square from those at places about a width apart, by quadratic
/// polynomials that fit those near by.
class Velocities {
public:
    Velocities(const Points& places, double width)
        : places_(places),
          width_(width),
          side_(static_cast<Index>(1 / (2 * width)) + 1),
          near_(side_ * side_) {
        for (Index i = 0; i < places.rows(); ++i)
            near_[box(places(i, 0)) * side_ + box(places(i, 1))].push_back(i);
    }

    Eigen::RowVector2d at(const Eigen::RowVector2d& x, const DenseMatrix& values) const {
        Eigen::Matrix<double, 6, 6> M = Eigen::Matrix<double, 6, 6>::Zero();
        Eigen::Matrix<double, 6, 2> b = Eigen::Matrix<double, 6, 2>::Zero();
        for (Index p = std::max<Index>(box(x[0]) - 1, 0); p <= box(x[0]) + 1 && p < side_; ++p)
            for (Index q = std::max<Index>(box(x[1]) - 1, 0); q <= box(x[1]) + 1 && q < side_; ++q)
                for (const Index i : near_[p * side_ + q]) {
                    const Eigen::RowVector2d y = (places_.row(i) - x) / width_;
                    if (y.squaredNorm() > 4)
                        continue;
                    Eigen::Matrix<double, 6, 1> terms;
                    terms << 1, y[0], y[1], y[0] * y[0], y[0] * y[1], y[1] * y[1];
                    const double weight = std::pow(1 - y.squaredNorm() / 4, 2);
                    M += weight * terms * terms.transpose();
                    b += weight * terms * values.row(i).leftCols<2>();
                }
        return Eigen::LLT<DenseMatrix>(M).solve(DenseMatrix(b)).row(0);
    }

private:
    Index box(double coordinate) const {
        return std::clamp<Index>(static_cast<Index>(coordinate * side_), 0, side_ - 1);
    }

    Points places_;
    double width_;
    Index side_;
    std::vector<std::vector<Index>> near_;
};

/// A loop of points, and what runs around it.
struct Loop {
    DenseMatrix points;

    explicit Loop(int count) : points(count, 2) {
        for (int i = 0; i < count; ++i)
            points.row(i) << 0.5 + 0.2 * std::cos(2 * pi * i / count),
                0.4 + 0.2 * std::sin(2 * pi * i / count);
    }

    DenseMatrix of(const Velocities& velocities, const DenseMatrix& values) const {
        DenseMatrix result(points.rows(), 2);
        for (Index i = 0; i < points.rows(); ++i)
            result.row(i) = velocities.at(points.row(i), values);
        return result;
    }

    double circulation(const DenseMatrix& velocity) const {
        const auto count = points.rows();
        double sum = 0;
        for (Index i = 0; i < count; ++i)
            sum += velocity.row(i).dot(points.row((i + 1) % count) -
                                       points.row((i + count - 1) % count)) /
                   2;
        return sum;
    }
};

/// Changes of the circulation around a loop, that the flow carries, and one that stays.
std::array<double, 2> changes(const char* shape, int cells) {
    const auto mesh = circumcentric(square(shape, cells));
    const IncompressibleFlow flow(mesh);
    const Vector start = flow.project(flow_of(mesh, [](const Vector& x) {
        return (std::sin(pi * x[0]) + 0.5 * std::sin(2 * pi * x[0])) * std::sin(pi * x[1]);
    }));
    const Velocities velocities(cell_centroids(mesh, 2), 1.0 / cells);
    constexpr double time = 0.3;
    const int steps = 2 * cells;
    const double dt = time / steps;
    Flow moving(flow, start, {.time_step = dt});
    const auto field = [&] { return flux_sharp(mesh, moving.form(0)); };
    const Loop fixed(256);
    Loop carried = fixed;
    DenseMatrix now = field();
    const double begin = fixed.circulation(fixed.of(velocities, now));
    for (int i = 0; i < steps; ++i) {
        const DenseMatrix first = carried.of(velocities, now);
        moving.advance();
        now = field();
        Loop ahead = carried;
        ahead.points += dt * first;
        carried.points += dt / 2 * (first + ahead.of(velocities, now));
    }
    return {std::abs(carried.circulation(carried.of(velocities, now)) / begin - 1),
            std::abs(fixed.circulation(fixed.of(velocities, now)) / begin - 1)};
}

TEST(Kelvin, circulation_around_carried_loops_is_kept_with_order_2) {
    for (const char* shape : {"quads", "triangles", "hexagons"}) {
        const auto coarse = changes(shape, 16), fine = changes(shape, 32);
        EXPECT_GE(std::log2(coarse[0] / fine[0]), 1.7) << shape << ' ' << coarse[0];
        EXPECT_LE(fine[0], 0.015) << shape;
        EXPECT_GT(fine[1], 0.05) << shape << ": nor does that around a loop that stays change";
    }
}

} // namespace polydec::test::in_kelvin
