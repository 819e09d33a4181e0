// SPDX-License-Identifier: MIT
#include "tests/support/diamond.h"
#include "tests/support/test.h"

namespace polydec::test::in_seams {

/// A mesh of cubes whose seams turn, and a function sum c_i (x_i - m_i)^2 / 2 that the gluing
/// preserves.
struct Turned {
    std::string name;
    PeriodicMesh glued;
    Vector c, m;
    Discretization mesh = circumcentric(glued);

    double at(const Vector& x) const { return c.dot((x - m).cwiseAbs2()) / 2; }
    Vector gradient_at(const Vector& x) const { return c.cwiseProduct(x - m); }
};

Mesh moved(Mesh mesh, const Vector& by) {
    mesh.points.rowwise() += by.transpose();
    return mesh;
}

const std::vector<Turned>& samples() {
    static const std::vector<Turned> all{
        {"Moebius strip", glue(grid(6, 4), {[](const Vector& x) {
                                   return Vector{{x[0] + 1, 1 - x[1]}};
                               }}),
         Vector{{0, 2}}, Vector{{0, 0.5}}},
        {"cone", glue(moved(grid(8, 4, 2, 1), Vector{{-1, 0}}), {[](const Vector& x) {
                          return Vector(-x);
                      }}),
         Vector{{1, 1}}, Vector{{0, 0}}},
        {"crosscap", glue(grid(12, 4, 2, 1), {[](const Vector& x) {
                              return Vector{{x[0] + 1, -x[1]}};
                          }}),
         Vector{{0, 1}}, Vector{{0, 0}}},
        {"half turn", glue(kuhn(3, 4), {[](const Vector& x) {
                               return Vector{{1 - x[0], 1 - x[1], x[2] + 1}};
                           }}),
         Vector{{1, 2, 0}}, Vector{{0.5, 0.5, 0}}}};
    return all;
}

/// A rhombus made of squares. A glide reflection glues two of its sides, and cuts squares there.
PeriodicMesh cut_squares(int m) {
    return glue(diamond(m).box, {[m](const Vector& x) { return Vector{{x[1] - m, x[0] - m}}; }});
}

/// Both are exact for these functions, because the middles of edges and cells agree along an edge.
TEST(Seams, turn_vectors_of_cells_with_their_cells) {
    for (const Turned& sample : samples()) {
        const Discretization& mesh = sample.mesh;
        const int n = mesh.dimension();
        Cochain q{Side::primal, 0, Vector(mesh.complex().size(0))};
        const Points places = cell_centers(mesh, 0), cells = cell_centroids(mesh, n);
        for (Index v = 0; v < places.rows(); ++v)
            q.values[v] = sample.at(places.row(v).transpose());
        DenseMatrix gradients(cells.rows(), n);
        for (Index cell = 0; cell < cells.rows(); ++cell)
            gradients.row(cell) = sample.gradient_at(cells.row(cell).transpose()).transpose();
        const Cochain dq = d(mesh.complex(), q);
        EXPECT_WITHIN(sharp_pd(mesh, dq), gradients, 1e-12) << sample.name;
        EXPECT_WITHIN(flat(mesh, Flat::dpp, gradients).values, dq.values, 1e-12) << sample.name;
    }
}

TEST(Seams, that_turn_leave_no_vectors_at_vertices) {
    for (const Turned& sample : samples()) {
        const Discretization& mesh = sample.mesh;
        const int n = mesh.dimension();
        const Points field = Points::Zero(mesh.complex().size(0), n);
        const Cochain a{Side::primal, 1, Vector::Zero(mesh.complex().size(1))};
        for (const auto kind : {Flat::ppp, Flat::pdp, Flat::ppd, Flat::pdd})
            EXPECT_REFUSED(flat(mesh, kind, field), "a flat", "seams turn", "vertex");
        EXPECT_REFUSED(sharp_pp(mesh, a), "sharp", "seams turn", "at the cells");
        const DenseMatrix at_cells = DenseMatrix::Zero(mesh.complex().size(n), n);
        EXPECT_REFUSED(means_at_vertices(mesh, at_cells), "vectors", "seams turn");
        for (const auto sampling : {Sampling::centered, Sampling::upwind}) {
            EXPECT_REFUSED(interior_product(mesh, field, 1, sampling), "field", "seams turn");
            EXPECT_REFUSED(lie_derivative(mesh, field, 1, sampling), "field", "seams turn");
            EXPECT_REFUSED(LieDerivative(mesh, 1, sampling), "field", "seams turn");
        }
        EXPECT_REFUSED(inflow(mesh, field, 1), "field", "seams turn");
    }
}

TEST(Seams, that_turn_leave_no_vectors_of_cells_that_they_cut) {
    const auto mesh = circumcentric(cut_squares(4));
    const DenseMatrix vectors = DenseMatrix::Zero(mesh.complex().size(2), 2);
    const Cochain a{Side::primal, 1, Vector::Zero(mesh.complex().size(1))};
    EXPECT_REFUSED(sharp_pd(mesh, a), "sharp to cells", "seam that turns");
    EXPECT_REFUSED(flux_sharp(mesh, a), "fluxes", "merged cell");
    EXPECT_REFUSED(flat(mesh, Flat::dpp, vectors), "a flat", "seam that turns");
    EXPECT_REFUSED(flat(mesh, Flat::dpd, vectors), "a flat", "seam that turns");
    EXPECT_REFUSED(streamlines(mesh, vectors), "streamline", "seam that turns");
    const auto apart = discretize(cut_squares(4), {.criterion = MergeCriterion::none});
    EXPECT_EQ(flux_sharp(apart, {Side::primal, 1, Vector::Zero(apart.complex().size(1))}).rows(),
              apart.complex().size(2));
}

} // namespace polydec::test::in_seams
