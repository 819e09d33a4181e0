// SPDX-License-Identifier: MIT
//
// Every function of complexes and forms, asked of every kind of sample with right inputs and with
// flawed ones: see expect_answers.
#include "complex/blocks.h"
#include "dec/merging/merged_tags.h"
#include "tests/io/doors.h"

#include <gtest/gtest.h>

namespace polydec::test {
namespace {

using Questions = std::vector<Question>;

Questions of_complexes(const Sample& s, int k) {
    const int n = s.n();
    return {
        {"coboundary",
         [&s, k](Inputs& in) {
             return fit(SparseMatrix(s.P().coboundary(in.degree(k)).cast<double>()), s.size(k + 1),
                        s.size(k));
         }},
        {"boundary",
         [&s, k](Inputs& in) {
             return fit(SparseMatrix(s.P().boundary(in.degree(k)).cast<double>()), s.size(k - 1),
                        s.size(k));
         }},
        {"homology_generators",
         [&s, k](Inputs& in) {
             return fit(homology_generators(s.P(), in.degree(k)), s.size(k),
                        betti_numbers(s.P())[k]);
         }},
        {"regular_minor",
         [&s, k](Inputs& in) {
             const auto minor = regular_minor(s.P(), in.degree(k));
             return fit(minor.columns.size() == minor.rows.size());
         }},
        {"euler_characteristic",
         [&s](Inputs&) {
             Index sum = 0;
             for (int i = 0; const Index betti : betti_numbers(s.P()))
                 sum += i++ % 2 == 0 ? betti : -betti;
             return fit(sum == euler_characteristic(s.P()));
         }},
        {"components",
         [&s](Inputs&) {
             return fit(components(s.P()).count == betti_numbers(s.P())[0] &&
                        boundary_components(s.P()).count >= 0);
         }},
        {"boundary_cells and relative_complex",
         [&s, k](Inputs& in) {
             auto marks = boundary_cells(s.P());
             marks[k] = in.list(s.size(k), false);
             for (int lower = 0; lower < k; ++lower)
                 marks[lower].assign(marks[lower].size(), false);
             for (int upper = k + 1; upper <= s.n(); ++upper)
                 marks[upper].assign(marks[upper].size(), false);
             mark_faces(s.P(), marks);
             return fit(relative_complex(s.P(), marks).complex.size(k) == s.size(k));
         }},
        {"relative_to_boundary",
         [&s, k](Inputs& in) {
             const auto relative = relative_to_boundary(s.P());
             const Vector kept = relative.restrict(in.degree(k), in.vector(s.size(k)));
             return fit(relative.extend(k, kept), s.size(k));
         }},
        {"RelativeComplex::extend",
         [&s, k](Inputs& in) {
             const auto relative = relative_to_boundary(s.P());
             return fit(relative.extend(in.degree(k), in.vector(relative.complex.size(k))),
                        s.size(k));
         }},
        {"merging",
         [&s, k](Inputs& in) {
             const auto& merging = s.mesh.merging();
             return fit(SparseMatrix(merging.diamond(in.degree(k)).cast<double>()), s.size(k),
                        s.pieces().size(k));
         }},
        {"vertices of merged cells",
         [&s, k](Inputs& in) {
             return fit(!s.mesh.merging().vertices(in.degree(k), 0).empty() &&
                        !cell_vertices(s.mesh, in.degree(k), 0).empty());
         }},
        {"unmerged",
         [&s, k](Inputs&) {
             return fit(unmerged(s.pieces()).merged().size(k) == s.pieces().size(k));
         }},
        {"join_blocks",
         [&s, n](Inputs& in) {
             const auto facets = in.list<bool>(s.pieces().size(n - 1), true);
             const auto blocks =
                 join_blocks(s.pieces(), facets, [](int, Index, Index, Index) { return false; });
             inadmissible_blocks(s.pieces(), blocks);
             return fit(Index(blocks.carriers.size()) == n + 1);
         }},
        {"merged_tags",
         [&s, k](Inputs& in) {
             std::vector<std::string> warnings;
             const auto tags = merged_tags(s.mesh.merging(), in.degree(k),
                                           in.list<Index>(s.pieces().size(k), 3), warnings);
             return fit(Index(tags.size()) == s.size(k));
         }},
        {"volumes",
         [&s, k](Inputs& in) {
             const int degree = in.degree(k);
             return fit(s.V().primal(degree), s.size(k)) + fit(s.V().dual(degree), s.size(k)) +
                    fit(s.V().terms(degree).vector(), s.size(k)) +
                    fit(s.V().rounding(degree).vector(), s.size(k));
         }},
        {"with_dual",
         [&s, k](Inputs& in) {
             const auto other = s.V().with_dual(in.degree(k), in.vector(s.size(k)));
             return fit(s.mesh.with_volumes(other).volumes().dual(k), s.size(k));
         }},
        {"merged_volumes",
         [&s, k](Inputs&) {
             return fit(merged_volumes(s.mesh.merging(), s.geometry().volumes()).primal(k),
                        s.size(k));
         }},
        {"corners", [&s](Inputs&) { return fit(corners(s.mesh.merging(), 0).size() >= 3); }},
    };
}

Questions of_operators(const Sample& s, int k) {
    const int n = s.n();
    const auto square = [&s, k](const char* what, auto made) {
        return Question{what, [&s, k, made](Inputs& in) {
                            return fit(made(in.degree(k)), s.size(k), s.size(k));
                        }};
    };
    const auto values = [&s, k](const char* what, int to, auto made) {
        return Question{what, [&s, k, to, made](Inputs& in) {
                            const int degree = in.degree(k);
                            return fit(made(degree, in.vector(s.size(k))), s.size(to));
                        }};
    };
    return {
        {"derivative",
         [&s, k](Inputs& in) {
             return fit(derivative(s.mesh.complex(), in.degree(k)), s.size(k + 1), s.size(k));
         }},
        {"dual_derivative",
         [&s, k, n](Inputs& in) {
             return fit(dual_derivative(s.mesh.complex(), in.degree(n - k)), s.size(k - 1),
                        s.size(k));
         }},
        {"star",
         [&s, k](Inputs& in) { return fit(star(s.mesh, in.degree(k)).diagonal(), s.size(k)); }},
        {"inverse star",
         [&s, k](Inputs& in) { return fit(star(s.V(), in.degree(k)).inverse(), s.size(k)); }},
        {"star of values",
         [&s, k](Inputs& in) {
             return fit(star(s.V(), in.degree(k)) * in.vector(s.size(k)), s.size(k));
         }},
        {"inverse star of values",
         [&s, k](Inputs& in) {
             return fit(star(s.V(), in.degree(k)).solve(in.vector(s.size(k))), s.size(k));
         }},
        {"codifferential",
         [&s, k](Inputs& in) {
             return fit(codifferential(s.mesh, in.degree(k)), s.size(k - 1), s.size(k));
         }},
        {"dual_codifferential",
         [&s, k, n](Inputs& in) {
             return fit(dual_codifferential(s.mesh, in.degree(n - k)), s.size(k + 1), s.size(k));
         }},
        square("laplacian", [&s](int degree) { return laplacian(s.mesh, degree); }),
        square("symmetric_laplacian",
               [&s](int degree) { return symmetric_laplacian(s.mesh, degree); }),
        {"dual_laplacian",
         [&s, k, n](Inputs& in) {
             return fit(dual_laplacian(s.mesh, in.degree(n - k)), s.size(k), s.size(k));
         }},
        {"symmetric_laplacian_diagonal",
         [&s, k](Inputs& in) {
             return fit(symmetric_laplacian(s.mesh, in.degree(k)).diagonal(), s.size(k));
         }},
        {"dual_boundary_derivative",
         [&s, k, n](Inputs& in) {
             return fit(dual_boundary_derivative(s.P(), in.degree(n - k - 1)), s.size(k),
                        s.size(k));
         }},
        values(
            "apply_derivative", k + 1,
            [&s](int degree, const Vector& x) { return Operator::derivative(s.P(), degree) * x; }),
        values("apply_transposed_derivative", k - 1,
               [&s](int degree, const Vector& x) {
                   return Operator::derivative(s.P(), degree - 1).transposed() * x;
               }),
        values("apply_codifferential", k - 1,
               [&s](int degree, const Vector& x) { return codifferential(s.mesh, degree) * x; }),
        values("apply_dual_codifferential", k + 1,
               [&s, n](int degree, const Vector& x) {
                   return dual_codifferential(s.mesh, n - degree) * x;
               }),
        values("apply_laplacian", k,
               [&s](int degree, const Vector& x) { return laplacian(s.mesh, degree) * x; }),
        values(
            "apply_symmetric_laplacian", k,
            [&s](int degree, const Vector& x) { return symmetric_laplacian(s.mesh, degree) * x; }),
        values("apply_dual_laplacian", k,
               [&s, n](int degree, const Vector& x) {
                   return dual_laplacian(s.mesh, n - degree) * x;
               }),
        {"Operator::weights",
         [&s, k](Inputs& in) {
             const auto weights = Operator::weights(in.vector(s.size(k)));
             return fit(weights * in.vector(s.size(k)), s.size(k));
         }},
        {"products of operators",
         [&s, k](Inputs& in) {
             const auto d = Operator::derivative(s.P(), in.degree(k));
             const auto A = d.transposed() * Operator::weights(in.vector(s.size(k + 1))) * d;
             return fit(A, s.size(k), s.size(k)) + fit(A.diagonal(), s.size(k));
         }},
        {"sums of operators",
         [&s, k](Inputs& in) {
             const Index columns = Index(in.vector(s.size(k)).size());
             const auto A =
                 Operator::zero(s.size(k), columns) + Operator::weights(in.vector(s.size(k)));
             return fit(A, s.size(k), s.size(k)) + fit(A * in.vector(s.size(k)), s.size(k));
         }},
        {"negative and zero stars",
         [&s, k](Inputs& in) {
             const auto all = star(s.V(), in.degree(k));
             const auto cells = all.negatives();
             return fit(Index(all.zeros().size() + cells.size()) <= s.size(k) &&
                        all.numbers(cells).size() < 1000 && all.place(cells).cells == cells);
         }},
    };
}

/// j is the degree of the forms.
Questions of_forms(const Sample& s, Side side, int j) {
    const Side other = side == Side::primal ? Side::dual : Side::primal;
    const int n = s.n();
    const auto one = [&s, side, j](const char* what, Side to, int degree, auto made) {
        return Question{what, [&s, side, j, to, degree, made](Inputs& in) {
                            return fit(made(in.form(s, side, j)), s.P(), to, degree);
                        }};
    };
    const auto number = [&s, side, j](const char* what, auto made) {
        return Question{what, [&s, side, j, made](Inputs& in) {
                            const auto a = in.form(s, side, j), b = in.form(s, side, j);
                            return fit(double(made(a, b)));
                        }};
    };
    Questions all{
        one("multiple", side, j,
            [&s](const Cochain& a) {
                check(s.P(), a);
                return 2.0 * a;
            }),
        one("star", other, n - j, [&s](const Cochain& a) { return star(s.mesh, a); }),
        one("laplacian", side, j, [&s](const Cochain& a) { return laplacian(s.mesh, a); }),
        number("inner_product",
               [&s](const Cochain& a, const Cochain& b) { return inner_product(s.mesh, a, b); }),
        number("sum", [](const Cochain& a, const Cochain& b) { return (a + b).values.sum(); }),
        number("difference",
               [](const Cochain& a, const Cochain& b) { return (a - b).values.sum(); }),
        number("norm", [&s](const Cochain& a,
                            const Cochain& b) { return norm(s.mesh, a) + norm(s.mesh, b); }),
        {"pairing",
         [&s, side, j](Inputs& in) {
             const auto w = in.form(s, side, j);
             return fit(pairing(w, in.chain(s, side, j)));
         }},
        {"to_input",
         [&s, side, j](Inputs& in) {
             return fit(to_input(s.mesh, in.form(s, side, j)), s.K(), side, j);
         }},
        {"to_merged",
         [&s, side, j](Inputs& in) {
             return fit(to_merged(s.mesh, in.form_on(s.K(), side, j)), s.P(), side, j);
         }},
        {"on_pieces",
         [&s, side, j](Inputs& in) {
             return fit(on_pieces(s.mesh, in.form(s, side, j)), s.pieces(), side, j);
         }},
        {"on_cells",
         [&s, side, j](Inputs& in) {
             return fit(on_cells(s.mesh, in.form_on(s.pieces(), side, j)), s.P(), side, j);
         }},
        {"lifted",
         [&s, side, j](Inputs& in) {
             return fit(lifted(s.mesh, in.form(s, side, j)), s.K(), side, j);
         }},
        {"consistency",
         [&s, j](Inputs& in) {
             return fit(consistency(s.mesh, in.form_on(s.pieces(), Side::dual, j)).worst);
         }},
        {"on_input",
         [&s, side, j, n](Inputs& in) {
             const int k = side == Side::primal ? j : n - j;
             const auto O = in.operator_matrix(s.size(k), s.size(k));
             return fit(on_input(s.mesh, O, {side, in.degree(j)}, {side, j}), s.K().size(k),
                        s.K().size(k));
         }},
        {"cell_degree",
         [&s, side, j](Inputs& in) {
             const int k = cell_degree(s.P(), side, in.degree(j));
             return fit(k == (side == Side::primal ? j : s.n() - j));
         }},
    };
    if (j < n)
        all.push_back(
            one("d", side, j + 1, [&s](const Cochain& a) { return d(s.mesh.complex(), a); }));
    if (j > 0) {
        all.push_back(one("codifferential", side, j - 1,
                          [&s](const Cochain& a) { return codifferential(s.mesh, a); }));
        all.push_back({"boundary", [&s, side, j](Inputs& in) {
                           const auto c = boundary(s.P(), in.chain(s, side, j));
                           return fit(Cochain{c.side, c.degree, c.values}, s.P(), side, j - 1);
                       }});
    }
    return all;
}

Questions of_transfers(const Sample& s, int k) {
    const int n = s.n();
    return {
        {"primal_to_merged",
         [&s, k](Inputs& in) {
             return fit(primal_to_merged(s.mesh.merging(), in.degree(k)), s.size(k),
                        s.pieces().size(k));
         }},
        {"primal_to_input",
         [&s, k](Inputs& in) {
             return fit(primal_to_input(s.mesh.merging(), s.geometry().volumes(), in.degree(k)),
                        s.pieces().size(k), s.size(k));
         }},
        {"dual_to_merged",
         [&s, k, n](Inputs& in) {
             return fit(dual_to_merged(s.mesh.merging(), s.geometry().volumes(), in.degree(n - k)),
                        s.size(k), s.pieces().size(k));
         }},
        {"dual_to_input",
         [&s, k, n](Inputs& in) {
             return fit(dual_to_input(s.mesh.merging(), in.degree(n - k)), s.pieces().size(k),
                        s.size(k));
         }},
        {"lift",
         [&s, k](Inputs&) {
             return fit(s.mesh.merged().lift()[k], s.pieces().size(k), s.size(k));
         }},
        {"passage there",
         [&s, k](Inputs& in) {
             const auto& passage = s.mesh.passage();
             const int degree = in.degree(k);
             return fit(passage.forth(degree, in.vector(s.K().size(k))), s.pieces().size(k)) +
                    fit(passage.matrix(degree), s.pieces().size(k), s.K().size(k));
         }},
        {"passage back",
         [&s, k](Inputs& in) {
             const auto& passage = s.mesh.passage();
             const int degree = in.degree(k);
             return fit(passage.back(degree, in.vector(s.pieces().size(k))), s.K().size(k)) +
                    fit(passage.matrix_back(degree), s.K().size(k), s.pieces().size(k));
         }},
    };
}

TEST(doors, of_complexes_and_forms_answer_rightly_or_refuse) {
    for (const Sample& s : samples()) {
        const bool all = s.name == "triangles";
        for (int k = 0; k <= s.n(); ++k) {
            const auto where = s.name + ", degree " + std::to_string(k);
            expect_answers(of_complexes(s, k), where, all);
            expect_answers(of_operators(s, k), where, false);
            expect_answers(of_transfers(s, k), where, all);
            expect_answers(of_forms(s, Side::primal, k), where, all);
            expect_answers(of_forms(s, Side::dual, k), where);
        }
    }
}

} // namespace
} // namespace polydec::test
