// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_flat {

constexpr double rounding = 1e-12;
const std::vector<Flat> primal_kinds = {Flat::ppp, Flat::pdp, Flat::dpp};
const std::vector<Flat> dual_kinds = {Flat::ppd, Flat::pdd, Flat::dpd};

/// A field sampled where the flat wants it: at the points or at the circumcenters of merged cells.
DenseMatrix sampled(const Discretization& mesh, Flat kind, const SmoothForm& field) {
    return test::sampled(is_at_cells(kind) ? cell_centers(mesh, mesh.dimension()) : mesh.points(),
                         field);
}

class Flats : public OverMeshes {};

/// By how much rounding grows where the parts of an edge's dual nearly cancel.
double amplification(const Discretization& mesh) {
    const SparseMatrix parts = dual_parts(mesh.geometry(), {}, 1, mesh.dimension());
    const Vector sizes = parts.cwiseAbs().transpose() * Vector::Ones(parts.rows());
    double result = 1;
    for (Index e = 0; e < sizes.size(); ++e)
        if (mesh.merging().carriers(1)[e].dimension == 1)
            result = std::max(result, sizes[e] / std::abs(mesh.geometry().volumes().dual(1)[e]));
    return result;
}

TEST_P(Flats, of_constant_fields_on_edges_are_their_circulations) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const SmoothForm X = random_constant(mesh);
        const Vector exact = de_rham(mesh, 1, circulation_form(X)).values;
        for (const Flat kind : primal_kinds) {
            if (kind == Flat::dpp && !star(mesh.volumes(), 1).zeros().empty()) {
                EXPECT_THROW(flat(mesh, kind, sampled(mesh, kind, X)), InvalidInput);
                continue;
            }
            const Cochain form = flat(mesh, kind, sampled(mesh, kind, X));
            EXPECT_EQ(form.side, Side::primal);
            EXPECT_EQ(form.degree, 1);
            const bool is_flipped = !mesh.passage().is_identity();
            const double bound = is_flipped ? 1e-11 : rounding;
            EXPECT_CLOSE(form.values, exact,
                         kind != Flat::dpp ? bound
                         : is_flipped      ? 1e-9
                                           : rounding * amplification(mesh))
                << int(kind);
        }
    });
}

TEST_P(Flats, of_constant_fields_on_dual_edges_are_their_circulations) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const SmoothForm X = random_constant(mesh);
        const Vector exact = dual_de_rham(mesh, 1, circulation_form(X)).values;
        for (const Flat kind : dual_kinds) {
            const Cochain form = flat(mesh, kind, sampled(mesh, kind, X));
            EXPECT_EQ(form.side, Side::dual);
            EXPECT_EQ(form.degree, 1);
            EXPECT_CLOSE(form.values, exact, allowed_rounding(mesh)) << int(kind);
        }
    });
}

TEST_P(Flats, of_linear_fields_at_vertices_are_exact) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const SmoothForm X = linear_field(space(mesh), 3);
        EXPECT_CLOSE(flat(mesh, Flat::ppp, sampled(mesh, Flat::ppp, X)).values,
                     de_rham(mesh, 1, circulation_form(X)).values, allowed_rounding(mesh));
        EXPECT_CLOSE(flat(mesh, Flat::ppd, sampled(mesh, Flat::ppd, X)).values,
                     dual_de_rham(mesh, 1, circulation_form(X)).values, allowed_rounding(mesh));
    });
}

TEST_P(Flats, ppp_and_pdp_are_one) {
    const auto& mesh = discretized(GetParam());
    const DenseMatrix field = random_field(mesh, 9);
    EXPECT_EQ(relative_difference(flat(mesh, Flat::pdp, field).values,
                                  flat(mesh, Flat::ppp, field).values),
              0);
}

POLYDEC_OVER_MESHES(Flats);

/// The same values on facets between two cells, and 0 on the boundary.
Vector inside(const Discretization& mesh, Vector values) {
    for (Index f = 0; f < values.size(); ++f)
        if (mesh.complex().coface_counts(mesh.dimension() - 1)[f] != 2)
            values[f] = 0;
    return values;
}

/// How far a dual flat of a linear field is from its circulation, between cells.
double linear_defect(const Discretization& mesh, Flat kind) {
    const SmoothForm X = linear_field(space(mesh), 3);
    return relative_difference(inside(mesh, flat(mesh, kind, sampled(mesh, kind, X)).values),
                               inside(mesh, dual_de_rham(mesh, 1, circulation_form(X)).values));
}

const std::vector<std::string> equal_boxes = {"segments4", "grid4", "rectangles", "boxes",
                                              "kuhn3",     "kuhn4", "tesseracts2"};

