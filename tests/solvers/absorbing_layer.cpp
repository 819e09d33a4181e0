// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_absorbing_layer {

/// A pulse in the middle, which runs in all directions: round about it for 1-forms.
Cochain pulse(const Discretization& box, Side side, int degree, double width) {
    const auto height = [width](const Vector& x) {
        return std::exp(-x.squaredNorm() / (width * width));
    };
    const SmoothForm form =
        degree == 0 ? function_form(height) : circulation_form([&](const Vector& x) -> Vector {
            Vector around = Vector::Zero(x.size());
            around.head(2) << -x[1] * height(x), x[0] * height(x);
            return around;
        });
    return side == Side::primal ? de_rham(box, degree, form) : dual_de_rham(box, degree, form);
}

/// A box of cubes of size 1 around the origin.
struct Experiment {
    int n;
    Side side;
    int degree;
    int inner;        ///< where waves are looked at, in cells from the middle
    double layer;     ///< its width
    double width = 3; ///< of the pulse
    LayerKind kind = LayerKind::automatic;
    bool memory = true;
    /// An eighth of it alone: a field around the last axis is as behind conductors that hold this
    /// axis, and before a magnetic wall across it.
    bool octant = false;
};

Discretization box_of(const Experiment& experiment, int half) {
    const int n = experiment.n;
    if (experiment.octant)
        return circumcentric(kuhn(std::vector<int>(n, half), std::vector<double>(n, half)));
    Mesh mesh = kuhn(std::vector<int>(n, 2 * half), std::vector<double>(n, 2.0 * half));
    mesh.points.array() -= half;
    return circumcentric(mesh);
}

BoundaryConditions conditions_of(const Experiment& experiment, const Discretization& box) {
    if (!experiment.octant)
        return built_in_conditions(experiment.side);
    return essential_where(facet_sites(box),
                           [](const Vector& x) { return x[x.size() - 1] > 1e-9; });
}

/// The values in the inner part over time, in the order of places.
std::vector<double> watched(const Experiment& experiment, int half, bool with_layer) {
    const auto& [n, side, degree, inner, layer, width, kind, memory, octant] = experiment;
    const auto box = box_of(experiment, half);
    const int e = side == Side::primal ? degree : n - degree;
    const int b = side == Side::primal ? e + 1 : e - 1;
    std::vector<Index> inside; // cells of grids of one kind are in one order
    const Points centers = cell_centers(box, e);
    for (Index i = 0; i < centers.rows(); ++i)
        if (centers.row(i).cwiseAbs().maxCoeff() < inner - 0.9)
            inside.push_back(i);

    WaveOptions options{.time_step = 0.9 / std::sqrt(n), .B = Vector::Zero(box.complex().size(b))};
    if (with_layer)
        options.layer = {box, layer, kind};
    if (with_layer && octant)
        options.layer->sides = {{false, true}, {false, true}, {false, true}};
    Waves waves({box, side, degree, conditions_of(experiment, box)},
                pulse(box, side, degree, width).values, options);
    std::vector<double> values;
    while (waves.time() < 2 * inner + 4 * width) {
        waves.advance();
        auto state = waves.state();
        if (!memory)
            state[3].setZero();
        waves.resume(waves.time(), state);
        for (const Index i : inside)
            values.push_back(state[0][i]);
    }
    return values;
}

/// The largest difference as a part of the largest value.
double difference(const std::vector<double>& found, const std::vector<double>& wanted) {
    EXPECT_EQ(found.size(), wanted.size());
    return relative_difference(Vector(Vector::Map(found.data(), std::ssize(found))),
                               Vector(Vector::Map(wanted.data(), std::ssize(wanted))));
}

/// What comes back from the layer: the difference from a box so large that nothing can come back in
/// time.
double reflection(const Experiment& experiment) {
    const int layer = static_cast<int>(experiment.layer);
    const int far = 2 * experiment.inner + static_cast<int>(3 * experiment.width);
    return difference(watched(experiment, experiment.inner + layer, true),
                      watched(experiment, far, false));
}

TEST(StretchedLayers, throw_back_less_than_1e4th_of_a_pulse_of_all_directions) {
    for (const Side side : {Side::primal, Side::dual})
        for (const int degree : {0, 1})
            EXPECT_LT(reflection({2, side, degree, 12, 10}), 1e-4) << name(side) << ' ' << degree;
}

TEST(StretchedLayers, throw_back_less_than_1e4th_of_a_pulse_of_light_in_space) {
    EXPECT_LT(reflection({3, Side::primal, 1, 6, 10, 2, LayerKind::automatic, true, true}), 1e-4);
}

TEST(StretchedLayers, need_their_memory_and_their_width) {
    EXPECT_GT(
        reflection(
            {.n = 2, .side = Side::primal, .degree = 0, .inner = 12, .layer = 10, .memory = false}),
        1e-2);
    EXPECT_GT(reflection({2, Side::primal, 0, 12, 3}), 1e-3);
}

TEST(StretchedLayers, get_better_with_their_width) {
    const double thin = reflection({2, Side::primal, 0, 12, 6});
    EXPECT_LT(reflection({2, Side::primal, 0, 12, 12}), thin / 10);
}

TEST(ConductingLayers, are_worse_where_waves_come_aslant) {
    const double both[] = {reflection({2, Side::primal, 0, 12, 10}),
                           reflection({2, Side::primal, 0, 12, 10, 3, LayerKind::conducting})};
    EXPECT_GT(both[1], 10 * both[0]);
    EXPECT_LT(both[1], 0.03);
}

/// What comes back of a plane pulse that runs along a box of cells which are no boxes, between
/// walls along which nothing flows.
double straight_reflection(const std::function<Mesh(int length)>& mesh, double of_layer) {
    constexpr double height = 24, until = 70, width = 20;
    const auto low_values = [&](int length, bool with_layer) {
        const auto box = circumcentric(mesh(length));
        const BoundaryConditions free{BoundaryCondition::natural};
        const double step = 0.4;
        const Vector z = box.points().rightCols(1);
        WaveOptions options{.time_step = step, .B = Vector::Zero(box.complex().size(1))};
        if (with_layer)
            options.layer = {.mesh = box,
                             .width = width,
                             .sides = {{false, false}, {false, false}, {false, true}},
                             .reflection = of_layer};
        Waves waves({box, Side::primal, 0, free}, (-((z.array() - 8) / 4).square()).exp(), options);
        std::vector<double> values;
        waves.march(until, [&](double) {
            const Vector E = waves.form(0).values;
            for (Index i = 0; i < z.size(); ++i)
                if (z[i] < height)
                    values.push_back(E[i]);
        });
        std::sort(values.begin(), values.end()); // vertices are numbered otherwise
        return values;
    };
    return difference(low_values(static_cast<int>(height + width), true), low_values(60, false));
}

TEST(ConductingLayers, throw_back_less_than_1e4th_of_what_comes_straight_on_octahedra) {
    const auto octahedra = [](int length) { return fcc({2, 2, length / 2}, 2.0); };
    EXPECT_LT(straight_reflection(octahedra, 1e-6), 1e-4);
    EXPECT_GT(straight_reflection(octahedra, 1e-2), 1e-3) << "a weak one";
}

} // namespace polydec::test::in_absorbing_layer
