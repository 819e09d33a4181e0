// SPDX-License-Identifier: MIT
//
// What the text of an error names, its members have.

// g++ 12 takes the states of std::regex for uninitialized where sanitizers look on
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "dec/discretization/positive_mass.h"
#include "tests/support/test.h"
#include "tools/messages.h"

#include <regex>
#include <unistd.h>

namespace polydec::test::in_places {

using Place = Error::Place;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The numbers in the first parts of the text that match, behind each other.
std::vector<Index> numbers(const std::string& text, const char* pattern) {
    std::vector<Index> found;
    const std::regex expression(pattern), number("[0-9]+");
    for (std::sregex_iterator part(text.begin(), text.end(), expression), end; part != end;
         ++part) {
        const auto list = part->str(1);
        for (std::sregex_iterator i(list.begin(), list.end(), number); i != end; ++i)
            found.push_back(std::stoi(i->str()));
    }
    return found;
}

bool holds(const std::vector<Index>& all, const std::vector<Index>& some) {
    return std::all_of(some.begin(), some.end(),
                       [&](Index i) { return std::find(all.begin(), all.end(), i) != all.end(); });
}

/// What the text names and the place lacks; empty if it lacks nothing. A line says where what it
/// tells of is.
std::string lacking(const std::string& text, const Place& place) {
    const std::regex line("^(?:cannot (?:read|write) )?(/[^: ]*):(?:([0-9]+):)?");
    if (std::smatch found; std::regex_search(text, found, line)) {
        if (place.path != found.str(1))
            return "path";
        if (found[2].matched)
            return place.line == std::stoi(found.str(2)) ? "" : "line";
    }
    const auto degrees = numbers(text, "([0-9]+)-(?:cell|simplex)");
    if (!degrees.empty() && place.degree != degrees.front())
        return "degree";
    constexpr const char* list = "((?:[0-9]+(?:, | and )?)+)(?! ?[0-9])";
    for (const char* cell : {"cells?", "simplex", "triangles?", "edges?", "facet", "polygon"})
        if (!holds(place.cells, numbers(text, (std::string("\\b") + cell + " " + list).c_str())))
            return "cells";
    for (const char* vertex : {"vertex", "vertices", "its vertices are", "to"})
        if (vertex != std::string("to") || text.find("from vertex") != std::string::npos)
            if (!holds(place.vertices, numbers(text, (std::string(vertex) + " " + list).c_str())))
                return "vertices";
    return "";
}

struct Refusal {
    const char* name;
    std::function<void()> call;
};

std::filesystem::path temporary(const char* name) {
    return std::filesystem::temp_directory_path() /
           ("polydec_places_" + std::to_string(::getpid()) + name);
}

void read(const char* name, const std::string& text) {
    const auto path = temporary(name);
    std::ofstream(path) << text;
    const auto end = [&] { std::filesystem::remove(path); };
    try {
        path.extension() == ".nsl" ? (void)read_lengths(path) : (void)read_mesh(path);
    } catch (...) {
        end();
        throw;
    }
    end();
}

Mesh two_triangles() {
    return made_of({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 1, 2}, {2, 1, 3}});
}

SimplicialComplex complex_of(std::vector<std::vector<Index>> triangles) {
    return SimplicialComplex(made_of({{}}, std::move(triangles)).simplices);
}

Discretization unmerged_grid() {
    return circumcentric(grid(2, 2), {.criterion = MergeCriterion::none});
}

