// SPDX-License-Identifier: MIT
//
// Every public function that takes a degree gets wrong ones. Each must refuse with InvalidInput:
// not answer, not throw something else.
#include "tests/io/doors.h"

namespace polydec::test::in_doors {

/// A function of a degree, and the degrees that there are.
struct Door {
    std::string name;
    int least, most;
    std::function<void(int)> open;
};

/// Those that are asked nowhere else: see Inputs::degree.
std::vector<Door> doors_of_cells(const Sample& s) {
    const int n = s.n();
    return {
        {"canceled", 0, n - 1, [&](int k) { s.P().canceled(k); }},
        {"coface_counts", 0, n, [&](int k) { s.P().coface_counts(k); }},
        {"simplices", 0, n, [&](int k) { s.K().simplices(k); }},
        {"face", 1, n, [&](int k) { s.K().face(k, 0, 0); }},
        {"carriers", 0, n, [&](int k) { s.mesh.merging().carriers(k); }},
        {"cell_vertices", 0, n, [&](int k) { cell_vertices(s.mesh, k, 0); }},
        {"HodgeStars", 0, n, [&](int k) { s.mesh.stars()[k]; }},
    };
}

std::vector<Door> doors_of_forms(const Sample& s) {
    const int n = s.n();
    std::vector<Door> doors;
    for (const Side side : {Side::primal, Side::dual}) {
        const auto add = [&](const char* what, std::function<void(const Cochain&)> take) {
            doors.push_back({std::string(what) + " of " + name(side) + " forms", 0, n,
                             [&s, side, take](int k) { take(form(s, side, k)); }});
        };
        add("check", [&](const Cochain& w) { check(s.P(), w); });
        add("d", [&](const Cochain& w) { d(s.P(), w); });
        add("star", [&](const Cochain& w) { star(s.cells(), w); });
        add("codifferential", [&](const Cochain& w) { codifferential(s.cells(), w); });
        add("laplacian", [&](const Cochain& w) { laplacian(s.cells(), w); });
        add("inner_product", [&](const Cochain& w) { inner_product(s.cells(), w, w); });
        add("boundary", [&](const Cochain& w) { boundary(s.P(), {w.side, w.degree, w.values}); });
        add("to_input", [&](const Cochain& w) { to_input(s.mesh, w); });
        add("hodge_decomposition", [&](const Cochain& w) {
            hodge_decomposition({s.cells(), w.side, w.degree}, w, "eigen.ldlt");
        });
        add("cell_degree", [&](const Cochain& w) { cell_degree(s.P(), w.side, w.degree); });
        add("Evolution", [&](const Cochain& w) {
            Evolution({{{s.cells(), w.side, w.degree}, w.values, 1}});
        });
        add("spectrum", [&](const Cochain& w) {
            spectrum({s.cells(), w.side, w.degree}, {.count = 1});
        });
        add("harmonic_forms", [&](const Cochain& w) {
            harmonic_forms({s.cells(), w.side, w.degree}, "eigen.ldlt");
        });
    }
    doors.push_back({"stable_step", 0, n - 1, [&](int k) {
                         stable_step({s.cells(), Side::primal, k});
                     }});
    doors.push_back(
        {"Waves", 0, n - 1, [&](int k) {
             Waves({s.cells(), Side::primal, k}, Vector::Zero(s.size(k)), {.time_step = 1e-3});
         }});
    if (n <= 3) {
        doors.push_back({"draw_cells", 0, n, [&](int k) { draw_cells(s.mesh, k); }});
        doors.push_back({"add_cochain", 0, n, [&](int k) {
                             VtuGrid grid = draw_cells(s.mesh, 0);
                             add_cochain(grid, s.mesh.complex(), k, "a",
                                         Vector(Vector::Ones(s.P().size(k))));
                         }});
    }
    return doors;
}

std::vector<Door> doors_of_flips() {
    const auto& passage = sample("flipped").mesh.passage();
    const auto& history = passage.flips().history;
    const auto size = [&](int k) { return passage.pieces().size(k); };
    return {
        {"FlipHistory::carry", 0, 2, [&, size](int k) { history.carry(k, Vector::Ones(size(k))); }},
        {"FlipHistory::carry_back", 0, 2,
         [&, size](int k) { history.carry_back(k, Vector::Ones(size(k))); }},
        {"FlipHistory::matrix", 0, 2, [&](int k) { history.matrix(k); }},
        {"FlipHistory::matrix_back", 0, 2, [&](int k) { history.matrix_back(k); }},
        {"Passage::forth", 0, 2, [&, size](int k) { passage.forth(k, Vector::Ones(size(k))); }},
        {"Passage::back", 0, 2, [&, size](int k) { passage.back(k, Vector::Ones(size(k))); }},
        {"Passage::matrix", 0, 2, [&](int k) { passage.matrix(k); }},
        {"Passage::matrix_back", 0, 2, [&](int k) { passage.matrix_back(k); }},
    };
}

void expect_doors_to_hold(const std::vector<Door>& doors, const std::string& where) {
    for (const Door& door : doors) {
        for (const int k :
             {door.least - 1, door.least - 2, door.most + 1, door.most + 2, -1000, 1000,
              std::numeric_limits<int>::max() / 2, std::numeric_limits<int>::min() / 2})
            EXPECT_EQ(outcome([&] { door.open(k); }), "refused")
                << door.name << '(' << k << ") on " << where;
        for (int k = door.least; k <= door.most; ++k)
            EXPECT_NE(outcome([&] { door.open(k); }).substr(0, 9), "a foreign")
                << door.name << '(' << k << ") on " << where;
    }
}

TEST(doors, a_degree_that_there_is_not_is_refused_by_every_function) {
    for (const Sample& sample : samples()) {
        expect_doors_to_hold(doors_of_cells(sample), sample.name);
        expect_doors_to_hold(doors_of_forms(sample), sample.name);
    }
    expect_doors_to_hold(doors_of_flips(), "a flipped square");
}

TEST(doors, degrees_that_there_are_are_taken_where_stars_are_positive) {
    const Sample& sphere = sample("a sphere");
    for (const auto& doors : {doors_of_cells(sphere), doors_of_forms(sphere), doors_of_flips()})
        for (const Door& door : doors)
            for (int k = door.least; k <= door.most; ++k)
                EXPECT_EQ(outcome([&] { door.open(k); }), "accepted")
                    << door.name << '(' << k << ')';
}

} // namespace polydec::test::in_doors
