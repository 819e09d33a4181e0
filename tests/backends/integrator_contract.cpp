// SPDX-License-Identifier: MIT
#include "tests/backends/integrator_contract.h"

namespace polydec::test::in_integrator_contract {

TEST_P(IntegratorContract, fixed_steps_have_the_order_of_the_engine) {
    const auto traits = make()->traits();
    if (!traits.has_fixed_steps) {
        EXPECT_REFUSED(begun(swinging(), swung(0), {.fixed_step = 0.1}), GetParam(), "steps",
                       "tolerances", "fixed");
        return;
    }
    EXPECT_NEAR(order(swinging(), swung(0), swung(2), 2, 20), traits.explicit_order, 0.35);
    const Forced forced;
    for (const auto& problem : {forced.split(), forced.stiff_alone()})
        EXPECT_NEAR(order(problem, forced.exact(0), forced.exact(2), 2, 20), traits.implicit_order,
                    0.35);
    EXPECT_NEAR(order(cubic(0.5), Vector{{2}}, Vector{{2 + std::sin(2.0)}}, 2, 20),
                traits.implicit_order, 0.5);
}

TEST_P(IntegratorContract, errors_are_about_what_the_tolerances_allow) {
    const Forced forced;
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const IntegratorOptions options{.relative_tolerance = tolerance,
                                        .absolute_tolerance = tolerance};
        const auto expect_small = [&](const InitialValueProblem& problem, const Vector& begin,
                                      const Vector& end) {
            const auto run = begun(problem, begin, options);
            run->advance(3);
            EXPECT_WITHIN(run->state(), end, 100 * tolerance);
        };
        expect_small(swinging(), swung(0), swung(3));
        expect_small(forced.mild_alone(), forced.exact(0), forced.exact(3));
        expect_small(forced.split(), forced.exact(0), forced.exact(3));
        expect_small(forced.stiff_alone(), forced.exact(0), forced.exact(3));
    }
}

// The twin: the same rate takes many steps where nobody says that it is stiff.
TEST_P(IntegratorContract, stiffness_costs_no_steps_where_it_is_told) {
    const IntegratorOptions options{.absolute_tolerance = 1e-5, .most_steps = 5000};
    const auto steps_of = [&](double stiffness, bool is_split) {
        const Forced forced{.stiffness = stiffness};
        const auto run =
            begun(is_split ? forced.split() : forced.stiff_alone(), forced.exact(0), options);
        run->advance(3);
        EXPECT_LE((run->state() - forced.exact(3)).norm(), 1e-4);
        EXPECT_LT(run->report().preparations, 100);
        EXPECT_GE(run->report().solves, run->report().steps);
        return run->report().steps;
    };
    for (const bool is_split : {false, true})
        EXPECT_LE(steps_of(1e8, is_split), 1.5 * steps_of(1e5, is_split));
    const Forced forced{.stiffness = 1e5};
    const auto untold = begun(forced.mild_alone(), forced.exact(0), options);
    EXPECT_THROW(untold->advance(3), SolverFailure);
    EXPECT_GT(untold->time(), 0);
}

TEST_P(IntegratorContract, stiff_rates_need_not_be_linear) {
    const auto run = begun(cubic(1e5), Vector{{2}});
    run->advance(5);
    EXPECT_NEAR(run->state()[0], 2 + std::sin(5.0), 1e-3);
    EXPECT_LT(run->report().steps, 400);
}

TEST_P(IntegratorContract, a_transient_is_followed) {
    const auto run = begun(cubic(1e3), Vector{{5}}, {.relative_tolerance = 1e-6});
    run->advance(1);
    EXPECT_NEAR(run->state()[0], 2 + std::sin(1.0), 1e-4);
}

TEST_P(IntegratorContract, marches_end_at_the_times_that_are_asked_for) {
    const auto run = begun(swinging(), swung(0), {.relative_tolerance = 1e-7});
    for (const double time : {0.1, 0.1, 0.100001, 0.3, std::numbers::pi}) {
        EXPECT_EQ(run->advance(time), Arrival::at_time);
        EXPECT_EQ(run->time(), time);
        EXPECT_LE((run->state() - swung(time)).norm(), 1e-5);
    }
    EXPECT_REFUSED(run->advance(1), GetParam(), "time 3.141592653589793", "1");
}

TEST_P(IntegratorContract, frames_cost_few_factorizations) {
    const Forced forced{.stiffness = 1e4};
    const auto run = begun(forced.split(), forced.exact(0));
    for (int frame = 1; frame <= 100; ++frame)
        run->advance(0.1 * frame);
    EXPECT_LE((run->state() - forced.exact(10)).norm(), 1e-3);
    EXPECT_LT(run->report().preparations, run->report().steps / 2);
}