std::vector<Refusal> refusals() {
    std::vector<Refusal> list;
    const auto add = [&](const char* name, std::function<void()> call) {
        list.push_back({name, std::move(call)});
    };
    add("bad line", [] { read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"); });
    add("bad tag", [] { read("a.vtu", "<VTKFile>\n<oops\n"); });
    add("no cells", [] { read("b.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"); });
    add("no length", [] { read("a.nsl", "2 3 1 2\n0 1 2\n0 1 1\n1 2 1\n"); });
    add("no file", [] { read_mesh("/no/such/file.off"); });
    add("no format", [] { read_mesh("/no/such/file.what"); });
    add("no folder", [] { write_mesh("/no/such/folder/a.off", two_triangles()); });
    add("to be written", [] {
        auto mesh = two_triangles();
        mesh.points(3, 0) = nan;
        write_mesh(temporary("c.off"), mesh);
    });
    add("not finite", [] {
        auto mesh = two_triangles();
        mesh.points(1, 0) = nan;
        circumcentric(mesh);
    });
    add("no such vertex", [] {
        auto mesh = two_triangles();
        mesh.simplices(1, 2) = 9;
        circumcentric(mesh);
    });
    add("no area", [] {
        tidy(made_of({{0, 0}, {1, 0}, {2, 0}, {1, 1}, {1, -1}},
                     {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 4, 2}}));
    });
    add("twice the same", [] { complex_of({{0, 1, 2}, {2, 1, 0}}); });
    add("repeated corner", [] { complex_of({{4, 1, 4}}); });
    add("flat", [] {
        const auto mesh = made_of({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}});
        circumcentric_volumes(SimplicialComplex(mesh.simplices), mesh.points);
    });
    add("no radius", [] {
        const auto mesh = made_of({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}});
        circumradii(SimplicialComplex(mesh.simplices), mesh.points, 2);
    });
    add("no triangle", [] {
        const SimplicialComplex complex(two_triangles().simplices);
        const Vector lengths{{1, 1, 1, 5, 1}};
        circumcentric_volumes(complex, SimplexMetric(complex, lengths));
    });
    add("no volume", [] {
        CellVolumes({Vector{{1, 1}}, Vector{{0}}}, {Vector{{1, 1}}, Vector{{1}}});
    });
    add("no length", [] {
        const SimplicialComplex complex(two_triangles().simplices);
        const Vector lengths{{1, 1, -1, 1, 1}};
        SimplexMetric(complex, lengths);
    });
    add("inverse star", [] { star(unmerged_grid().volumes(), 1).inverse(); });
    add("mass", [] { check_positive_mass(unmerged_grid().stars()[1], Side::primal, 1); });
    add("waves", [] {
        const auto mesh =
            circumcentric(made_of({{0, 0}, {4, 0}, {2, 1.6}, {2, -1.6}}, {{0, 1, 2}, {0, 3, 1}}));
        stable_step({{mesh.complex(), mesh.volumes()}, Side::primal, 0});
    });
    add("flux", [] { PoissonSolver({unmerged_grid(), Side::dual, 0, {}}); });
    add("conductivity", [] {
        const auto mesh = circumcentric(grid(2, 2));
        with_conductivity(mesh, Side::primal, CellData::on_cells(Vector{{1, 2, -3, 4}}));
    });
    add("three triangles", [] { GluedSurface(complex_of({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})); });
    add("centers", [] { Centers({Points::Ones(4, 1), Points::Ones(5, 2)}); });
    add("no source", [] {
        const auto mesh = circumcentric(two_components());
        const std::vector<Index> sources{0};
        GeodesicDistance(mesh).to(sources);
    });
    return list;
}

struct Told {
    std::string text;
    Place place;
};

/// What the error of a call tells.
Told told(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return {error.what(), error.place()};
    }
    ADD_FAILURE() << "accepted";
    return {};
}

TEST(Places, have_what_the_text_names) {
    for (const auto& [name, call] : refusals()) {
        const auto [text, place] = told(call);
        EXPECT_EQ(lacking(text, place), "") << name << ": " << text;
    }
}

TEST(Places, are_missed_where_they_are_left_out_or_wrong) {
    for (const auto& [name, call] : refusals()) {
        auto [text, wrong] = told(call);
        EXPECT_NE(lacking(text, {}), "") << name << ": " << text;
        for (auto* list : {&wrong.cells, &wrong.vertices})
            for (Index& number : *list)
                number += 1000;
        wrong.line += 1;
        wrong.path += "x";
        EXPECT_NE(lacking(text, wrong), "") << name << ": " << text;
    }
}

TEST(Places, stay_when_errors_are_told_in_other_words) {
    const auto words = [](const char*) { return std::string("in other words"); };
    for (const auto& [name, call] : refusals()) {
        const Place before = told(call).place;
        const Place place =
            told([&call = call, &words] { tools::reworded(words, call, "mesh.off"); }).place;
        EXPECT_EQ(place.degree, before.degree) << name;
        EXPECT_EQ(place.cells, before.cells) << name;
        EXPECT_EQ(place.vertices, before.vertices) << name;
        EXPECT_EQ(place.line, before.line) << name;
        EXPECT_EQ(place.path, before.path.empty() ? "mesh.off" : before.path) << name;
    }
}

TEST(Reports, of_failures_have_what_the_text_names) {
    SparseMatrix A(9, 9);
    for (Index i = 0; i < 9; ++i) {
        A.insert(i, i) = 2;
        if (i > 0)
            A.insert(i, i - 1) = A.insert(i - 1, i) = -1;
    }
    auto solver = make_linear_solver("eigen.cg", {.tolerance = 1e-12, .max_iterations = 1});
    solver->factorize(A, {.symmetry = Symmetry::symmetric, .definiteness = Definiteness::positive});
    try {
        solver->solve(Vector(Vector::LinSpaced(9, 1, 2)));
        FAIL() << "one step cannot do";
    } catch (const SolverFailure& failure) {
        const std::string text = failure.what();
        EXPECT_EQ(failure.report().engine, "eigen.cg");
        EXPECT_EQ(text.find(failure.report().engine), 0U);
        EXPECT_EQ(failure.report().iterations, numbers(text, "after ([0-9]+) iterations").at(0));
        EXPECT_GT(failure.report().residual, 0);
        EXPECT_TRUE(std::isnan(failure.report().backward_error)) << "it was not measured";
    }
    EXPECT_TRUE(std::isnan(SolverFailure("why").report().residual));
}

static_assert(std::is_nothrow_copy_constructible_v<InvalidInput>);
static_assert(std::is_nothrow_copy_constructible_v<SolverFailure>);

} // namespace polydec::test::in_places
