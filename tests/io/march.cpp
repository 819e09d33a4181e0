// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <thread>

namespace polydec::test::in_march {

const std::vector<double> times{0, 0.1, 0.2, 0.4, 0.5};

/// What a run may have otherwise than another one.
struct Problem {
    double material = 1, step = 0.02, until_value = -2;
    std::string label = "as written here";
    BoundaryCondition condition = BoundaryCondition::natural;
    StarKind star = StarKind::circumcentric;
    double fixed_step = 0; ///< of the evolution

    Discretization mesh() const {
        const auto empty = discretize(kuhn(2, 4), {.star = star});
        Vector weights = Vector::Ones(empty.complex().size(2));
        weights.tail(3).setConstant(material);
        return with_material(empty, 1, CellData::on_cells(weights));
    }
    static Vector start(const Discretization& mesh) {
        return Vector::LinSpaced(mesh.complex().size(0), 0.5, 1);
    }
    FormSpace space(const Discretization& mesh) const {
        return {mesh, Side::primal, 0, {condition}};
    }
};

using Made = std::unique_ptr<Run>;

Made heat(const Problem& problem) {
    const auto mesh = problem.mesh();
    return std::make_unique<Evolution>(
        std::vector<Unknown>{{problem.space(mesh), Problem::start(mesh), 1}}, Reaction(),
        EvolutionOptions{.integrator = "backward-euler", .steps = {.fixed_step = problem.step}});
}

Made waves(const Problem& problem) {
    const auto mesh = problem.mesh();
    const Vector u = Problem::start(mesh);
    return std::make_unique<Waves>(
        problem.space(mesh), u,
        WaveOptions{.time_step = problem.step,
                    .layer = AbsorbingLayer{mesh, 0.3},
                    .source = [=](double t) { return Vector(std::sin(9 * t) * u); },
                    .label = problem.label});
}

Made maxwell(const Problem& problem) {
    const auto box = discretize(kuhn(3, 2));
    return std::make_unique<Waves>(FormSpace(box, Side::primal, 1),
                                   Vector::LinSpaced(box.complex().size(1), 0, 1),
                                   WaveOptions{.time_step = problem.step});
}

Made flow(const Problem& problem) {
    const auto mesh = problem.mesh();
    const bool sticks = problem.condition == BoundaryCondition::essential;
    const IncompressibleFlow equations(
        mesh,
        {.viscosity = 0.1, .everywhere = sticks ? FlowBoundary::no_slip : FlowBoundary::free_slip});
    const Vector w =
        equations.project(Vector::LinSpaced(mesh.complex().size(1), 0, 3).array().sin().matrix());
    return std::make_unique<Flow>(equations, w, FlowSteps{problem.step});
}

Made evolution(const Problem& problem) {
    const auto mesh = problem.mesh();
    return std::make_unique<Evolution>(
        std::vector<Unknown>{{problem.space(mesh), Problem::start(mesh), 0.1}},
        [](double t, const std::vector<Cochain>& now) {
            return std::vector{Vector(std::cos(9 * t) * now[0].values)};
        },
        EvolutionOptions{.steps = {.first_step = problem.step, .fixed_step = problem.fixed_step},
                         .event =
                             [=](double, const std::vector<Cochain>& now) {
                                 return now[0].values.maxCoeff() - problem.until_value;
                             },
                         .label = problem.label});
}

const std::vector<Made (*)(const Problem&)> makers{heat, waves, flow, evolution};

bool are_same(const Run& one, const Run& other) {
    const auto a = one.forms(), b = other.forms();
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].values != b[i].values)
            return false;
    return one.time() == other.time() && a.size() == b.size();
}

struct Killed : std::runtime_error {
    Killed() : std::runtime_error("killed") {}
};