TEST_P(IntegratorContract, a_march_stops_at_events_and_goes_on_behind_them) {
    auto problem = swinging();
    problem.event = [](double, const Vector& y) { return y[0]; };
    const auto run = begun(problem, swung(0), {.relative_tolerance = 1e-9});
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(run->advance(20), Arrival::at_event);
        EXPECT_NEAR(run->time(), (i + 0.5) * std::numbers::pi, 1e-6);
        EXPECT_NEAR(run->state()[0], 0, 1e-6);
        EXPECT_LE((run->state() - swung(run->time())).norm(), 1e-6);
    }
    EXPECT_EQ(run->advance(3 * std::numbers::pi), Arrival::at_time);
    EXPECT_LE((run->state() - swung(run->time())).norm(), 1e-6);
}

TEST_P(IntegratorContract, events_that_fail_leave_the_state_of_the_time) {
    auto problem = swinging();
    problem.event = [](double t, const Vector&) { return t > 1 ? NAN : 1; };
    const auto run = begun(problem, swung(0), {.relative_tolerance = 1e-9});
    EXPECT_ERROR(SolverFailure, run->advance(20), "event", "nan");
    EXPECT_GT(run->time(), 0);
    EXPECT_LE((run->state() - swung(run->time())).norm(), 1e-6);
}

TEST_P(IntegratorContract, events_of_stiff_problems_are_found) {
    auto problem = Forced{.stiffness = 1e5, .size = 1}.split();
    problem.event = [](double, const Vector& y) { return y[0]; };
    const auto run = begun(problem, Vector{{1}}, {.relative_tolerance = 1e-7});
    EXPECT_EQ(run->advance(3), Arrival::at_event);
    EXPECT_NEAR(run->time(), std::numbers::pi / 2, 1e-5);
}

// The twin: without the memory it goes on with other steps.
TEST_P(IntegratorContract, what_goes_on_from_its_memory_ends_in_the_same_bits) {
    const Forced forced{.stiffness = 300};
    const InitialValueProblem fading{
        .rate = [](double, const Vector& y) { return Vector(-9 * y); }};
    for (const auto& problem : {swinging(), fading, forced.split(), forced.stiff_alone()}) {
        const Vector begin = problem.stiff ? forced.exact(0) : swung(0);
        const auto whole = begun(problem, begin);
        whole->advance(1);
        const Vector middle = whole->state(), memory = whole->memory();
        whole->advance(2);
        const auto end_of = [&](const Vector& remembered) {
            const auto rest = make();
            rest->begin(problem, 1, middle, remembered);
            rest->advance(2);
            return rest->state();
        };
        EXPECT_LE((end_of(memory) - whole->state()).norm(), 1e-3);
        if (make()->traits().resumes_exactly) {
            EXPECT_EQ(end_of(memory), whole->state());
            EXPECT_NE(end_of({}), whole->state());
        }
    }
    EXPECT_THROW(make()->begin(swinging(), 0, swung(0), Vector{{1, 2, 3}}), InvalidInput);
}

// The first step is too long, so that some events follow a step that was rejected.
TEST_P(IntegratorContract, what_goes_on_from_an_event_ends_in_the_same_bits) {
    if (!make()->traits().resumes_exactly)
        return;
    const IntegratorOptions options{.relative_tolerance = 1e-7, .first_step = 0.5};
    for (int pace = 5; pace < 100; ++pace) {
        auto problem = swinging();
        problem.event = [pace](double t, const Vector&) { return std::cos(pace * t); };
        const auto to_the_end = [](Integrator& run) {
            while (run.advance(1) == Arrival::at_event)
                ;
            return run.state();
        };
        const auto whole = begun(problem, swung(0), options);
        const Vector end = to_the_end(*begun(problem, swung(0), options));
        while (whole->advance(1) == Arrival::at_event) {
            const auto rest = make(options);
            rest->begin(problem, whole->time(), whole->state(), whole->memory());
            EXPECT_EQ(to_the_end(*rest), end) << "from " << whole->time();
        }
    }
}

TEST_P(IntegratorContract, a_problem_without_entries_is_solved_at_once) {
    const auto run = begun(swinging(), Vector());
    EXPECT_EQ(run->advance(5), Arrival::at_time);
    EXPECT_EQ(run->time(), 5);
    EXPECT_EQ(run->state().size(), 0);
    const auto with_event = [](double at) {
        auto problem = swinging();
        problem.event = [at](double t, const Vector&) { return at > 0 ? t - at : NAN; };
        return problem;
    };
    const auto stopped = begun(with_event(3), Vector());
    EXPECT_EQ(stopped->advance(5), Arrival::at_event);
    EXPECT_EQ(stopped->time(), 3);
    EXPECT_EQ(stopped->advance(5), Arrival::at_time);
    const auto failing = begun(with_event(-1), Vector());
    EXPECT_ERROR(SolverFailure, failing->advance(5), "event", "nan");
    EXPECT_EQ(failing->time(), 0);
}

