// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_length_mesh {

class LengthMeshes : public OverMeshes {
protected:
    /// With one more coordinate: a complex that may be curved, as one of lengths may. There angles
    /// say whether facets lie in one plane, and faces of lower degree are not asked.
    Discretization with_points() const {
        Mesh mesh = mesh_named(GetParam());
        mesh.points.conservativeResize(Eigen::NoChange, mesh.points.cols() + 1);
        mesh.points.rightCols(1).setZero();
        return discretize(mesh, {MergeCriterion::dual_length, tolerance});
    }

    Discretization bundle() const {
        return discretize(length_mesh(mesh_named(GetParam())),
                          {MergeCriterion::dual_length, tolerance});
    }
};

TEST_P(LengthMeshes, are_made_ready_for_calculus_as_curved_meshes_with_points_are) {
    const auto ours = bundle();
    const auto theirs = with_points();
    EXPECT_EQ(ours.points().rows(), theirs.points().rows());
    EXPECT_EQ(ours.points().cols(), 0);
    EXPECT_EQ(ours.lengths().size(), ours.input().size(1));
    EXPECT_EQ(theirs.lengths().size(), 0);
    for (int k = 0; k <= theirs.dimension(); ++k) {
        EXPECT_TRUE(
            equal(integers(ours.merging().diamond(k)), integers(theirs.merging().diamond(k))));
        EXPECT_CLOSE(ours.volumes().primal(k), theirs.volumes().primal(k), 1e-10);
        EXPECT_CLOSE(ours.volumes().dual(k), theirs.volumes().dual(k), 1e-10);
    }
    EXPECT_EQ(ours.degenerate().interior, theirs.degenerate().interior);
    EXPECT_EQ(ours.degenerate().boundary, theirs.degenerate().boundary);
    EXPECT_EQ(ours.warnings(), theirs.warnings());
}

TEST_P(LengthMeshes, know_which_operators_make_sense) {
    for (const auto stage : {Stage::input, Stage::merged}) {
        const auto ours = operator_verdicts(bundle(), stage);
        const auto theirs = operator_verdicts(with_points(), stage);
        ASSERT_EQ(ours.size(), theirs.size());
        for (std::size_t i = 0; i < ours.size(); ++i)
            EXPECT_EQ(ours[i].verdict, theirs[i].verdict) << ours[i].name;
    }
}

POLYDEC_OVER_MESHES(LengthMeshes);

LengthMesh two_triangles() {
    return length_mesh(made_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}));
}

TEST(LengthMesh, may_list_its_edges_in_any_order_and_direction) {
    const auto expected = discretize(two_triangles()).input_geometry().volumes();
    auto mesh = two_triangles();
    mesh.edges = mesh.edges.colwise().reverse().eval();
    mesh.lengths = mesh.lengths.reverse().eval();
    mesh.edges.col(0).swap(mesh.edges.col(1));
    const auto found = discretize(mesh).input_geometry().volumes();
    for (int k = 0; k <= 2; ++k) {
        EXPECT_EQ(found.primal(k), expected.primal(k));
        EXPECT_EQ(found.dual(k), expected.dual(k));
    }
    mesh.lengths.reverseInPlace();
    EXPECT_NE(discretize(mesh).input_geometry().volumes().primal(1), expected.primal(1));
}

TEST(LengthMesh, has_every_edge_exactly_once) {
    const auto refused = [](const auto& change) {
        auto mesh = two_triangles();
        change(mesh);
        return refusal([&] { discretize(mesh); });
    };
    EXPECT_EQ(refused([](LengthMesh&) {}), "accepted");
    EXPECT_SAYS(refused([](LengthMesh& m) { m.edges.row(3) << 2, 0; }), "edges 1", "3",
                "vertices 0", "2");
    EXPECT_SAYS(refused([](LengthMesh& m) { m.edges.row(4) << 3, 1; }), "edge 4", "vertices 1", "3",
                "simplex");
    EXPECT_SAYS(refused([](LengthMesh& m) {
                    m.edges.conservativeResize(4, 2);
                    m.lengths.conservativeResize(4);
                }),
                "edge", "vertices 2", "3", "length");
    EXPECT_SAYS(refused([](LengthMesh& m) { m.lengths.conservativeResize(4); }), "4 lengths",
                "5 x 2", "edges");
    EXPECT_SAYS(refused([](LengthMesh& m) { m.simplices.resize(0, 3); }), "0 simplices",
                "3 vertices");
    EXPECT_SAYS(refused([](LengthMesh& m) { m.edges(2, 0) = 4; }), "edge 2", "vertex 4", "0", "3");
    EXPECT_SAYS(refused([](LengthMesh& m) { m.simplices(1, 2) = -1; }), "simplex 1", "vertex -1",
                "0", "3");
    EXPECT_SAYS(refused([](LengthMesh& m) { m.lengths[1] = 2.5; }), "2-simplex 0",
                "vertices 0, 1, 2", "triangle inequality", "2.5", "1", "1");
}

TEST(LengthMesh, has_products_that_need_no_points) {
    const auto mesh = discretize(two_triangles());
    const Cochain a{Side::primal, 1, random_vector(mesh.complex().size(1), 1)};
    const auto& theirs =
        discretize(made_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}));
    for (const auto weights : {WedgeWeights::uniform, WedgeWeights::circumcentric})
        EXPECT_WITHIN(wedge(mesh, a, a, weights).values, wedge(theirs, a, a, weights).values,
                      1e-14);
}

TEST(LengthMesh, says_what_needs_points) {
    const auto mesh = discretize(two_triangles());
    const auto& P = mesh.complex();
    const auto& K = mesh.input();
    const auto one = function_form([](const Vector&) { return 1.0; });
    const Cochain edges{Side::primal, 1, Vector::Ones(P.size(1))};
    const DenseMatrix none(mesh.points().rows(), 0);
    const auto needs = [](const std::string& what) {
        return Words{"lengths", what, "needs points"};
    };
    EXPECT_REFUSED(de_rham(mesh, 0, one), needs("de Rham map"));
    EXPECT_REFUSED(dual_de_rham(mesh, 0, one), needs("de Rham map"));
    for (const auto kind : {Flat::ppp, Flat::pdp, Flat::dpp, Flat::ppd, Flat::pdd, Flat::dpd})
        EXPECT_REFUSED(flat(mesh, kind, none), needs("flat"));
    EXPECT_REFUSED(sharp_pp(mesh, edges), needs("sharp"));
    EXPECT_REFUSED(sharp_pd(mesh, edges), needs("sharp"));
    EXPECT_REFUSED(flux_sharp(mesh, edges), needs("sharp"));
    EXPECT_REFUSED(cell_centroids(mesh, 2), needs("cell's centroid"));
    EXPECT_REFUSED(interior_product(mesh, Points(none), 1, Sampling::centered),
                   needs("vector field"));
    EXPECT_REFUSED(
        whitney_at_centroids(K, mesh.points(), {Side::primal, 1, Vector::Ones(K.size(1))}),
        needs("Whitney form"));
    EXPECT_EQ(cell_centers(mesh, 2).rows(), P.size(2));
    EXPECT_EQ(cell_centers(mesh, 2).cols(), 0);
}

} // namespace polydec::test::in_length_mesh
