// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <sys/wait.h>
#include <unistd.h>

namespace polydec::test::in_series {

Discretization square() {
    return discretize(grid(3, 2));
}

/// A form that is another one at every time.
Cochain moving(const Discretization& mesh, Side side, int degree, double time) {
    const int k = side == Side::primal ? degree : mesh.dimension() - degree;
    Vector values(mesh.complex().size(k));
    for (Index i = 0; i < values.size(); ++i)
        values[i] = std::sin(time * (i + 1));
    return {side, degree, values};
}

/// How many steps a page has.
std::size_t steps_in(const std::filesystem::path& page) {
    const std::string text = read_text(page), begin = "\"steps\":[";
    const auto at = text.find(begin) + begin.size(), end = text.find(']', at);
    return at == end ? 0
                     : 1 + static_cast<std::size_t>(
                               std::count(text.begin() + at, text.begin() + end, ','));
}

TEST(Series, HoldsEveryFormAtEveryTime) {
    const auto mesh = square();
    const TemporaryFolder folder;
    for (const Side side : {Side::primal, Side::dual})
        for (int degree = 0; degree <= 2; ++degree) {
            Series series(folder.path("a.pvd"), mesh);
            for (const double time : {0.0, 0.1, 2.5})
                series.add(time, {{"u", moving(mesh, side, degree, time)},
                                  {"v", moving(mesh, side, degree, -time)}});
            series.close();
            const auto found = read_series(folder.path("a.pvd"));
            ASSERT_EQ(found.steps.size(), 3U);
            EXPECT_EQ(found.steps[1].time, "0.1");
            const auto& last = found.steps[2];
            const bool on_vertices = degree == (side == Side::primal ? 0 : 2);
            const auto& arrays = on_vertices ? last.point_data : last.cell_data;
            EXPECT_EQ(last.point_data.size(), on_vertices || degree == 1 ? 2U : 0U);
            ASSERT_EQ(arrays.size(), 2U);
            const Vector wanted = moving(mesh, side, degree, 2.5).values;
            const auto& values = std::get<std::vector<double>>(arrays[0].values);
            ASSERT_EQ(values.size(), static_cast<std::size_t>(wanted.size()));
            for (Index i = 0; i < wanted.size(); ++i)
                EXPECT_EQ(values[static_cast<std::size_t>(i)], wanted[i]);
            EXPECT_NE(arrays[0].values, arrays[1].values);
        }
}

TEST(Series, CanBeReadWhileItIsWritten) {
    const auto mesh = square();
    const TemporaryFolder folder;
    Series list(folder.path("a.pvd"), mesh), page(folder.path("a.html"), mesh);
    for (std::size_t n = 1; n <= 100; ++n) {
        const double time = static_cast<double>(n);
        list.add(time, {{"u", moving(mesh, Side::primal, 0, time)}});
        page.add(time, {{"u", moving(mesh, Side::primal, 0, time)}});
        EXPECT_GE(32 * read_series(folder.path("a.pvd")).steps.size(), 31 * n) << n;
    }
    list.close();
    page.close();
    EXPECT_EQ(read_series(folder.path("a.pvd")).steps.size(), 100U);
    EXPECT_EQ(steps_in(folder.path("a.html")), 100U);
    EXPECT_REFUSED(list.add(1000, {}), "series", "closed", "step");
}

TEST(Series, LeavesAnOldPageUntilTheNewOneIsWhole) {
    const auto mesh = square();
    const TemporaryFolder folder;
    folder.write("a.html", "old");
    const auto show = [&](bool fails) {
        Series page(folder.path("a.html"), mesh);
        page.add(0, {{"u", moving(mesh, Side::primal, 0, 0)}});
        EXPECT_EQ(read_text(folder.path("a.html")), "old");
        if (fails)
            throw InvalidInput("in the middle");
    };
    EXPECT_THROW(show(true), InvalidInput);
    EXPECT_EQ(read_text(folder.path("a.html")), "old");
    show(false);
    EXPECT_EQ(steps_in(folder.path("a.html")), 1U);
}

TEST(Series, GoesOnWithItsOwnRunAlone) {
    const auto mesh = square();
    const TemporaryFolder folder;
    const auto path = folder.path("a.pvd");
    const auto add = [&](const std::vector<double>& times, std::uint64_t run) {
        Series series(path, mesh, PageText(), times, run);
        series.add(static_cast<double>(times.size()), {{"u", moving(mesh, Side::dual, 0, 1)}});
        series.close();
    };
    add({}, 7);
    add({0}, 7);
    EXPECT_EQ(read_series(path).steps.size(), 2U);
    EXPECT_REFUSED(add({0, 1}, 8), "a.pvd", "another run");
    std::filesystem::remove(path);
    EXPECT_REFUSED(add({0, 1}, 7), "a.pvd", "not there");
}

TEST(Series, OfAKilledProgramCanBeRead) {
    const auto mesh = square();
    const TemporaryFolder folder;
    for (int run = 0; run < 20; ++run) {
        const auto path = folder.path(fmt::format("{}.pvd", run % 5)); // some are there already
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            alarm(20); // whatever becomes of the parent
            Series series(path, mesh);
            for (int step = 0; step < 1000; ++step)
                series.add(step, {{"u", moving(mesh, Side::dual, 0, step)}});
            pause();
        }
        usleep(static_cast<unsigned>(1000 + 2000 * run));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        if (!std::filesystem::exists(path))
            continue;
        const auto found = read_series(path);
        for (std::size_t step = 0; step < found.steps.size(); ++step)
            EXPECT_EQ(std::get<std::vector<double>>(found.steps[step].cell_data[0].values)[1],
                      std::sin(2 * static_cast<double>(step)));
    }
}