TEST_P(IntegratorContract, what_is_no_number_is_refused_by_its_place) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_REFUSED(begun(swinging(), Vector{{1, nan}}), GetParam(), "entry 1", "state", "nan");
    const auto from_the_beginning = begun({.rate =
                                               [nan](double, const Vector&) {
                                                   return Vector{{0, nan}};
                                               }},
                                          swung(0));
    EXPECT_ERROR(SolverFailure, from_the_beginning->advance(1), GetParam(), "0 steps", "time 0",
                 "entry 1", "rate", "nan");
    Index calls = 0;
    const auto later = begun({.rate =
                                  [nan, &calls](double t, const Vector& y) {
                                      ++calls;
                                      return t < 0.5 ? Vector(-y) : Vector{{nan, nan}};
                                  }},
                             swung(0));
    EXPECT_THROW(later->advance(1), SolverFailure);
    EXPECT_LE(calls, 1000) << "steps came to nothing";
    EXPECT_LE(later->time(), 0.5);
    EXPECT_TRUE(later->state().allFinite());
}

TEST_P(IntegratorContract, what_a_rate_throws_passes_through) {
    struct Mine {};
    const auto run = begun({.rate = [](double t, const Vector& y) -> Vector {
                               if (t > 0.5)
                                   throw Mine{};
                               return -y;
                           }},
                           swung(0));
    EXPECT_THROW(run->advance(1), Mine);
}

TEST_P(IntegratorContract, scales_measure_what_is_small) {
    const IntegratorOptions options{.relative_tolerance = 0, .absolute_tolerance = 1e-6};
    auto problem = swinging();
    const auto plain = begun(problem, 1e-9 * swung(0), options);
    plain->advance(2);
    problem.scale = Vector{{1e-9, 1e-9}};
    const auto scaled = begun(problem, 1e-9 * swung(0), options);
    scaled->advance(2);
    EXPECT_LE((scaled->state() - 1e-9 * swung(2)).norm(), 1e-13);
    EXPECT_GT(scaled->report().steps, plain->report().steps);
}

/// A source that is 0 at the beginning, in the middle and at the end of a march to 1, beside decay.
InitialValueProblem pulsed(double size, bool is_stiff) {
    const auto pulse = [size](double t) {
        const double at = (t - 0.27) / 0.02;
        return Vector(t > 0.2 && t < 0.34 ? size * std::exp(-at * at) * Vector{{1, 1e-3}}
                                          : Vector(Vector::Zero(2)));
    };
    const auto weight = std::make_shared<double>(1);
    if (!is_stiff)
        return {.rate = [=](double t, const Vector& y) { return Vector(pulse(t) - 3 * y); }};
    return {.rate = [=](double t, const Vector&) { return pulse(t); },
            .stiff = StiffPart{
                .rate = [](double, const Vector& y) { return Vector(-3 * y); },
                .prepare = [=](double, const Vector&, double gamma) { *weight = 1 + 3 * gamma; },
                .solve = [=](const Vector& b) { return Vector(b / *weight); },
                .linearity = Linearity::linear}};
}

// With sqrt(pi)/50 exp(-3(1-.27)+.0009/4*9) at the end. The twin: an absolute tolerance that is
// given is not in the unit of the values.
TEST_P(IntegratorContract, linear_problems_take_the_same_steps_in_any_unit_of_values) {
    const double at_end = std::sqrt(std::numbers::pi) / 50 * std::exp(-3 * 0.73 + 9e-4);
    for (const bool is_stiff : {false, true}) {
        const auto end_of = [&](double size, const IntegratorOptions& options) {
            const auto run = begun(pulsed(size, is_stiff), Vector::Zero(2), options);
            for (int frame = 1; frame <= 20; ++frame)
                run->advance(frame / 20.);
            return Vector{{run->state()[0] / size, run->state()[1] / size,
                           static_cast<double>(run->report().steps)}};
        };
        const Vector expected = end_of(1, {});
        EXPECT_NEAR(expected[0] / at_end, 1, 1e-3);
        for (const double size : {0x1p-200, 0x1p-30, 0x1p200})
            EXPECT_EQ(end_of(size, {}), expected) << size;
        const IntegratorOptions given{.absolute_tolerance = 1e-8};
        EXPECT_NE(end_of(0x1p-30, given), end_of(1, given));
    }
}