TEST(FlatsOnBoxes, are_exact_for_linear_fields_on_dual_edges_inside) {
    for (const auto& name : equal_boxes)
        for (const Flat kind : dual_kinds)
            EXPECT_LE(linear_defect(discretized(name), kind), rounding) << name << int(kind);
}

TEST(FlatsOnBoxes, of_a_field_that_jumps_between_boxes_are_its_circulations_on_dual_edges) {
    for (const auto& name : equal_boxes) {
        const auto& mesh = discretized(name);
        const auto n = mesh.dimension();
        const Points centers = cell_centers(mesh, n);
        const DenseMatrix field = random_matrix(static_cast<Index>(centers.rows()), n, 2);
        const auto of_box = [&](const Vector& x) {
            Index nearest = 0;
            (centers.rowwise() - x.transpose()).rowwise().norm().minCoeff(&nearest);
            return Vector(field.row(nearest));
        };
        EXPECT_CLOSE(flat(mesh, Flat::dpd, field).values,
                     dual_de_rham(mesh, 1, circulation_form(of_box)).values, rounding)
            << name;
    }
}

TEST(FlatsBroken, piecewise_constants_are_not_exact_for_linear_fields_on_other_meshes) {
    for (const auto& name : {"obtuse_planar", "obtuse_solid", "obtuse4"})
        for (const Flat kind : {Flat::pdd, Flat::dpd})
            EXPECT_GT(linear_defect(discretized(name), kind), 1e-3) << name << int(kind);
}

TEST(FlatsBroken, unmerged_squares_have_no_dpp) {
    const auto& mesh = discretized("grid4", MergeCriterion::none);
    EXPECT_REFUSED(flat(mesh, Flat::dpp, DenseMatrix::Ones(32, 2)), "dpp flat", "zero",
                   "vertices 0, 6", "16");
}

/// Duals are means over the pieces, whose volumes these are not.
TEST(FlatsToDualForms, do_not_depend_on_the_volumes_of_merged_cells) {
    const auto& mesh = discretized("grid4");
    std::vector<Vector> primal, dual;
    for (int k = 0; k <= 2; ++k) {
        primal.push_back((k == 1 ? 2 : 1) * mesh.volumes().primal(k));
        dual.push_back(mesh.volumes().dual(k));
    }
    const auto own = mesh.with_volumes(CellVolumes(primal, dual));
    const SmoothForm field = linear_field(2, 3);
    const auto expect_same = [](const Cochain& of_own, const Cochain& of_mesh) {
        EXPECT_EQ(of_own.values, of_mesh.values);
        EXPECT_GT(relative_difference(of_own.values, of_mesh.values / 2), 0.1);
    };
    for (const auto kind : dual_kinds)
        expect_same(flat(own, kind, sampled(mesh, kind, field)),
                    flat(mesh, kind, sampled(mesh, kind, field)));
    expect_same(dual_de_rham(own, 1, field), dual_de_rham(mesh, 1, field));
}

TEST(FlatsToDualForms, of_constants_have_their_norm_where_stars_are_matrices) {
    for (const char* name : {"obtuse_planar", "wellcentred4", "obtuse_solid"}) {
        const auto mesh = discretize(mesh_named(name), {.star = StarKind::galerkin});
        const SmoothForm field = random_constant(mesh);
        const double volume = mesh.volumes().primal(mesh.dimension()).sum();
        for (const auto kind : dual_kinds) {
            const Cochain form = flat(mesh, kind, sampled(mesh, kind, field));
            const double expected = std::sqrt(volume) * field(Vector()).norm();
            EXPECT_NEAR(norm(mesh, form) / expected, 1, rounding) << name << ' ' << int(kind);
        }
    }
}

TEST(FlatsRefuse, fields_of_the_wrong_shape_and_what_is_not_finite) {
    const auto& mesh = discretized("grid4");
    EXPECT_REFUSED(flat(mesh, Flat::ppp, DenseMatrix::Ones(16, 2)), "field", "16 x 2", "25 x 2",
                   "vertex");
    EXPECT_REFUSED(flat(mesh, Flat::dpd, DenseMatrix::Ones(25, 2)), "field", "25 x 2", "16 x 2",
                   "merged cell");
    DenseMatrix field = DenseMatrix::Ones(25, 2);
    field(7, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_REFUSED(flat(mesh, Flat::pdd, field), "vector", "vertex 7", "finite");
    const auto& sparse = discretized("with_isolated_vertices");
    const auto rows = sparse.points().rows(), unused = sparse.isolated().rows();
    ASSERT_GT(unused, 0);
    EXPECT_TRUE(flat(sparse, Flat::ppp, DenseMatrix::Ones(rows, 2)).values.allFinite());
    EXPECT_THROW(flat(sparse, Flat::ppp, DenseMatrix::Ones(rows + unused, 2)), InvalidInput);
}

} // namespace polydec::test::in_flat
