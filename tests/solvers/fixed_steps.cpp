// SPDX-License-Identifier: MIT
#include "solvers/time/time_steps.h"
#include "tests/support/test.h"

namespace polydec::test::in_fixed_steps {

using Made = std::unique_ptr<FixedSteps>;

Made waves() {
    const auto mesh = discretize(kuhn(2, 4));
    return std::make_unique<Waves>(FormSpace(mesh, Side::primal, 0),
                                   Vector::LinSpaced(mesh.complex().size(0), 0, 1),
                                   WaveOptions{.time_step = 0.01, .layer = {{mesh, 0.3}}});
}

Made flow() {
    const auto mesh = discretize(kuhn(2, 4));
    const IncompressibleFlow equations(mesh, {.viscosity = 0.1});
    const Vector any = Vector::LinSpaced(mesh.complex().size(1), 0, 3).array().sin().matrix();
    return std::make_unique<Flow>(equations, equations.project(any), FlowSteps{0.01});
}

TEST(TimeSteps, are_the_fewest_that_are_no_longer_and_end_at_the_time) {
    for (const double longest : {0.1, 0.3, 7.0})
        for (const double time : {0.05, 0.3, 1.1, 20.0})
            for (const Index multiple : {1, 3, 20}) {
                const TimeSteps steps = time_steps(time, longest, multiple);
                EXPECT_EQ(steps.count % multiple, 0);
                EXPECT_DOUBLE_EQ(steps.count * steps.length, time);
                EXPECT_LE(steps.length, longest * (1 + 1e-7));
                if (steps.count > multiple)
                    EXPECT_GT(time / (steps.count - multiple), longest * (1 + 1e-7));
            }
    EXPECT_EQ(time_steps(2.1, 0.3).count, 7); // 2.1 / 0.3 is more than 7 by rounding
    EXPECT_EQ(time_steps(2, std::numeric_limits<double>::infinity()).length, 2);
}

TEST(TimeSteps, have_a_length_and_an_end) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double longest : {-0.5, 0.0, nan})
        EXPECT_REFUSED(time_steps(1, longest), "longest time step", "above 0");
    for (const double time : {-0.1, nan, std::numeric_limits<double>::infinity()})
        EXPECT_REFUSED(time_steps(time, 0.1), "the time is", "expected");
    EXPECT_REFUSED(time_steps(1e3, 1e-7), "1e+10 steps of 1e-07", "longer steps");
}

TEST(FixedSteps, resume_from_each_of_their_states) {
    for (const auto make : {waves, flow}) {
        const Made whole = make();
        whole->march(0.1);
        for (const int steps : {0, 1, 3, 7}) {
            const Made first = make(), second = make();
            first->advance(steps);
            second->advance(2);
            second->resume(first->time(), first->state());
            EXPECT_EQ(second->time(), first->time());
            second->march(0.1);
            EXPECT_EQ(second->state(), whole->state());
        }
        const Made rounded = make();
        rounded->resume(0.07, whole->state()); // not 7 * 0.01
        EXPECT_EQ(rounded->time(), 7 * 0.01);
    }
}

TEST(FixedSteps, resume_from_no_other_state) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto make : {waves, flow}) {
        const Made run = make();
        run->advance(5);
        const auto state = run->state();
        for (const double time : {0.014, 0.005, 1e-5})
            EXPECT_REFUSED(run->resume(time, state), "another run");
        for (const double time : {-0.01, 1e300, nan, std::numeric_limits<double>::infinity()}) {
            EXPECT_REFUSED(run->resume(time, state), "time", "expected 0 to");
            EXPECT_REFUSED(run->march(time), "time", "expected 0.05 to");
        }
        EXPECT_REFUSED(run->resume(0.01, {}), "another run");
        for (std::size_t i = 0; i < state.size(); ++i) {
            auto empty = state, not_finite = state;
            empty[i].resize(0);
            not_finite[i].tail(1).setConstant(nan);
            EXPECT_REFUSED(run->resume(0.01, empty), "another run");
            EXPECT_REFUSED(run->resume(0.01, not_finite), "another run");
        }
        EXPECT_EQ(run->state(), state);
        EXPECT_EQ(run->time(), 5 * 0.01);
    }
}

} // namespace polydec::test::in_fixed_steps
