// SPDX-License-Identifier: MIT
//
// Every function of complexes and forms, asked of every kind of sample with right inputs and with
// flawed ones: see Asking.
#include "complex/blocks.h"
#include "dec/merging/merged_tags.h"
#include "tests/io/doors.h"

namespace polydec::test {
namespace {

void ask_of_complexes(const Asking& ask, const Sample& s, int k) {
    ask("cells of a degree", [&](Inputs& in) {
        return fit(s.P().coface_counts(in.degree(s, k)).size() == std::size_t(s.size(k)) &&
                   s.K().simplices(in.degree(s, k)).rows() == s.K().size(k) &&
                   (k == 0 || s.K().face(in.degree(s, k, 1), 0, 0) >= 0) &&
                   (k == s.n() || s.P().canceled(in.degree(s, k, 0, -1)).size() < 9));
    });
    ask("coboundary", [&](Inputs& in) {
        return fit(SparseMatrix(s.P().coboundary(in.degree(s, k, -1)).cast<double>()),
                   s.size(k + 1), s.size(k));
    });
    ask("boundary", [&](Inputs& in) {
        return fit(SparseMatrix(s.P().boundary(in.degree(s, k, 0, 1)).cast<double>()),
                   s.size(k - 1), s.size(k));
    });
    ask("homology_generators", [&](Inputs& in) {
        return fit(homology_generators(s.P(), in.degree(s, k)), s.size(k), betti_numbers(s.P())[k]);
    });
    ask("regular_minor", [&](Inputs& in) {
        const auto minor = regular_minor(s.P(), in.degree(s, k));
        return fit(minor.columns.size() == minor.rows.size());
    });
    ask("euler_characteristic", [&](Inputs&) {
        Index sum = 0;
        for (int i = 0; const Index betti : betti_numbers(s.P()))
            sum += i++ % 2 == 0 ? betti : -betti;
        return fit(sum == euler_characteristic(s.P()));
    });
    ask("components", [&](Inputs&) {
        return fit(components(s.P()).count == betti_numbers(s.P())[0] &&
                   boundary_components(s.P()).count >= 0);
    });
    ask("boundary_cells and relative_complex", [&](Inputs& in) {
        auto marks = boundary_cells(s.P());
        marks[k] = in.list(s.size(k), false);
        for (int lower = 0; lower < k; ++lower)
            marks[lower].assign(marks[lower].size(), false);
        for (int upper = k + 1; upper <= s.n(); ++upper)
            marks[upper].assign(marks[upper].size(), false);
        mark_faces(s.P(), marks);
        return fit(relative_complex(s.P(), marks).complex.size(k) == s.size(k));
    });
    ask("relative_to_boundary", [&](Inputs& in) {
        const auto relative = relative_to_boundary(s.P());
        const Vector kept = relative.restrict(in.degree(s, k), in.vector(s.size(k)));
        return fit(relative.extend(k, kept), s.size(k));
    });
    ask("RelativeComplex::extend", [&](Inputs& in) {
        const auto relative = relative_to_boundary(s.P());
        return fit(relative.extend(in.degree(s, k), in.vector(relative.complex.size(k))),
                   s.size(k));
    });
}

void ask_of_merged_cells(const Asking& ask, const Sample& s, int k) {
    const int n = s.n();
    ask("merging", [&](Inputs& in) {
        const auto& merging = s.mesh.merging();
        return fit(SparseMatrix(merging.diamond(in.degree(s, k)).cast<double>()), s.size(k),
                   s.pieces().size(k));
    });
    ask("vertices of merged cells", [&](Inputs& in) {
        return fit(!s.mesh.merging().vertices(in.degree(s, k), 0).empty() &&
                   !s.mesh.merging().carriers(in.degree(s, k)).empty() &&
                   !cell_vertices(s.mesh, in.degree(s, k), 0).empty());
    });
    ask("unmerged",
        [&](Inputs&) { return fit(Merging(s.pieces()).merged().size(k) == s.pieces().size(k)); });
    ask("join_blocks", [&](Inputs& in) {
        const auto facets = in.list<bool>(s.pieces().size(n - 1), true);
        const auto blocks =
            join_blocks(s.pieces(), facets, [](int, Index, Index, Index) { return false; });
        inadmissible_blocks(s.pieces(), blocks);
        return fit(Index(blocks.carriers.size()) == n + 1);
    });
    ask("merged_tags", [&](Inputs& in) {
        std::vector<std::string> warnings;
        const auto tags = merged_tags(s.mesh.merging(), in.degree(s, k),
                                      in.list<Index>(s.pieces().size(k), 3), warnings);
        return fit(Index(tags.size()) == s.size(k));
    });
    ask("volumes", [&](Inputs& in) {
        const int degree = in.degree(s, k);
        return fit(s.V().primal(degree), s.size(k)) + fit(s.V().dual(degree), s.size(k)) +
               fit(s.V().terms(degree).vector(), s.size(k)) +
               fit(s.V().rounding(degree).vector(), s.size(k));
    });
    ask("with_dual", [&](Inputs& in) {
        const auto other = s.V().with_dual(in.degree(s, k), in.vector(s.size(k)));
        return fit(s.mesh.with_volumes(other).volumes().dual(k), s.size(k));
    });
    ask("merged_volumes", [&](Inputs&) {
        return fit(merged_volumes(s.mesh.merging(), s.geometry().volumes()).primal(k), s.size(k));
    });
    ask("corners", [&](Inputs&) { return fit(corners(s.mesh.merging(), 0).size() >= 3); });
}

void ask_of_operators(const Asking& ask, const Sample& s, int k) {
    const int n = s.n();
    ask("derivative", [&](Inputs& in) {
        return fit(derivative(s.mesh.complex(), in.degree(s, k, -1)), s.size(k + 1), s.size(k));
    });
    ask("dual_derivative", [&](Inputs& in) {
        return fit(dual_derivative(s.mesh.complex(), in.degree(s, n - k, -1)), s.size(k - 1),
                   s.size(k));
    });
    ask("star",
        [&](Inputs& in) { return fit(star(s.mesh, in.degree(s, k)).diagonal(), s.size(k)); });
    ask("inverse star",
        [&](Inputs& in) { return fit(star(s.V(), in.degree(s, k)).inverse(), s.size(k)); });
    ask("stars", [&](Inputs& in) {
        return fit(s.mesh.stars()[in.degree(s, k)].matrix(), s.size(k), s.size(k));
    });
    ask("star of values", [&](Inputs& in) {
        return fit(star(s.V(), in.degree(s, k)) * in.vector(s.size(k)), s.size(k));
    });
    ask("inverse star of values", [&](Inputs& in) {
        return fit(star(s.V(), in.degree(s, k)).solve(in.vector(s.size(k))), s.size(k));
    });
    const auto ask_operator = [&](const char* name, Index rows, auto make) {
        ask(name, [&](Inputs& in) {
            const auto A = make(in);
            return fit(A, rows, s.size(k)) + fit(A * in.vector(s.size(k)), rows);
        });
    };
    ask_operator("codifferential", s.size(k - 1),
                 [&](Inputs& in) { return codifferential(s.mesh, in.degree(s, k)); });
    ask_operator("dual_codifferential", s.size(k + 1),
                 [&](Inputs& in) { return dual_codifferential(s.mesh, in.degree(s, n - k)); });
    ask_operator("laplacian", s.size(k),
                 [&](Inputs& in) { return laplacian(s.mesh, in.degree(s, k)); });
    ask_operator("symmetric_laplacian", s.size(k),
                 [&](Inputs& in) { return symmetric_laplacian(s.mesh, in.degree(s, k)); });
    ask_operator("dual_laplacian", s.size(k),
                 [&](Inputs& in) { return dual_laplacian(s.mesh, in.degree(s, n - k)); });
    ask("symmetric_laplacian_diagonal", [&](Inputs& in) {
        return fit(symmetric_laplacian(s.mesh, in.degree(s, k)).diagonal(), s.size(k));
    });
    if (k < n)
        ask("dual_boundary_derivative", [&](Inputs& in) {
            return fit(dual_boundary_derivative(s.P(), in.degree(s, n - k - 1)), s.size(k),
                       s.size(k));
        });
    ask("apply_derivative", [&](Inputs& in) {
        return fit(Operator::derivative(s.P(), in.degree(s, k, -1)) * in.vector(s.size(k)),
                   s.size(k + 1));
    });
    ask("apply_transposed_derivative", [&](Inputs& in) {
        return fit(Operator::derivative(s.P(), in.degree(s, k, 0, 1) - 1).transposed() *
                       in.vector(s.size(k)),
                   s.size(k - 1));
    });
    ask("Operator::weights", [&](Inputs& in) {
        const auto weights = Operator::weights(in.vector(s.size(k)));
        return fit(weights * in.vector(s.size(k)), s.size(k));
    });
    ask("products of operators", [&](Inputs& in) {
        const auto d = Operator::derivative(s.P(), in.degree(s, k, -1));
        const auto A = d.transposed() * Operator::weights(in.vector(s.size(k + 1))) * d;
        return fit(A, s.size(k), s.size(k)) + fit(A.diagonal(), s.size(k));
    });
    ask("sums of operators", [&](Inputs& in) {
        const Index columns = Index(in.vector(s.size(k)).size());
        const auto A = Operator::zero(s.size(k), columns) + Operator::weights(in.vector(s.size(k)));
        return fit(A, s.size(k), s.size(k)) + fit(A * in.vector(s.size(k)), s.size(k));
    });
    ask("negative and zero stars", [&](Inputs& in) {
        const auto all = star(s.V(), in.degree(s, k));
        const auto cells = all.negatives();
        return fit(Index(all.zeros().size() + cells.size()) <= s.size(k) &&
                   all.numbers(cells).size() < 1000 && all.place(cells).cells == cells);
    });
}

/// j is the degree of the forms.
void ask_of_forms(const Asking& ask, const Sample& s, Side side, int j) {
    const Side other = side == Side::primal ? Side::dual : Side::primal;
    const int n = s.n();
    const Asking ask_of_primal{ask.where, ask.all_answered && side == Side::primal};
    const auto form = [&](Inputs& in) { return in.form(s, side, j); };

    ask("multiple", [&](Inputs& in) {
        const auto a = form(in);
        check(s.P(), a);
        return fit(2.0 * a, s.P(), side, j);
    });
    ask("star", [&](Inputs& in) { return fit(star(s.mesh, form(in)), s.P(), other, n - j); });
    ask("laplacian", [&](Inputs& in) { return fit(laplacian(s.mesh, form(in)), s.P(), side, j); });
    ask("inner_product",
        [&](Inputs& in) { return fit(inner_product(s.mesh, form(in), form(in))); });
    ask("sum", [&](Inputs& in) { return fit((form(in) + form(in)).values.sum()); });
    ask("difference", [&](Inputs& in) { return fit((form(in) - form(in)).values.sum()); });
    ask("norm", [&](Inputs& in) { return fit(norm(s.mesh, form(in)) + norm(s.mesh, form(in))); });
    ask("pairing", [&](Inputs& in) {
        const auto w = form(in);
        return fit(pairing(w, in.chain(s, side, j)));
    });
    ask("to_input", [&](Inputs& in) { return fit(to_input(s.mesh, form(in)), s.K(), side, j); });
    ask("to_merged", [&](Inputs& in) {
        return fit(to_merged(s.mesh, in.form_on(s.K(), side, j)), s.P(), side, j);
    });
    ask_of_primal("on_pieces", [&](Inputs& in) {
        return fit(on_pieces(s.mesh, form(in)), s.pieces(), side, j);
    });
    ask("on_cells", [&](Inputs& in) {
        return fit(on_cells(s.mesh, in.form_on(s.pieces(), side, j)), s.P(), side, j);
    });
    ask_of_primal("lifted",
                  [&](Inputs& in) { return fit(lifted(s.mesh, form(in)), s.K(), side, j); });
    ask("consistency", [&](Inputs& in) {
        return fit(consistency(s.mesh, in.form_on(s.pieces(), Side::dual, j)).worst);
    });
    ask("on_input", [&](Inputs& in) {
        const int k = side == Side::primal ? j : n - j;
        const auto O = in.operator_matrix(s.size(k), s.size(k));
        return fit(on_input(s.mesh, O, {side, in.degree(s, j)}, {side, j}), s.K().size(k),
                   s.K().size(k));
    });
    ask("cell_degree", [&](Inputs& in) {
        const int k = cell_degree(s.P(), side, in.degree(s, j));
        return fit(k == (side == Side::primal ? j : s.n() - j));
    });

    if (j < n)
        ask("d",
            [&](Inputs& in) { return fit(d(s.mesh.complex(), form(in)), s.P(), side, j + 1); });
    if (j > 0) {
        ask("codifferential",
            [&](Inputs& in) { return fit(codifferential(s.mesh, form(in)), s.P(), side, j - 1); });
        ask("boundary", [&](Inputs& in) {
            const auto c = boundary(s.P(), in.chain(s, side, j));
            return fit(Cochain{c.side, c.degree, c.values}, s.P(), side, j - 1);
        });
    }
}

void ask_of_transfers(const Asking& ask, const Sample& s, int k) {
    const int n = s.n();

    ask("primal_to_merged", [&](Inputs& in) {
        return fit(primal_to_merged(s.mesh.merging(), in.degree(s, k)), s.size(k),
                   s.pieces().size(k));
    });
    ask("primal_to_input", [&](Inputs& in) {
        return fit(primal_to_input(s.mesh.merging(), s.geometry().volumes(), in.degree(s, k)),
                   s.pieces().size(k), s.size(k));
    });
    ask("dual_to_merged", [&](Inputs& in) {
        return fit(dual_to_merged(s.mesh.merging(), s.geometry().volumes(), in.degree(s, n - k)),
                   s.size(k), s.pieces().size(k));
    });
    ask("dual_to_input", [&](Inputs& in) {
        return fit(dual_to_input(s.mesh.merging(), in.degree(s, n - k)), s.pieces().size(k),
                   s.size(k));
    });
    ask("lift",
        [&](Inputs&) { return fit(s.mesh.merged().lift()[k], s.pieces().size(k), s.size(k)); });
    ask("passage there", [&](Inputs& in) {
        const auto& passage = s.mesh.passage();
        return fit(passage.forth(in.degree(s, k), in.vector(s.K().size(k))), s.pieces().size(k)) +
               fit(passage.matrix(in.degree(s, k)), s.pieces().size(k), s.K().size(k));
    });
    ask("passage back", [&](Inputs& in) {
        const auto& passage = s.mesh.passage();
        return fit(passage.back(in.degree(s, k), in.vector(s.pieces().size(k))), s.K().size(k)) +
               fit(passage.matrix_back(in.degree(s, k)), s.K().size(k), s.pieces().size(k));
    });
    if (s.mesh.passage().is_identity())
        return;
    ask("FlipHistory", [&](Inputs& in) {
        const auto& history = s.mesh.passage().flips().history;
        const Index before = s.K().size(k), after = s.pieces().size(k);
        return fit(history.carry(in.degree(s, k), in.vector(before)), after) +
               fit(history.carry_back(in.degree(s, k), in.vector(after)), before) +
               fit(history.matrix(in.degree(s, k)), after, before) +
               fit(history.matrix_back(in.degree(s, k)), before, after);
    });
}

TEST(doors, of_complexes_and_forms_answer_rightly_or_refuse) {
    for (const Sample& s : samples()) {
        const bool all = s.name == "triangles";
        for (int k = 0; k <= s.n(); ++k) {
            const auto where = s.name + ", degree " + std::to_string(k);
            ask_of_complexes({where, all}, s, k);
            ask_of_merged_cells({where, all}, s, k);
            ask_of_operators({where, all}, s, k);
            ask_of_transfers({where, all}, s, k);
            ask_of_forms({where, all}, s, Side::primal, k);
            ask_of_forms({where, all}, s, Side::dual, k);
        }
    }
}

} // namespace
} // namespace polydec::test