// The twin: without the memory of the integrator the bits are others.
TEST(March, ends_in_the_same_bits_wherever_it_was_killed) {
    for (const auto make : makers) {
        const auto whole = make({});
        march(*whole, times);
        for (std::size_t kill = 1; kill <= times.size(); ++kill) {
            const TemporaryFolder folder;
            const MarchOptions kept{.checkpoint = folder.path("a")};
            std::vector<double> shown;
            auto dying = kept, living = kept, none = kept;
            living.show = [&](const auto& now) { shown.push_back(now.time()); };
            dying.show = [&](const auto& now) {
                living.show(now);
                if (shown.size() == kill)
                    throw Killed();
            };
            none.show = [](const auto&) { FAIL(); };
            const auto first = make({}), second = make({}), third = make({});
            EXPECT_THROW(march(*first, times, dying), Killed);
            march(*second, times, living);
            EXPECT_EQ(shown.size(), times.size() + 1) << "the time of the kill is shown again";
            EXPECT_EQ(shown[kill], shown[kill - 1]);
            EXPECT_TRUE(are_same(*second, *whole)) << kill;
            march(*third, times, none);
            EXPECT_TRUE(are_same(*third, *whole));
        }
    }
    const auto whole = evolution({}), forgetful = evolution({});
    march(*whole, times);
    forgetful->march(0.2);
    forgetful->resume(0.2, {forgetful->state()[0], Vector()});
    march(*forgetful, {0.4, 0.5});
    EXPECT_FALSE(are_same(*forgetful, *whole));
}

// Between two times, where steps do not depend on them; else at the last of these.
TEST(March, that_is_stopped_goes_on_from_there) {
    for (const auto make : makers) {
        const auto whole = make({});
        march(*whole, times);
        for (const int asked : {0, 3, 8, 14}) {
            const TemporaryFolder folder;
            const auto first = make({}), second = make({});
            int before = 0;
            march(*first, times,
                  {.checkpoint = folder.path("a"), .stop = [&] { return before++ >= asked; }});
            EXPECT_LT(first->time(), 0.5);
            Frames rest(*second, times, {.checkpoint = folder.path("a")});
            if (first->resumes_anywhere() && std::filesystem::exists(folder.path("a"))) {
                EXPECT_EQ(second->time(), first->time());
            }
            EXPECT_LE(second->time(), first->time());
            while (rest.next()) {
            }
            EXPECT_TRUE(are_same(*second, *whole)) << asked;
        }
    }
}

// The twins are what differs: a material in a few cells, a condition, a star, a step, a label.
TEST(March, refuses_checkpoints_of_other_problems) {
    for (const auto make : makers) {
        const TemporaryFolder folder;
        const MarchOptions kept{.checkpoint = folder.path("a")};
        march(*make({}), times, kept);
        march(*make({}), times, kept);
        std::vector<Problem> others(4);
        others[0].material = 1 + 1e-15;
        others[1].condition = BoundaryCondition::essential;
        others[2].star = StarKind::galerkin;
        others[3].step = 0.01;
        if (make({.label = ""})->fingerprint() == std::nullopt)
            others.push_back({.label = "another"});
        for (std::size_t i = 0; i < others.size(); ++i) {
            if (i == 2 && make == flow)
                continue; // viscosity needs the other star
            const auto run = make(others[i]);
            EXPECT_REFUSED(march(*run, times, kept), "another", "option") << i;
            EXPECT_EQ(run->time(), 0);
        }
        const auto run = make({});
        const std::vector<std::vector<double>> others_in_time{
            {0, 0.1, 0.2, 0.3, 0.4}, {0, 0.1, 0.3, 0.4, 0.5, 0.6}, {0, 0.1, 0.2, 0.4}};
        for (const std::vector<double>& other : others_in_time)
            EXPECT_REFUSED(march(*run, other, kept), "another", "times");
        march(*run, {0, 0.1, 0.2, 0.4, 0.5, 0.6}, kept);
        EXPECT_NEAR(run->time(), 0.6, 1e-15);
    }
}

TEST(March, of_functions_is_kept_by_a_label_alone) {
    const TemporaryFolder folder;
    for (const auto make : {waves, evolution}) {
        const auto run = make({.label = ""});
        EXPECT_REFUSED(march(*run, times, {.checkpoint = folder.path("a")}), "functions", "label");
        march(*run, times);
    }
    const auto mesh = discretize(kuhn(2, 2));
    EXPECT_TRUE(Evolution({{{mesh, Side::primal, 0}, Problem::start(mesh), 1}}).fingerprint());
}

