// SPDX-License-Identifier: MIT
//
// Every function of fields, products, solvers and pictures, asked of every kind of sample with
// right inputs and with flawed ones: see Asking.
#include "tests/io/doors.h"

namespace polydec::test {
namespace {

SmoothForm constant(int degree, Index coordinates) {
    return [count = binomial(coordinates, degree)](const Vector&) {
        return Vector(Vector::Ones(count));
    };
}

void ask_of_products(const Asking& ask, const Sample& s, int k, int l) {
    const int n = s.n();
    for (const auto weights : {WedgeWeights::uniform, WedgeWeights::circumcentric})
        ask("wedge", [&](Inputs& in) {
            const auto a = in.form(s, Side::primal, k), b = in.form(s, Side::primal, l);
            return fit(wedge(s.mesh, a, b, weights), s.P(), Side::primal, k + l);
        });
    const auto on_pieces = [&](Inputs& in, int degree) {
        return in.form_on(s.pieces(), Side::primal, degree);
    };
    ask("wedge of pieces", [&](Inputs& in) {
        return fit(wedge(s.pieces(), on_pieces(in, k), on_pieces(in, l)), s.pieces(), Side::primal,
                   k + l);
    });
    ask("dual_wedge", [&](Inputs& in) {
        const auto a = in.form(s, Side::dual, k), b = in.form(s, Side::dual, l);
        return fit(dual_wedge(s.mesh, a, b), s.P(), Side::dual, k + l);
    });
    if (k + l == n)
        ask("primal_dual_wedge", [&](Inputs& in) {
            const auto a = in.form(s, Side::primal, k), b = in.form(s, Side::dual, l);
            return fit(primal_dual_wedge(s.P(), a, b), s.size(k));
        });
}

void ask_of_vector_fields(const Asking& ask, const Sample& s) {
    const Index N = static_cast<Index>(s.mesh.points().cols());
    const int n = s.n();

    ask("sharp_pp", [&](Inputs& in) {
        return fit(sharp_pp(s.mesh, in.form(s, Side::primal, 1)), s.size(0), N);
    });
    ask("sharp_pd", [&](Inputs& in) {
        return fit(sharp_pd(s.mesh, in.form(s, Side::primal, 1)), s.size(n), N);
    });
    ask("flux_sharp", [&](Inputs& in) {
        return fit(flux_sharp(s.mesh, in.form(s, Side::primal, n - 1)), s.size(n), N);
    });

    for (const Flat kind : {Flat::ppp, Flat::pdp, Flat::dpp, Flat::ppd, Flat::pdd, Flat::dpd}) {
        const bool of_cells = kind == Flat::dpp || kind == Flat::dpd;
        const bool to_dual = kind == Flat::ppd || kind == Flat::pdd || kind == Flat::dpd;
        ask("flat", [&](Inputs& in) {
            const auto field = in.matrix(s.size(of_cells ? s.n() : 0), N);
            return fit(flat(s.mesh, kind, field), s.P(), to_dual ? Side::dual : Side::primal, 1);
        });
    }
}

void ask_of_fields(const Asking& ask, const Sample& s, int k) {
    const Index N = static_cast<Index>(s.mesh.points().cols());
    const int n = s.n();

    ask("interior_product", [&](Inputs& in) {
        const int degree = in.degree(s, k, 0, 1);
        return fit(interior_product(s.mesh, in.matrix(s.size(0), N), degree, Sampling::upwind),
                   s.size(k - 1), s.size(k));
    });
    ask("lie_derivative", [&](Inputs& in) {
        const int degree = in.degree(s, k);
        return fit(lie_derivative(s.mesh, in.matrix(s.size(0), N), degree, Sampling::centered),
                   s.size(k), s.size(k));
    });
    ask("inflow", [&](Inputs& in) {
        const int degree = in.degree(s, k);
        return fit(inflow(s.mesh, in.matrix(s.size(0), N), degree), s.size(k), s.size(k));
    });
    ask("de_rham", [&](Inputs& in) {
        return fit(de_rham(s.mesh, in.degree(s, k), constant(k, N)), s.P(), Side::primal, k);
    });
    ask("dual_de_rham", [&](Inputs& in) {
        return fit(dual_de_rham(s.mesh, in.degree(s, k), constant(k, N)), s.P(), Side::dual, k);
    });
    ask("de_rham between points", [&](Inputs& in) {
        return fit(de_rham(s.K(), in.points(s.K().size(0), N), k, constant(k, N)), s.K().size(k));
    });
    ask("whitney_at_centroids", [&](Inputs& in) {
        return fit(whitney_at_centroids(s.mesh, in.form(s, Side::primal, k)), s.K().size(n),
                   binomial(N, k));
    });
    ask("whitney_form", [&](Inputs& in) {
        const auto w = in.form(s, Side::primal, k);
        Vector where = in.vector(n + 1);
        where /= where.sum();
        return fit(whitney_form(s.mesh, w, 0, where), binomial(N, k));
    });
    ask("cell_centers",
        [&](Inputs& in) { return fit(cell_centers(s.mesh, in.degree(s, k)), s.size(k), N); });
    ask("cell_centroids",
        [&](Inputs& in) { return fit(cell_centroids(s.mesh, in.degree(s, k)), s.size(k), N); });
    ask("circumradii", [&](Inputs& in) {
        return fit(circumradii(s.pieces(), s.mesh.geometry().metric(), in.degree(s, k)),
                   s.pieces().size(k));
    });
    ask("center_coordinates", [&](Inputs& in) {
        return fit(center_coordinates(s.pieces(), s.mesh.geometry().metric(),
                                      s.mesh.options().centers, in.degree(s, k)),
                   s.pieces().size(k), k + 1);
    });
    ask("combinations", [&](Inputs& in) {
        const int degree = in.degree(s, k);
        const Points places = in.matrix(s.pieces().size(k), k + 1);
        return fit(combinations(s.pieces(), degree, places, in.points(s.pieces().size(0), 2)),
                   s.pieces().size(k), 2);
    });
    ask("dual volumes", [&](Inputs&) {
        return fit(circumcentric_volumes(s.pieces(), s.mesh.geometry().metric()).dual(k),
                   s.pieces().size(k)) +
               fit(dual_volumes(s.pieces(), s.mesh.geometry().metric(), Centers::centroids())
                       .dual(k),
                   s.pieces().size(k));
    });
    ask("edge_lengths", [&](Inputs& in) {
        return fit(edge_lengths(s.K(), in.points(s.K().size(0), N)), s.K().size(1));
    });
    ask("grundmann_moeller", [&](Inputs&) {
        const auto rule = grundmann_moeller(k, 3);
        return fit(rule.points, rule.weights.size(), k + 1);
    });
}

void ask_of_diagnoses(const Asking& ask, const Sample& s) {
    const int n = s.n();

    ask("facet_kinds", [&](Inputs&) {
        const auto kinds = facet_kinds(s.geometry());
        return fit(kinds.well_centered + kinds.delaunay + kinds.non_delaunay + kinds.cospherical <=
                   s.pieces().size(s.n() - 1));
    });
    ask("merged_pairs", [&](Inputs&) { return fit(merged_pairs(s.mesh.merging()).facets >= 0); });
    ask("merge_cospherical", [&](Inputs& in) {
        const auto stay = in.list(s.pieces().size(n - 1), true);
        const auto merged = merge_cospherical(s.geometry(), {}, {.stay = stay});
        return fit(merged.merging.merged().size(n) == s.pieces().size(n));
    });
    ask("operator_verdicts", [&](Inputs&) {
        bool right = true;
        for (const auto stage : {Stage::input, Stage::merged})
            for (const auto& verdict : operator_verdicts(s.mesh, stage))
                right = right && (verdict.verdict == WellDefined::yes) == reason(verdict).empty();
        return fit(right);
    });
    ask("spectrum_verdicts", [&](Inputs&) {
        return fit(std::ssize(spectrum_verdicts(s.V())) == n + 1 &&
                   std::ssize(spectrum_verdicts(s.mesh, Side::dual)) == n + 1);
    });
    ask("essential_where and in_words", [&](Inputs& in) {
        const Points sites = Points::Ones(std::ssize(in.list(s.size(n - 1), 0)), 2);
        const auto conditions = essential_where(sites, [](const Vector&) { return true; });
        return fit(!in_words(boundary_counts(s.P(), conditions), 0, s.P().dimension()).empty() &&
                   std::ssize(essential_cells(s.P(), conditions)) == n + 1);
    });
    ask("FormSpace", [&](Inputs& in) {
        BoundaryConditions conditions;
        conditions.facets = in.list(s.size(n - 1), BoundaryCondition::natural);
        const FormSpace there({s.P(), s.mesh.stars()}, Side::primal, in.degree(s, 0), conditions);
        return fit(there.inside().stars()[0].diagonal(), there.size());
    });
    ask("diagnose", [&](Inputs&) {
        const auto found = diagnose(s.mesh);
        const auto even = [](const std::vector<Index>& numbers) {
            Index sum = 0;
            for (std::size_t i = 0; i < numbers.size(); ++i)
                sum += i % 2 == 0 ? numbers[i] : -numbers[i];
            return sum;
        };
        return fit(std::ssize(found.laplacians) == n + 1 &&
                   found.cells.merged.back() == s.size(n) && found.warnings.empty() &&
                   even(found.betti.input) == found.euler.input &&
                   even(found.cells.merged) == found.euler.merged);
    });
    ask("advice", [&](Inputs&) {
        bool right = true;
        for (const Advice& one : advice(s.mesh))
            right = right && one.cells > 0 && !in_words(one, n).empty() &&
                    one.remedy == (one.negative ? remedy(s.mesh) : Remedy::stars);
        return fit(right);
    });
    ask("join of tags", [&](Inputs&) {
        return fit(
            (s.mesh.tags().empty() || std::ssize(s.mesh.tags()) == s.size(s.n())) &&
            (s.mesh.facet_tags().empty() || std::ssize(s.mesh.facet_tags()) == s.size(s.n() - 1)));
    });
}

TEST(doors, of_fields_and_diagnoses_answer_rightly_or_refuse) {
    for (const Sample& s : samples()) {
        const bool all = s.name == "triangles";
        ask_of_vector_fields({s.name, all}, s);
        ask_of_diagnoses({s.name, all}, s);
        for (int k = 0; k <= s.n(); ++k) {
            const auto where = s.name + ", degree " + std::to_string(k);
            ask_of_fields({where, all}, s, k);
            for (int l = 0; k + l <= s.n(); ++l)
                ask_of_products({where + " and " + std::to_string(l), all}, s, k, l);
        }
    }
}

} // namespace
} // namespace polydec::test
