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

std::vector<Door> doors_of_complexes(const Sample& s) {
    const int n = s.n();
    const auto relative =
        std::make_shared<RelativeComplex>(relative_complex(s.P(), no_marks(s.P())));
    return {
        {"coboundary", -1, n, [&](int k) { s.P().coboundary(k); }},
        {"CellComplex::boundary", 0, n + 1, [&](int k) { s.P().boundary(k); }},
        {"canceled", 0, n - 1, [&](int k) { s.P().canceled(k); }},
        {"coface_counts", 0, n, [&](int k) { s.P().coface_counts(k); }},
        {"simplices", 0, n, [&](int k) { s.K().simplices(k); }},
        {"face", 1, n, [&](int k) { s.K().face(k, 0, 0); }},
        {"carriers", 0, n, [&](int k) { s.mesh.merging().carriers(k); }},
        {"diamond", 0, n, [&](int k) { s.mesh.merging().diamond(k); }},
        {"Merging::vertices", 0, n, [&](int k) { s.mesh.merging().vertices(k, 0); }},
        {"cell_vertices", 0, n, [&](int k) { cell_vertices(s.mesh, k, 0); }},
        {"homology_generators", 0, n, [&](int k) { homology_generators(s.P(), k); }},
        {"regular_minor", 0, n, [&](int k) { regular_minor(s.P(), k); }},
        {"restrict", 0, n,
         [&, relative](int k) { relative->restrict(k, Vector::Zero(s.P().size(k))); }},
        {"extend", 0, n,
         [&, relative](int k) { relative->extend(k, Vector::Zero(s.P().size(k))); }},
    };
}

std::vector<Door> doors_of_operators(const Sample& s) {
    const int n = s.n();
    return {
        {"derivative", -1, n, [=, &s](int k) { derivative(s.P(), k); }},
        {"dual_derivative", -1, n, [=, &s](int j) { dual_derivative(s.P(), j); }},
        {"star", 0, n, [=, &s](int k) { star(s.V(), k); }},
        {"HodgeStars", 0, n, [=, &s](int k) { s.mesh.stars()[k]; }},
        {"codifferential", 0, n, [=, &s](int k) { codifferential(s.cells(), k); }},
        {"dual_codifferential", 0, n, [=, &s](int j) { dual_codifferential(s.cells(), j); }},
        {"laplacian", 0, n, [=, &s](int k) { laplacian(s.cells(), k); }},
        {"dual_laplacian", 0, n, [=, &s](int j) { dual_laplacian(s.cells(), j); }},
        {"symmetric_laplacian", 0, n, [=, &s](int k) { symmetric_laplacian(s.cells(), k); }},
        {"Operator::derivative", -1, n, [=, &s](int k) { Operator::derivative(s.P(), k); }},
        {"dual_boundary_derivative", 0, n, [=, &s](int j) { dual_boundary_derivative(s.P(), j); }},
        {"primal_to_merged", 0, n, [=, &s](int k) { primal_to_merged(s.mesh.merging(), k); }},
        {"primal_to_input", 0, n, [=, &s](int k) { primal_to_input(s.mesh.merging(), s.W(), k); }},
        {"dual_to_merged", 0, n, [=, &s](int j) { dual_to_merged(s.mesh.merging(), s.W(), j); }},
        {"dual_to_input", 0, n, [=, &s](int j) { dual_to_input(s.mesh.merging(), j); }},
    };
}

std::vector<Door> doors_of_the_metric(const Sample& s) {
    const int n = s.n();
    const auto& mesh = s.mesh;
    const Points field = Points::Ones(mesh.points().rows(), mesh.points().cols());
    const auto constant = [](int degree, Index coordinates) -> SmoothForm {
        Index count = 1;
        for (int i = 0; i < degree && count != 0; ++i)
            count = count * (coordinates - i) / (i + 1);
        return [count](const Vector&) { return Vector(Vector::Ones(count)); };
    };
    const auto N = static_cast<Index>(mesh.points().cols());
    return {
        {"circumradii", 0, n,
         [=, &s, &mesh](int k) { circumradii(s.K(), mesh.geometry().metric(), k); }},
        {"cell_centers", 0, n, [&mesh](int k) { cell_centers(mesh, k); }},
        {"cell_centroids", 0, n, [&mesh](int k) { cell_centroids(mesh, k); }},
        {"cell_centers after flips", 0, 2, [](int k) { cell_centers(sample("flipped").mesh, k); }},
        {"cell_vertices after flips", 0, 2,
         [](int k) { cell_vertices(sample("flipped").mesh, k, 0); }},
        {"de_rham", 0, n, [=, &mesh](int k) { de_rham(mesh, k, constant(k, N)); }},
        {"dual_de_rham", 0, n, [=, &mesh](int j) { dual_de_rham(mesh, j, constant(j, N)); }},
        {"interior_product", 0, n + 1,
         [=, &s](int k) { interior_product(s.mesh, field, k, Sampling::centered); }},
        {"lie_derivative", 0, n,
         [=, &s](int k) {
             const bool has_added = s.mesh.pieces().size(0) > s.mesh.input().size(0);
             lie_derivative(s.mesh, field, k, has_added ? Sampling::centered : Sampling::upwind);
         }},
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
        expect_doors_to_hold(doors_of_complexes(sample), sample.name);
        expect_doors_to_hold(doors_of_operators(sample), sample.name);
        expect_doors_to_hold(doors_of_the_metric(sample), sample.name);
        expect_doors_to_hold(doors_of_forms(sample), sample.name);
    }
    expect_doors_to_hold(doors_of_flips(), "a flipped square");
}

TEST(doors, degrees_that_there_are_are_taken_where_stars_are_positive) {
    const Sample& sphere = sample("a sphere");
    for (const auto& doors :
         {doors_of_complexes(sphere), doors_of_operators(sphere), doors_of_the_metric(sphere),
          doors_of_forms(sphere), doors_of_flips()})
        for (const Door& door : doors)
            for (int k = door.least; k <= door.most; ++k)
                EXPECT_EQ(outcome([&] { door.open(k); }), "accepted")
                    << door.name << '(' << k << ')';
}

} // namespace polydec::test::in_doors