TEST(March, stays_where_an_event_had_ended_it) {
    const TemporaryFolder folder;
    const auto first = evolution({.until_value = 1.05}), second = evolution({.until_value = 1.05});
    const MarchOptions kept{.checkpoint = folder.path("a")};
    EXPECT_EQ(march(*first, times, kept), Arrival::at_event);
    EXPECT_LT(first->time(), 0.5);
    EXPECT_EQ(march(*second, times, kept), Arrival::at_event);
    EXPECT_TRUE(are_same(*second, *first));
}

TEST(March, refuses_files_of_others) {
    const TemporaryFolder folder;
    const auto run = heat({});
    const std::uint64_t problem = run->fingerprint()->value();
    for (const std::vector<Vector>& state : {std::vector<Vector>{}, {Vector::Zero(3)}}) {
        write_checkpoint(folder.path("a"), {.problem = problem, .state = state});
        EXPECT_REFUSED(march(*run, times, {.checkpoint = folder.path("a")}), "resumed", "march");
    }
    march(*heat({}), {0}, {.checkpoint = folder.path("a"), .resume = false});
    Checkpoint other = read_checkpoint(folder.path("a"), problem);
    other.state[0] = Vector::Zero(3);
    write_checkpoint(folder.path("a"), other);
    EXPECT_REFUSED(march(*run, times, {.checkpoint = folder.path("a")}), "state", "another");
    march(*run, times, {.checkpoint = folder.path("a"), .resume = false});
    EXPECT_THROW(run->march(0.1), InvalidInput);
}

// Evolutions divide the way to each time into equal steps; all others have one step for all times.
TEST(March, takes_as_many_steps_as_it_plans) {
    for (const auto make : {heat, waves, maxwell, flow, evolution}) {
        const auto run = make({.step = 0.03, .fixed_step = 0.03});
        const auto* evolving = dynamic_cast<const Evolution*>(run.get());
        const StepPlan plan = run->plan(times);
        std::int64_t taken = 0;
        march(*run, {0, 0.1}, {.progress = [&](double) { ++taken; }});
        const auto rest = run->plan(times).count;
        EXPECT_EQ(*rest + (evolving ? evolving->report().steps : taken), plan.count);
        march(*run, {0.2, 0.4, 0.5}, {.progress = [&](double) { ++taken; }});
        EXPECT_EQ(evolving ? evolving->report().steps : taken, plan.count);
        EXPECT_EQ(plan.count, evolving ? 4 + 4 + 7 + 4 : 17);
        EXPECT_EQ(plan.length, 0.03);
        EXPECT_EQ(run->plan(times).count, 0);
    }
    EXPECT_EQ(evolution({})->plan(times).count, std::nullopt);
}

TEST(March, does_not_go_back_before_the_start) {
    for (const auto make : {heat, waves, maxwell, flow, evolution})
        for (const double until : {-1e-9, -1e-3, -1.0, -1e99, std::nan("")}) {
            const auto run = make({});
            EXPECT_REFUSED(run->march(until), "time");
            EXPECT_REFUSED(march(*run, {until}), "time");
            EXPECT_EQ(run->time(), 0);
        }
}

TEST(March, announces_itself_once_if_it_is_long) {
    const auto run = waves({});
    std::vector<std::string> said;
    const auto hear = [&](std::string_view text) { said.emplace_back(text); };
    const auto brief = announcing(*run, {4}, hear), endless = announcing(*run, {1e5}, hear);
    for (const double time : {1, 2, 3}) {
        brief(time);
        endless(time);
        std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    }
    ASSERT_EQ(said.size(), 1);
    EXPECT_SAYS(said[0], "5,000,000 steps of 0.02", "limited by stability", "0-cell", "about", "h",
                "of memory", "WaveOptions::time_step");
}

// An end of the one short edge.
TEST(March, names_the_cell_that_limits_its_steps) {
    Mesh line = kuhn(1, 10);
    line.points(4, 0) = line.points(5, 0) - 0.01;
    const auto mesh = discretize(line);
    const Waves run(FormSpace(mesh, Side::primal, 0), Vector::Zero(11));
    const std::string limit = run.plan({1}).limit;
    EXPECT_TRUE(says(limit, {"stability", "0-cell 4"}) || says(limit, {"stability", "0-cell 5"}));
}

} // namespace polydec::test::in_march
