// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_boundary_conditions {

class RobinCoefficients : public OverMeshes {};

TEST_P(RobinCoefficients, are_taken_facet_by_facet) {
    const CellComplex& P = mesh().P();
    const int n = mesh().n();
    const auto facets = static_cast<std::size_t>(P.size(n - 1));
    BoundaryConditions mixed{BoundaryCondition::natural,
                             std::vector(facets, BoundaryCondition::natural)};
    Vector expected = Vector::Zero(P.size(n - 1));
    for (std::size_t f = 0; f < facets; ++f) {
        const auto facet = static_cast<Index>(f);
        mixed.coefficients.push_back(static_cast<double>(f + 1));
        if (f % 3 == 0)
            continue;
        mixed.facets[f] = BoundaryCondition::robin;
        if (P.coface_counts(n - 1)[facet] == 1)
            expected[facet] = static_cast<double>(f + 1);
    }
    EXPECT_EQ(robin_coefficients(P, mixed), expected);
}

POLYDEC_OVER_MESHES(RobinCoefficients);

class BoundaryData : public OverMeshes {};

/// The derivative of dual j-forms of the boundary, which lives on boundary cells and is
/// oriented by the outward normal.
SparseMatrix boundary_dual_derivative(const CellComplex& complex, int j) {
    const int n = complex.dimension(), k = n - j - 2;
    const auto marks = boundary_cells(complex);
    const IncidenceMatrix cofaces = complex.boundary(n);
    SparseMatrix D = derivative(complex, k);
    for (Index t = 0; t < D.rows(); ++t)
        for (SparseMatrix::InnerIterator entry(D, t); entry; ++entry) {
            const int induced = k + 1 == n - 1 && marks[k + 1][t]
                                    ? IncidenceMatrix::InnerIterator(cofaces, t).value()
                                    : 1;
            entry.valueRef() *= marks[k + 1][t] ? induced : 0;
        }
    return ((k % 2 == 0 ? -1.0 : 1.0) * D).transpose();
}

TEST_P(BoundaryData, derivative_twice_is_zero_with_the_boundary) {
    const auto& P = mesh().P();
    for (int j = 0; j + 2 <= mesh().n(); ++j) {
        const SparseMatrix inside = dual_derivative(P, j + 1) * dual_boundary_derivative(P, j);
        const SparseMatrix along =
            dual_boundary_derivative(P, j + 1) * boundary_dual_derivative(P, j);
        EXPECT_EQ(largest(inside + along), 0) << "j = " << j;
        if (largest(inside) > 0) {
            EXPECT_GT(largest(inside - along), 0) << "with the sign flipped";
        }
    }
}

TEST_P(BoundaryData, with_it_constant_dual_functions_have_derivative_zero) {
    const auto& P = mesh().P();
    if (branches(P) || !mesh().K().orientable())
        return;
    const Vector zero = dual_derivative(P, 0) * Vector::Ones(P.size(mesh().n())) +
                        dual_boundary_derivative(P, 0) * Vector::Ones(P.size(mesh().n() - 1));
    EXPECT_EQ(zero.cwiseAbs().maxCoeff(), 0);
}

TEST_P(BoundaryData, with_it_linear_dual_functions_have_their_gradient_on_flat_meshes) {
    const auto& input = mesh_named(GetParam());
    if (!is_flat(input) || !mesh().K().orientable())
        return;
    const auto& bundle = discretized(GetParam());
    const int n = mesh().n();
    const Vector slope = random_vector(n, 1);
    const auto centers = [&](int k) { return cell_centers(bundle, k); };
    const Vector inside = dual_derivative(bundle.complex(), 0) * Vector(centers(n) * slope);
    const Vector at_boundary =
        dual_boundary_derivative(bundle.complex(), 0) * Vector(centers(n - 1) * slope);
    const auto exact = dual_de_rham(bundle, 1, [&](const Vector&) { return slope; });
    EXPECT_LE((inside + at_boundary - exact.values).norm(), 1e-11 * at_boundary.norm());
    EXPECT_GT((inside - at_boundary - exact.values).norm(), 1e-2 * at_boundary.norm());
}

