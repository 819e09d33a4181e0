// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_conductivity {

/// What is merged is merged exactly, so that no edge left out has a weight.
const DiscretizeOptions merges[] = {{.criterion = MergeCriterion::none}, {.tolerance = 1e-12}};

/// Between 1/10 and 10, for each merged n-cell.
Vector random_conductivity(const Discretization& mesh, unsigned seed) {
    const Vector exponents = random_vector(mesh.complex().size(mesh.dimension()), seed);
    return exponents.unaryExpr([](double x) { return std::pow(10.0, x); });
}

/// That of every n-simplex.
Vector on_simplices(const Discretization& mesh, const Vector& conductivity) {
    const SparseMatrix pieces = mesh.merging().diamond(mesh.dimension()).cast<double>().cwiseAbs();
    return pieces.transpose() * conductivity;
}

/// star_1 of a simplex that is a mesh of its own, in the lexicographic order of its edges.
Vector star_of(const Points& all, const Simplices& simplex) {
    const SimplicialComplex alone(simplex);
    const Points points = vertex_points(alone, all);
    return star(circumcentric_volumes(alone, SimplexMetric(points)), 1).diagonal();
}

/// The matrix for 0-forms of the simplices, each alone in the world, added up.
DenseMatrix sum_over_simplices(const Discretization& mesh, const Vector& conductivity) {
    const auto& K = mesh.input();
    const int n = K.dimension();
    const SparseMatrix d = derivative(K, 0);
    DenseMatrix A = DenseMatrix::Zero(K.size(0), K.size(0));
    for (Index t = 0; t < K.size(n); ++t) {
        const Simplices corners = K.simplices(n).row(t);
        const Vector weights = conductivity[t] * star_of(mesh.points(), corners);
        Index edge = 0;
        for (int i = 0; i <= n; ++i)
            for (int j = i + 1; j <= n; ++j, ++edge) {
                const Index a = corners(0, i), b = corners(0, j);
                A(a, a) += weights[edge], A(b, b) += weights[edge];
                A(a, b) -= weights[edge], A(b, a) -= weights[edge];
            }
    }
    return A;
}

/// How far a random function is from the solution for the data that A says it has. Functions that
/// differ by a constant on a component without boundary are equal.
double error_of_solution(const Discretization& mesh, const Vector& conductivity,
                         const DenseMatrix& A) {
    const auto medium = with_conductivity(mesh, Side::primal, CellData::on_cells(conductivity));
    const Vector v = random_vector(mesh.complex().size(0), 17);
    const Vector f = (A * v).cwiseQuotient(star(mesh.volumes(), 0).diagonal());
    const Vector u = solved(PoissonSolver(functions(medium, Side::primal)), f, v).form.values;
    const SparseMatrix d = derivative(mesh.complex(), 0);
    return relative_difference(Vector(d * u), Vector(d * v));
}

/// The stiffness matrix of linear finite elements on triangles of the plane or in space.
DenseMatrix finite_elements(const Discretization& mesh, const Vector& conductivity) {
    const auto& K = mesh.input();
    DenseMatrix A = DenseMatrix::Zero(K.size(0), K.size(0));
    for (Index t = 0; t < K.size(2); ++t) {
        const auto corners = K.simplices(2).row(t);
        Points sides(3, mesh.points().cols());
        for (int i = 0; i < 3; ++i)
            sides.row(i) =
                mesh.points().row(corners[(i + 2) % 3]) - mesh.points().row(corners[(i + 1) % 3]);
        const DenseMatrix products = sides * sides.transpose();
        const double area =
            std::sqrt(products(0, 0) * products(1, 1) - std::pow(products(0, 1), 2)) / 2;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                A(corners[i], corners[j]) += conductivity[t] * products(i, j) / (4 * area);
    }
    return A;
}

class Conductivity : public OverMeshes {};