TEST(Series, RemovesStepsOfAnEarlierOneAndNothingElse) {
    const auto mesh = square();
    const TemporaryFolder folder;
    Series(folder.path("a.pvd"), mesh).add(0, {{"u", moving(mesh, Side::dual, 0, 1)}});
    for (const char* name : {"a_0007.vtu", "a_7.vtu", "a_x.vtu", "b_0001.vtu", "notes.txt"})
        folder.write(std::string("a/") + name, "text");
    Series(folder.path("a.pvd"), mesh).close();
    EXPECT_FALSE(std::filesystem::exists(folder.path("a/a_0000.vtu")));
    EXPECT_FALSE(std::filesystem::exists(folder.path("a/a_0007.vtu")));
    for (const char* name : {"a_7.vtu", "a_x.vtu", "b_0001.vtu", "notes.txt"})
        EXPECT_TRUE(std::filesystem::exists(folder.path("a") / name)) << name;
    std::filesystem::create_directory(folder.path("b"));
    folder.write("b/b_0007.vtu", "text");
    Series(folder.path("b.pvd"), mesh).close();
    EXPECT_TRUE(std::filesystem::exists(folder.path("b/b_0007.vtu")));
}

TEST(Series, GoesOnAsIfItHadNotEnded) {
    const auto mesh = square();
    const TemporaryFolder folder;
    const auto add = [&](Series& series, int from, int to) {
        for (int step = from; step < to; ++step)
            series.add(0.1 * step, {{"u", moving(mesh, Side::dual, 0, step)}});
    };
    Series whole(folder.path("whole.pvd"), mesh);
    add(whole, 0, 50);
    whole.close();
    for (const std::size_t kept : {0, 1, 30, 39}) {
        {
            Series early(folder.path("part.pvd"), mesh);
            add(early, 0, 40); // of which the last may be beyond the last checkpoint
        }
        std::vector<double> times;
        for (std::size_t step = 0; step < kept; ++step)
            times.push_back(0.1 * static_cast<double>(step));
        Series late(folder.path("part.pvd"), mesh, PageText{}, times);
        EXPECT_EQ(late.size(), kept);
        EXPECT_EQ(std::filesystem::exists(folder.path("part/part_0039.vtu")), kept > 39);
        add(late, static_cast<int>(kept), 50);
        late.close();
        const auto found = read_series(folder.path("part.pvd"));
        const auto wanted = read_series(folder.path("whole.pvd"));
        ASSERT_EQ(found.steps.size(), 50U);
        for (std::size_t step = 0; step < 50; ++step) {
            EXPECT_EQ(found.steps[step].time, wanted.steps[step].time);
            EXPECT_EQ(found.steps[step].cell_data[0].values,
                      wanted.steps[step].cell_data[0].values);
        }
    }
    EXPECT_REFUSED(Series(folder.path("part.pvd"), mesh, PageText{}, {1, 0}), "step 1", "series",
                   "time 0");
    EXPECT_REFUSED(Series(folder.path("none.pvd"), mesh, PageText{}, {0}),
                   folder.path("none/none_0000.vtu").string(), "series");
    EXPECT_REFUSED(Series("a.html", mesh, PageText{}, {0}), "a.html", "page", ".pvd");
}

TEST(Series, IsAPictureOfOneStepByItsExtension) {
    const auto mesh = square();
    const TemporaryFolder folder;
    for (const auto& [name, begin] : {std::pair("a.png", "\x89PNG"), std::pair("a.svg", "<svg")}) {
        Series series(folder.path(name), mesh);
        for (const int time : {0, 1})
            series.add(time, {NamedForm("u", moving(mesh, Side::primal, 0, time))});
        series.close();
        EXPECT_EQ(read_text(folder.path(name)).substr(0, 4), begin);
    }
}

TEST(Series, RefusesWhatDoesNotFit) {
    const auto mesh = square();
    const TemporaryFolder folder;
    const NamedForm u("u", moving(mesh, Side::primal, 0, 1));
    EXPECT_REFUSED(Series("a.vtu", mesh), "a.vtu", "series", ".pvd", ".html");
    for (const auto& each : {std::pair("\x01", "\\x01"), {"\xFF", "\\xff"}, {"\n", "\\n"}})
        EXPECT_REFUSED(Series(folder.path(std::string(each.first) + ".pvd"), mesh), each.second,
                       "name", "characters");
    EXPECT_NO_THROW(Series(folder.path("größe 網格.pvd"), mesh));
    for (const char* name : {"a.pvd", "a.html"}) {
        Series series(folder.path(name), mesh);
        const auto adding = [&](double time, std::vector<NamedForm> forms) {
            return refusal([&] { series.add(time, forms); });
        };
        EXPECT_NE(adding(0, {}), "accepted");
        EXPECT_EQ(adding(1, {u}), "accepted");
        for (const double time : {1.0, 0.5, std::numeric_limits<double>::quiet_NaN()})
            EXPECT_SAYS(adding(time, {u}), "step 1", "series", "time", fmt::format("{}", time));
        const Words other{"step 1", "series", "arrays"};
        EXPECT_TRUE(says(adding(2, {NamedForm("v", u.form)}), other));
        EXPECT_TRUE(says(adding(2, {u, u}), other));
        EXPECT_TRUE(says(adding(2, {NamedForm("u", moving(mesh, Side::dual, 0, 1))}), other));
        Cochain broken = u.form;
        broken.values[2] = std::numeric_limits<double>::infinity();
        EXPECT_NE(adding(2, {NamedForm("u", broken)}), "accepted");
        EXPECT_EQ(series.size(), 1U);
        EXPECT_EQ(adding(2, {u}), "accepted");
        EXPECT_EQ(series.size(), 2U);
    }
}

} // namespace polydec::test::in_series