TEST_P(BoundaryData, essential_everywhere_is_relative_to_the_boundary_and_natural_is_absolute) {
    const auto& P = mesh().P();
    EXPECT_EQ(essential_cells(P, {BoundaryCondition::essential}), boundary_cells(P));
    for (const auto& marks : essential_cells(P, {BoundaryCondition::natural}))
        EXPECT_EQ(std::count(marks.begin(), marks.end(), true), 0);
}

TEST_P(BoundaryData, mixed_conditions_drop_closed_sets) {
    const auto& P = mesh().P();
    const int n = mesh().n();
    const Points sites = cell_centers(discretized(GetParam()), n - 1);
    const double middle = sites.col(0).mean();
    const auto conditions =
        essential_where(sites, [&](const Vector& site) { return site[0] < middle; });
    const auto relative = relative_complex(P, essential_cells(P, conditions));
    const auto volumes = relative_volumes(relative, mesh().volumes);
    for (int k = 0; k <= n; ++k) {
        EXPECT_EQ(volumes.primal(k).size(), relative.complex.size(k));
        EXPECT_LE(relative.complex.size(k), P.size(k));
        EXPECT_GE(relative.complex.size(k), relative_to_boundary(P).complex.size(k));
    }
}

POLYDEC_OVER_MESHES(BoundaryData);

TEST(BoundaryDataBroken, without_the_boundary_constants_have_jumps_there) {
    const auto& P = merged("grid4").P();
    EXPECT_EQ((dual_derivative(P, 0) * Vector::Ones(16)).cwiseAbs().sum(), 16);
}

TEST(BoundaryData, of_a_cone_reaches_the_vertex_of_its_loop) {
    const auto cone = cell_complex(folded_triangle());
    const auto marks =
        essential_cells(cone, {BoundaryCondition::essential, {2, BoundaryCondition::essential}});
    EXPECT_EQ(marks, boundary_cells(cone));
    EXPECT_EQ(std::count(marks[0].begin(), marks[0].end(), true), 1);
}

TEST(BoundaryWords, say_what_holds_for_forms_of_each_degree) {
    const auto words = [](const BoundaryConditions& conditions, const CellComplex& complex,
                          int degree, const polydec::BoundaryData& data = {}) {
        return in_words(boundary_counts(complex, conditions), degree, complex.dimension(), data);
    };
    const auto& P = merged("kuhn3").P();
    const BoundaryConditions essential{BoundaryCondition::essential};
    const BoundaryConditions natural{BoundaryCondition::natural};
    EXPECT_EQ(words(essential, P, 0), "values 0 on the boundary (Dirichlet)");
    EXPECT_EQ(words(natural, P, 0), "no flow through the boundary (Neumann)");
    EXPECT_EQ(words(essential, P, 1), "tangential part 0 on the boundary");
    EXPECT_EQ(words(natural, P, 2), "normal part 0 on the boundary");
    EXPECT_EQ(words(essential, P, 3), "no flow through the boundary (Neumann)");
    EXPECT_EQ(words(natural, P, 3), "values 0 on the boundary (Dirichlet)");
    EXPECT_EQ(words(essential, P, 0, {.values = true}), "values given on the boundary (Dirichlet)");
    EXPECT_EQ(words(natural, P, 0, {.flow = true}), "flow given through the boundary (Neumann)");
    EXPECT_EQ(words(essential, merged("uv8").P(), 0), "no boundary");

    const auto& squares = merged("grid4").P();
    BoundaryConditions mixed;
    mixed.facets.assign(squares.size(1), BoundaryCondition::natural);
    for (Index f = 0, left = 3; left > 0; ++f)
        if (squares.coface_counts(1)[f] == 1) {
            mixed.facets[f] = BoundaryCondition::essential;
            --left;
        }
    EXPECT_EQ(words(mixed, squares, 0),
              "values 0 on 3 of 16 boundary facets (Dirichlet), no flow through 13 of 16 boundary "
              "facets (Neumann)");
    EXPECT_EQ(words(exchanged(mixed), squares, 0),
              "values 0 on 13 of 16 boundary facets (Dirichlet), no flow through 3 of 16 boundary "
              "facets (Neumann)");
    EXPECT_EQ(exchanged(exchanged(mixed)).facets, mixed.facets);
}

