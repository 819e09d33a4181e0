// SPDX-License-Identifier: MIT
#include "tests/backends/integrator_contract.h"

namespace polydec::test::in_integrator_contract {

/// What engines promise of steps of one length.
class StepsOfOneLength : public IntegratorContract {};

// Also at a moment within a step, as progress sees it. The twin: without the memory the rest of the
// time is divided anew, which rounds otherwise.
TEST_P(StepsOfOneLength, go_on_in_the_same_bits_from_between_two_times) {
    struct Moment {
        double time;
        Vector state, memory;
    };
    const IntegratorOptions options{.fixed_step = 0.03};
    EXPECT_TRUE(make(options)->traits().resumes_anywhere);
    const Forced forced;
    const double first = 1000, last = 1001;
    for (const auto& problem : {swinging(), forced.split(), forced.stiff_alone()}) {
        const auto whole = make(options);
        std::vector<Moment> moments;
        auto watched = problem;
        watched.progress = [&](double) {
            moments.push_back({whole->time(), whole->state(), whole->memory()});
        };
        whole->begin(watched, first, problem.stiff ? forced.exact(first) : swung(first));
        whole->advance(last);
        const auto end_from = [&](const Moment& moment, const Vector& memory) {
            const auto rest = make(options);
            rest->begin(problem, moment.time, moment.state, memory);
            rest->advance(last);
            return rest->state();
        };
        Index between = 0, others = 0;
        for (const Moment& moment : moments) {
            if (moment.time == last)
                continue;
            EXPECT_EQ(end_from(moment, moment.memory), whole->state()) << moment.time;
            between += moment.time > first;
            others += end_from(moment, {}) != whole->state();
        }
        EXPECT_GE(between, 33);
        EXPECT_GT(others, 0);
    }
}

TEST_P(StepsOfOneLength, have_their_order_and_are_asked_for_where_there_are_no_others) {
    if (!of_one_length.contains(GetParam())) {
        EXPECT_FALSE(make()->traits().resumes_anywhere);
        return;
    }
    EXPECT_REFUSED(make(), GetParam(), "fixed_step above 0");
    const double expected = of_one_length.at(GetParam());
    const Forced forced;
    EXPECT_NEAR(order(swinging(), swung(0), swung(2), 2, 80), expected, 0.2);
    for (const auto& problem : {forced.split(), forced.stiff_alone()})
        EXPECT_NEAR(order(problem, forced.exact(0), forced.exact(2), 2, 80), expected, 0.2);
}

TEST_P(StepsOfOneLength, go_on_from_no_memory_of_other_steps) {
    const auto problem = swinging();
    const auto own = make({.fixed_step = 0.1});
    own->begin(problem, 0, swung(0));
    own->advance(0.5);
    const Vector memory = own->memory();
    for (const std::string other : {"runge-kutta", "backward-euler", "implicit-midpoint"})
        for (const double step : {0.1, 0.05}) {
            const auto run = make_integrator(other, {.fixed_step = step});
            run->begin(problem, 0, swung(0));
            run->advance(0.5);
            const auto resumed = [&] { own->begin(problem, 0.5, swung(0.5), run->memory()); };
            if (other == GetParam() && step == 0.1)
                EXPECT_NO_THROW(resumed());
            else
                EXPECT_REFUSED(resumed(), GetParam(), "another") << other << ' ' << step;
        }
    EXPECT_NO_THROW(own->begin(problem, 0.5, swung(0.5), memory));
}

INSTANTIATE_TEST_SUITE_P(engines, StepsOfOneLength,
                         testing::Values("runge-kutta", "backward-euler", "implicit-midpoint"),
                         [](const auto& engine) { return test_name(engine.param); });

} // namespace polydec::test::in_integrator_contract
