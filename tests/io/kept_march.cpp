// SPDX-License-Identifier: MIT
#include "io/kept_march.h"

#include "io/checkpoint.h"
#include "meshes/generate.h"
#include "tests/io/support.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace polydec::test::in_kept_march {

namespace {

const std::vector<double> times{0.1, 0.2, 0.4, 0.5};

Evolution swing(const Discretization& mesh, double until_value = -2) {
    const Cochain u{Side::primal, 0, Vector::LinSpaced(mesh.complex().size(0), 0.5, 1)};
    return Evolution(mesh, {{.start = u, .diffusion = 0.1}},
                     [](double t, const std::vector<Cochain>& now) {
                         return std::vector{Vector(std::cos(9 * t) * now[0].values)};
                     },
                     {.event = [=](double, const std::vector<Cochain>& now) {
                         return now[0].values.maxCoeff() - until_value;
                     }});
}

struct Killed : std::runtime_error {
    Killed() : std::runtime_error("killed") {}
};

} // namespace

// The twin: without the memory of the integrator the bits are others.
TEST(KeptMarch, EndsInTheSameBitsWhereverItWasStopped) {
    const auto mesh = discretize(grid(4, 3));
    Evolution whole = swing(mesh);
    whole.march(times, [](const Evolution&) {});
    for (std::size_t stop = 1; stop <= times.size(); ++stop) {
        const TemporaryFolder folder;
        std::vector<double> shown;
        Evolution first = swing(mesh), second = swing(mesh);
        EXPECT_THROW(kept_march(first, times, folder.path("a"), 7,
                                [&](const Evolution& now) {
                                    shown.push_back(now.time());
                                    if (shown.size() == stop)
                                        throw Killed();
                                }),
                     Killed);
        kept_march(second, times, folder.path("a"), 7,
                   [&](const Evolution& now) { shown.push_back(now.time()); });
        EXPECT_EQ(shown.size(), times.size() + 1) << "the time of the kill is shown again";
        EXPECT_EQ(second.form(0).values, whole.form(0).values) << stop;

        Evolution third = swing(mesh);
        const Checkpoint end = read_checkpoint(folder.path("a"), 7);
        EXPECT_EQ(end.step, times.size());
        kept_march(third, times, folder.path("a"), 7, [](const Evolution&) { FAIL(); });
        EXPECT_EQ(third.form(0).values, whole.form(0).values);
    }
    Evolution forgetful = swing(mesh);
    forgetful.march(0.2);
    forgetful.resume(0.2, {forgetful.state()[0], Vector()});
    forgetful.march({0.4, 0.5}, [](const Evolution&) {});
    EXPECT_NE(forgetful.form(0).values, whole.form(0).values);
}

TEST(KeptMarch, StaysWhereAnEventHadEndedIt) {
    const auto mesh = discretize(grid(4, 3));
    const TemporaryFolder folder;
    Evolution first = swing(mesh, 1.05), second = swing(mesh, 1.05);
    EXPECT_EQ(kept_march(first, times, folder.path("a"), 7), Arrival::at_event);
    EXPECT_LT(first.time(), 0.5);
    EXPECT_EQ(kept_march(second, times, folder.path("a"), 7), Arrival::at_event);
    EXPECT_EQ(second.time(), first.time());
    EXPECT_EQ(second.form(0).values, first.form(0).values);
}

TEST(KeptMarch, RefusesCheckpointsOfOthers) {
    const auto mesh = discretize(grid(4, 3));
    const TemporaryFolder folder;
    Evolution run = swing(mesh);
    write_checkpoint(folder.path("a"), {.problem = 7, .state = {Vector::Zero(3)}});
    EXPECT_TRUE(says(error_of([&] { kept_march(run, times, folder.path("a"), 7); }),
                     {"InvalidInput", "checkpoint", "kept_march"}));
    write_checkpoint(folder.path("a"), {.problem = 8});
    EXPECT_THROW(kept_march(run, times, folder.path("a"), 7), InvalidInput);
    EXPECT_EQ(run.time(), 0);
}

} // namespace polydec::test::in_kept_march