TEST(BoundaryErrors, count_the_conditions) {
    const auto& P = merged("grid4").P();
    EXPECT_REFUSED(
        essential_cells(P, {BoundaryCondition::essential, {3, BoundaryCondition::natural}}),
        "3 boundary conditions", "40 1-cells");
}

TEST(FixedVertices, are_cells_on_which_primal_functions_alone_are_given) {
    const auto& P = merged("grid4").P();
    BoundaryConditions conditions{BoundaryCondition::natural};
    conditions.fixed_vertices.assign(P.size(0), false);
    conditions.fixed_vertices[12] = true;
    const auto marks = essential_cells(P, conditions, Side::primal, 0);
    EXPECT_EQ(marks[0], conditions.fixed_vertices);
    EXPECT_EQ(marks[1], std::vector<bool>(P.size(1), false));
    conditions.everywhere = BoundaryCondition::essential;
    EXPECT_EQ(essential_cells(P, conditions, Side::primal, 0)[1], boundary_cells(P)[1]);
    for (const auto& refused : {refusal([&] { essential_cells(P, conditions, Side::primal, 1); }),
                                refusal([&] { essential_cells(P, conditions, Side::dual, 0); }),
                                refusal([&] { essential_cells(P, conditions); })})
        EXPECT_SAYS(refused, "vertices", "primal 0-forms");
}

TEST(BoundaryStars, beside_matrices_integrate_products_of_linear_functions) {
    for (const char* name : {"obtuse_planar", "obtuse_solid", "obtuse4"}) {
        const auto mesh = discretize(mesh_named(name), {.star = StarKind::galerkin});
        const int n = mesh.dimension();
        const Vector u = mesh.points().col(0);
        double expected = 0; // over a facet the area times ((sum u)^2 + sum u^2) / (n (n + 1))
        for (Index f = 0; f < mesh.input().size(n - 1); ++f)
            if (mesh.input().coface_counts(n - 1)[f] == 1) {
                const Vector values = u(mesh.input().simplices(n - 1).row(f));
                expected += mesh.input_geometry().volumes().primal(n - 1)[f] *
                            (std::pow(values.sum(), 2) + values.squaredNorm()) / (n * (n + 1));
            }
        const Vector ones = Vector::Ones(mesh.complex().size(n - 1));
        EXPECT_NEAR(u.dot(mesh.boundary_star(0, ones) * u) / expected, 1, 1e-12) << name;
    }
}

TEST(BoundaryConditions, refuse_an_empty_predicate) {
    EXPECT_REFUSED(essential_where(Points::Zero(0, 2), {}), "predicate", "empty", "function");
}

TEST(BoundaryStars, refuse_weights_that_are_not_finite) {
    const auto mesh = circumcentric(mesh_named("grid4"));
    for (const double none : {NAN, INFINITY}) {
        Vector weights = Vector::Ones(mesh.complex().size(1));
        weights[0] = none;
        for (const int k : {0, 1})
            EXPECT_REFUSED(mesh.boundary_star(k, weights), "weights of facets", "value 0");
    }
}

TEST(BranchingCells, have_no_dual_functions) {
    const auto mesh = circumcentric(mesh_named("branching"));
    const auto ask = [&](Side side, int degree) {
        return refusal([&] { FormSpace(mesh, side, degree); });
    };
    EXPECT_SAYS(ask(Side::dual, 0), "3 cells", "facet", "primal 0-forms");
    EXPECT_EQ(ask(Side::primal, 0), "accepted");
    EXPECT_EQ(ask(Side::primal, 2), "accepted");
}

} // namespace polydec::test::in_boundary_conditions
