// SPDX-License-Identifier: MIT
//
// Every solver, surface function and picture, asked of every kind of sample with right inputs and
// with flawed ones: see Asking.
#include "tests/io/doors.h"

namespace polydec::test {
namespace {

const std::string engine = "eigen.ldlt";

BoundaryConditions conditions_of(const Sample& s, Inputs& in) {
    BoundaryConditions conditions;
    conditions.facets = in.list(s.size(s.n() - 1), BoundaryCondition::natural);
    conditions.facets.front() = BoundaryCondition::essential;
    return conditions;
}

/// A form one step of heat later.
Cochain heated(const FormSpace& space, const Cochain& start) {
    Evolution run(
        {{space, start.values, 1}}, {},
        {.integrator = "backward-euler", .steps = {.fixed_step = 0.01}, .linear_solver = engine});
    run.march(0.01);
    return run.form(0);
}

void ask_of_solvers(const Asking& ask, const Sample& s, Side side) {
    const int n = s.n();
    const auto values = [side, &s](int facets_or_cells) {
        return s.size(side == Side::primal ? 0 : facets_or_cells);
    };
    const Index unknowns = values(n), boundary = values(n - 1);

    ask("PoissonSolver", [&](Inputs& in) {
        const Vector kappa = in.vector(s.size(n)).cwiseAbs();
        const PoissonSolver solver(
            {with_conductivity(s.mesh, side, kappa), side, 0, conditions_of(s, in)}, engine);
        const Cochain f{side, 0, in.vector(unknowns)};
        const auto found = solver.solve(
            f, {.values = in.vector(boundary),
                .derivative_flow = outward_flow(s.mesh, side, in.vector(s.size(n - 1)))});
        return fit(found.form, s.P(), side, 0);
    });
    ask("PoissonSolver of any cells", [&](Inputs& in) {
        const PoissonSolver solver({s.cells(), side, 0, conditions_of(s, in)}, engine);
        const Cochain f{side, 0, in.vector(unknowns)};
        return fit(solver.solve(f, {.values = in.vector(boundary)}).form, s.P(), side, 0);
    });
}

void ask_of_solvers_for_forms(const Asking& ask, const Sample& s, Side side, int j) {
    const int n = s.n(), k = side == Side::primal ? j : n - j;

    ask("Evolution", [&](Inputs& in) {
        const FormSpace space(s.mesh, side, in.degree(s, j));
        return fit(heated(space, in.form(s, side, j)), s.P(), side, j);
    });
    ask("Evolution under conditions", [&](Inputs& in) {
        const FormSpace space(s.mesh, side, j, conditions_of(s, in));
        return fit(heated(space, in.form(s, side, j)), s.P(), side, j);
    });
    ask("hodge_decomposition", [&](Inputs& in) {
        const auto parts = hodge_decomposition({s.mesh, side, j}, in.form(s, side, j), engine);
        return fit(parts.exact, s.P(), side, j) + fit(parts.coexact, s.P(), side, j) +
               fit(parts.harmonic, s.P(), side, j);
    });
    ask("harmonic_forms", [&](Inputs& in) {
        const auto forms = harmonic_forms({s.mesh, side, in.degree(s, j)}, engine);
        return fit(forms, s.size(k), betti_numbers(s.P())[k]);
    });
    ask("spectrum", [&](Inputs& in) {
        const auto found = spectrum({s.mesh, side, in.degree(s, j)}, {.count = 1});
        return fit(found.modes, s.size(k), 1) + fit(found.eigenvalues, 1);
    });
    ask("spectrum under conditions", [&](Inputs& in) {
        const auto found =
            spectrum({s.mesh, side, in.degree(s, j), conditions_of(s, in)}, {.count = 1});
        return fit(found.modes, s.size(k), 1) + fit(found.eigenvalues, 1);
    });
    if (side == Side::dual || j == n)
        return;
    ask("coexact_spectrum", [&](Inputs& in) {
        const auto found =
            coexact_spectrum({s.cells(), side, in.degree(s, j, 0, -1)}, {.count = 1});
        return fit(found.modes, s.size(j), 1);
    });
    ask("stable_step", [&](Inputs& in) {
        return fit(stable_step({s.mesh, side, in.degree(s, j, 0, -1)}) > 0);
    });
    ask("Waves", [&](Inputs& in) {
        Waves waves({s.mesh, side, in.degree(s, j, 0, -1)}, in.vector(s.size(j)),
                    {.B = in.vector(s.size(j + 1))});
        waves.advance();
        return fit(waves.form(0).values, s.size(j)) + fit(waves.form(1).values, s.size(j + 1)) +
               fit(waves.energy());
    });
}

/// The triangles that a surface has after flips, with their lengths.
GluedSurface surface_of(const Sample& s) {
    return s.mesh.passage().is_identity() ? GluedSurface(s.K()) : s.mesh.passage().flips().surface;
}

Vector lengths_of(const Sample& s) {
    if (!s.mesh.passage().is_identity())
        return s.mesh.passage().flips().lengths;
    return s.has_points() ? edge_lengths(s.K(), s.mesh.input_points()) : s.mesh.lengths();
}

/// The lengths, one more or less where the input is flawed.
Vector lengths_of(const Sample& s, Inputs& in) {
    const Vector right = lengths_of(s);
    const Vector given = in.vector(right.size());
    return given.size() == right.size() ? right : Vector(Vector::Ones(given.size()));
}

void ask_of_surfaces(const Asking& ask, const Sample& s) {
    ask("geodesic_distance",
        [&](Inputs&) { return fit(geodesic_distance(s.mesh, std::vector<Index>{0}), s.size(0)); });
    ask("GeodesicDistance", [&](Inputs& in) {
        const GeodesicDistance distance(surface_of(s), lengths_of(s, in),
                                        {.method = DistanceMethod::heat, .linear_solver = engine});
        return fit(distance.to(std::vector<Index>{0}).values, s.size(0));
    });
    ask("exact_distance", [&](Inputs& in) {
        return fit(exact_distance(surface_of(s), lengths_of(s, in), std::vector<Index>{0}),
                   s.size(0));
    });
    ask("ParallelTransport", [&](Inputs& in) {
        const TangentVectors one(TangentVectors::Ones(in.vector(1).size()));
        const Vector lengths = lengths_of(s, in);
        const auto all = ParallelTransport(surface_of(s), lengths, {4, engine})
                             .extend(std::vector<Index>{0}, one);
        return fit(Vector(all.cwiseAbs()), s.size(0));
    });
    ask("tangent_frames", [&](Inputs& in) {
        const auto frames = tangent_frames(surface_of(s), lengths_of(s, in));
        return fit(frames.sums, s.size(0)) + fit(frames.at_tail, 3 * s.pieces().size(2));
    });
    ask("intrinsic_delaunay", [&](Inputs& in) {
        const auto flips = intrinsic_delaunay(surface_of(s), lengths_of(s, in));
        return fit(flips.lengths, flips.surface.edges()) +
               fit(flips.statistics.negative_interior == 0);
    });
    ask("overlay", [&](Inputs&) {
        const auto both = overlay(s.mesh.passage(), s.mesh.points());
        return fit(both.areas, both.size());
    });
    ask("Overlay::at_points", [&](Inputs& in) {
        const auto both = overlay(s.mesh.passage(), s.mesh.points());
        return fit(both.at_points(in.points(s.pieces().size(0), 2)), both.points.rows(), 2);
    });
}

void ask_of_pictures(const Asking& ask, const Sample& s, int k) {
    const int n = s.n();

    ask("draw_cells", [&](Inputs& in) {
        const VtuGrid grid = draw_cells(s.mesh, in.degree(s, k));
        return fit(grid.points.allFinite() && !grid.types.empty());
    });
    ask("add_field", [&](Inputs& in) {
        VtuGrid grid = draw_cells(s.mesh, k);
        add_field(grid, s.mesh, k, {"a", in.form(s, Side::primal, k)});
        return fit(grid.point_data.size() + grid.cell_data.size() == 1);
    });
    ask("add_cochain", [&](Inputs& in) {
        VtuGrid grid = draw_cells(s.P(), s.mesh.points(), k);
        add_cochain(grid, s.P(), in.degree(s, k), "a", in.vector(s.size(k)));
        return fit(grid.point_data.size() + grid.cell_data.size() == 1);
    });
    ask("polygon_mesh", [&](Inputs&) { return fit(polygon_mesh(s.mesh).points.allFinite()); });
    ask("draw_overlay", [&](Inputs&) { return fit(draw_overlay(s.mesh).points.allFinite()); });
    ask("kept_faces and kept_cells", [&](Inputs& in) {
        const auto all = [](const Vector&) { return true; };
        const auto faces = kept_faces(s.mesh, all, in.vector(s.size(n)));
        const auto cells = kept_cells(s.mesh, all, 0.1, in.vector(s.size(n)));
        return fit(!draw_solid(faces).shapes.empty() && !painting_order(cells).empty() &&
                   !to_svg(draw_solid(cells)).empty());
    });
}

TEST(doors, of_solvers_surfaces_and_pictures_answer_rightly_or_refuse) {
    for (const Sample& s : samples()) {
        const bool all = s.name == "triangles";
        ask_of_surfaces({s.name}, s);
        for (const Side side : {Side::primal, Side::dual})
            ask_of_solvers({s.name + ", " + name(side), all}, s, side);
        for (int k = 0; k <= s.n(); ++k) {
            const auto where = s.name + ", degree " + std::to_string(k);
            ask_of_pictures({where}, s, k);
            for (const Side side : {Side::primal, Side::dual})
                ask_of_solvers_for_forms({where + ", " + name(side), all}, s, side, k);
        }
    }
}

} // namespace
} // namespace polydec::test