// The twin: in one part, the second entry is measured by the first.
TEST_P(IntegratorContract, parts_have_units_of_their_own) {
    const auto end_of = [&](double unit, const std::vector<Index>& parts, double second = 1) {
        const InitialValueProblem problem{.rate =
                                              [=](double t, const Vector& y) {
                                                  return Vector{{std::cos(t) * y[0] - y[1] / unit,
                                                                 std::cos(t) * y[1] + unit * y[0]}};
                                              },
                                          .parts = parts};
        const auto run = begun(problem, Vector{{1, second * unit}});
        run->advance(3);
        return Vector{{run->state()[0], run->state()[1] / unit}};
    };
    for (const double unit : {0x1p-60, 0x1p60}) {
        EXPECT_EQ(end_of(unit, {1, 1}), end_of(1, {1, 1}));
        EXPECT_NE(end_of(unit, {2}), end_of(1, {2}));
        if (make()->traits().resumes_exactly) // CVODE weighs errors by what was before a step
            EXPECT_EQ(end_of(unit, {1, 1}, 0), end_of(1, {1, 1}, 0));
    }
    EXPECT_REFUSED(end_of(1, {1, 2}), GetParam(), "parts", "3", "2 entries");
}

// y = t attracts, and the rate is not a number where y < t - .01, such as at the end of a long
// step.
TEST_P(IntegratorContract, engines_solve_for_numbers_alone_after_steps_beyond_where_rates_exist) {
    const auto weight = std::make_shared<double>(1);
    const InitialValueProblem problem{
        .rate =
            [](double t, const Vector& y) {
                return Vector{{2 - 10 * std::sqrt(0.01 + y[0] - t) + 3 * y[0]}};
            },
        .stiff = StiffPart{
            .rate = [](double, const Vector& y) { return Vector(-3 * y); },
            .prepare = [=](double, const Vector&, double gamma) { *weight = 1 + 3 * gamma; },
            .solve =
                [=](const Vector& b) {
                    if (!b.allFinite())
                        throw InvalidInput("not a number");
                    return Vector(b / *weight);
                },
            .linearity = Linearity::linear}};
    for (const double first_step : {0.05, 0.5}) {
        const auto run = begun(problem, Vector{{0.005}}, {.first_step = first_step});
        run->advance(1);
        EXPECT_GT(run->report().rejected, 0);
        EXPECT_NEAR(run->state()[0], 1, 1e-5);
    }
}

TEST_P(IntegratorContract, what_makes_no_sense_is_refused) {
    EXPECT_REFUSED(make({.absolute_tolerance = 0}), GetParam(), "absolute_tolerance is 0");
    EXPECT_REFUSED(make({.relative_tolerance = 0}), GetParam(), "absolute_tolerance",
                   "relative_tolerance is 0");
    EXPECT_REFUSED(make({.first_step = -1}), GetParam(), "first_step", "-1");
    EXPECT_REFUSED(make({.first_step = 2, .largest_step = 1}), GetParam(), "first_step is 2",
                   "largest_step, 1");
    EXPECT_NO_THROW(make({.first_step = 1, .largest_step = 1}));
    EXPECT_THROW(make({.most_steps = 0}), InvalidInput);
    EXPECT_THROW(begun({}, swung(0)), InvalidInput);
    EXPECT_THROW(begun({.stiff = StiffPart{}}, swung(0)), InvalidInput);
    EXPECT_THROW(make()->advance(1), InvalidInput);
    auto problem = swinging();
    problem.scale = Vector{{1, -1}};
    EXPECT_THROW(begun(problem, swung(0)), InvalidInput);
    const auto short_rate =
        begun({.rate = [](double, const Vector&) { return Vector{{1}}; }}, swung(0));
    EXPECT_REFUSED(short_rate->advance(1), GetParam(), "rate", "1", "2", "state");
}

TEST_P(IntegratorContract, tells_of_the_time_and_ends_where_that_throws) {
    double limit = 1.5;
    int told = 0;
    auto problem = swinging();
    problem.progress = [&](double t) {
        ++told;
        if (t > limit)
            throw std::runtime_error("enough");
    };
    const auto run = begun(problem, swung(0), {.relative_tolerance = 1e-8});
    EXPECT_THROW(run->advance(3), std::runtime_error);
    EXPECT_LE(run->time(), limit);
    EXPECT_GT(told, 5);
    limit = 9;
    run->advance(3);
    EXPECT_NEAR((run->state() - swung(3)).norm(), 0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(engines, IntegratorContract,
                         testing::ValuesIn(names_of_those_that_choose()),
                         [](const auto& engine) { return test_name(engine.param); });

} // namespace polydec::test::in_integrator_contract