TEST_P(Conductivity, weighs_every_simplex_as_if_it_were_alone_and_triangles_as_finite_elements) {
    const Mesh& input = mesh_named(GetParam());
    for (const auto& merge : merges) {
        const auto mesh = circumcentric(input, merge);
        const Vector kappa = random_conductivity(mesh, 5), of_pieces = on_simplices(mesh, kappa);
        EXPECT_LE(error_of_solution(mesh, kappa, sum_over_simplices(mesh, of_pieces)), 1e-9)
            << int(merge.criterion);
        if (mesh.dimension() == 2) {
            EXPECT_LE(error_of_solution(mesh, kappa, finite_elements(mesh, of_pieces)), 1e-10)
                << int(merge.criterion);
        }
    }
}

POLYDEC_OVER_MESHES(Conductivity);

/// A trapezoid, two triangles on one circle, inside a ring of eight triangles.
Mesh trapezoid_in_ring() {
    return made_of({{0, 0}, {4, 0}, {3, 1}, {1, 1}, {-3, -4}, {7, -4}, {7, 5}, {-3, 5}},
                   {{0, 1, 2},
                    {0, 2, 3},
                    {0, 4, 1},
                    {4, 5, 1},
                    {1, 5, 2},
                    {5, 6, 2},
                    {2, 6, 3},
                    {6, 7, 3},
                    {3, 7, 0},
                    {7, 4, 0}});
}

/// 10 on the second triangle of the trapezoid, 1 elsewhere.
Vector conductive_half(const Discretization& mesh) {
    Vector kappa = Vector::Ones(mesh.complex().size(2));
    for (Index t = 0; t < kappa.size(); ++t)
        if (mesh.input().input_row(t) == 1)
            kappa[t] = 10;
    return kappa;
}

TEST(ConcyclicEdges, between_different_conductivities_conduct) {
    const auto mesh = circumcentric(trapezoid_in_ring(), {.criterion = MergeCriterion::none});
    const Vector kappa = conductive_half(mesh);
    const auto medium = with_conductivity(mesh, Side::primal, CellData::on_cells(kappa));
    const Vector u = solved(PoissonSolver(functions(medium, Side::primal)), Vector::Zero(8),
                            mesh.points().col(0).cwiseAbs2())
                         .form.values;
    // linear finite elements, by an independent program
    const Vector known{
        {21.946478616632547, 35.40093594432815, 31.920829238841744, 25.678205826116056}};
    EXPECT_CLOSE(Vector(u.head(4)), known, 1e-13);
}

/// Two triangles on the edge from (-1, 0) to (1, 0); the first is obtuse, so its circumcenter is on
/// the side of the other.
Mesh obtuse_beside_acute() {
    return made_of({{-1, 0}, {1, 0}, {0, 0.5}, {0, -4}}, {{0, 1, 2}, {0, 3, 1}});
}

TEST(DualFluxes, whose_resistances_cancel_are_refused_by_the_facet) {
    // the centers are at -3/4 and -15/8: parts of the dual -3/4 and 15/8
    const auto mesh = circumcentric(obtuse_beside_acute());
    const auto verdict = [&](double obtuse, double acute) {
        const Vector kappa{{obtuse, acute}};
        return refusal([&] {
            PoissonSolver(functions(with_conductivity(mesh, Side::dual, kappa), Side::dual));
        });
    };
    EXPECT_EQ(verdict(1, 1), "accepted");
    EXPECT_EQ(verdict(1, 2.4), "accepted");
    for (const double size : {1e-9, 1.0, 1e9})
        EXPECT_SAYS(verdict(0.4 * size, size), "facet 0", "vertices 0, 1", "conductivity",
                    "cancel");
}

TEST(ConcyclicEdgesBroken, that_are_left_out_give_another_solution) {
    const Mesh input = trapezoid_in_ring();
    const auto mesh = circumcentric(input, {.criterion = MergeCriterion::none});
    const Vector kappa = conductive_half(mesh);
    DenseMatrix A = finite_elements(mesh, kappa);
    EXPECT_LE(error_of_solution(mesh, kappa, A), 1e-12);
    A(0, 0) += A(0, 2), A(2, 2) += A(0, 2), A(0, 2) = A(2, 0) = 0;
    EXPECT_GT(error_of_solution(mesh, kappa, A), 0.01);
}

} // namespace polydec::test::in_conductivity
