// SPDX-License-Identifier: MIT
#include "dec/merging/facet_defects.h"
#include "tests/support/test.h"

namespace polydec::test::in_merge {

class Merges : public OverMeshes {};

TEST_P(Merges, leave_no_degenerate_facet_between_two_cells_unless_it_is_glued_to_itself) {
    const int n = mesh().n();
    const auto defects = facet_defects(mesh().geometry(), {MergeCriterion::dual_length, tolerance});
    for (Index f = 0; f < mesh().K().size(n - 1); ++f) {
        const auto& carrier = mesh().merging().carriers(n - 1)[f];
        if (defects.degenerate[f] && mesh().K().coface_counts(n - 1)[f] == 2) {
            EXPECT_EQ(carrier.dimension, n) << "facet " << f;
        }
    }
}

TEST_P(Merges, remove_degenerate_facets_alone) {
    const int n = mesh().n();
    const auto defects = facet_defects(mesh().geometry(), {MergeCriterion::dual_length, tolerance});
    for (Index f = 0; f < mesh().K().size(n - 1); ++f)
        if (mesh().merging().carriers(n - 1)[f].dimension == n) {
            EXPECT_EQ(mesh().K().coface_counts(n - 1)[f], 2);
            EXPECT_LE(defects.ratio(f), 10 * tolerance);
        }
}

TEST(FacetDefects, miss_no_facet_within_the_tolerance) {
    constexpr double wide = 1e-4;
    for (const Mesh& mesh : {perturbed(kuhn(2, 8), 1e-5, 1), perturbed(kuhn(3, 4), 1e-5, 2),
                             perturbed(kuhn(4, 2), 3e-5, 3), perturbed(torus(12, 6), 1e-5, 4)}) {
        const SimplicialComplex K(mesh.simplices);
        const int n = K.dimension();
        const Geometry geometry(K, mesh.points);
        const auto& volumes = geometry.volumes();
        const auto defects = facet_defects(geometry, {MergeCriterion::dual_length, wide});
        const Vector sizes = 2 * circumradii(K, mesh.points, n - 1);
        const Cofaces cofaces(K, n);
        Index inexact = 0;
        for (Index f = 0; f < K.size(n - 1); ++f) {
            const double dual = volumes.dual(n - 1)[f], terms = volumes.terms(n - 1)[f];
            bool expected = true;
            for (const Coface& t : cofaces.of(f))
                expected =
                    expected &&
                    is_degenerate(dual, terms, sizes[f],
                                  n * volumes.primal(n)[t.cell] / volumes.primal(n - 1)[f], wide);
            EXPECT_EQ(defects.degenerate[f], expected) << n << ", facet " << f;
            EXPECT_EQ(defects.ratio(f), defects.defect[f] / sizes[f]);
            inexact += expected && defects.defect[f] > 0 ? 1 : 0;
        }
        EXPECT_GT(inexact, 0);
    }
}

TEST_P(Merges, never_remove_vertices) {
    for (const auto& carrier : mesh().merging().carriers(0))
        EXPECT_EQ(carrier.dimension, 0);
}

TEST_P(Merges, never_remove_what_lies_on_the_boundary_or_branches_but_to_unite_it) {
    // a boundary or branching simplex ends up in a boundary or branching cell of its own facet's
    const int n = mesh().n();
    for (Index f = 0; f < mesh().K().size(n - 1); ++f)
        if (mesh().K().coface_counts(n - 1)[f] != 2) {
            EXPECT_EQ(mesh().merging().carriers(n - 1)[f].dimension, n - 1);
        }
}

TEST_P(Merges, count_degenerate_facets_by_their_cofaces) {
    const int n = mesh().n();
    const auto defects = facet_defects(mesh().geometry(), {MergeCriterion::dual_length, tolerance});
    DegenerateFacets expected;
    for (Index f = 0; f < mesh().K().size(n - 1); ++f)
        if (defects.degenerate[f]) {
            const Index cofaces = mesh().K().coface_counts(n - 1)[f];
            ++(cofaces == 1   ? expected.boundary
               : cofaces == 2 ? expected.interior
                              : expected.branching);
        }
    const auto& found = mesh().result.degenerate;
    EXPECT_EQ(found.boundary, expected.boundary);
    EXPECT_EQ(found.interior, expected.interior);
    EXPECT_EQ(found.branching, expected.branching);
}

TEST_P(Merges, with_criterion_none_leave_the_simplices_but_count) {
    const auto left = make_merged(mesh_named(GetParam()), {MergeCriterion::none, tolerance});
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_EQ(left.P().size(k), mesh().K().size(k));
    EXPECT_EQ(left.result.degenerate.interior, mesh().result.degenerate.interior);
}

TEST_P(Merges, by_angle_find_the_same_cells_on_exact_input) {
    // a radian is about as much as a relative dual length where cells are not flat
    if (GetParam() == "almost_squares")
        return;
    const auto angle = make_merged(mesh_named(GetParam()), {MergeCriterion::angle, tolerance});
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_EQ(angle.P().size(k), mesh().P().size(k)) << "k = " << k;
}

POLYDEC_OVER_MESHES(Merges);

TEST(Merge, finds_squares_perturbed_less_than_the_tolerance_and_no_others) {
    const Mesh mesh = mesh_named("almost_squares");
    EXPECT_EQ(make_merged(mesh, {MergeCriterion::dual_length, 1e-4}).P().size(2), 16);
    EXPECT_GT(make_merged(mesh, {MergeCriterion::dual_length, 1e-8}).P().size(2), 28);
}

TEST(Merge, default_tolerance_finds_cubes_with_six_digits) {
    Mesh mesh = kuhn(3, 3);
    mesh.points = (1e6 * mesh.points.array()).round() * 1e-6;
    EXPECT_EQ(make_merged(mesh, MergeOptions{}).P().size(3), 27);
}

TEST(Merge, never_crosses_branching_facets_even_if_their_dual_is_zero) {
    // three right isosceles triangles with the hypotenuse in common
    const Mesh book = made_of(
        {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -0.5, std::sqrt(0.75)}, {0, -0.5, -std::sqrt(0.75)}},
        {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    const auto mesh = make_merged(book);
    EXPECT_EQ(mesh.P().size(2), 3);
    EXPECT_EQ(mesh.result.degenerate.branching, 1);
    EXPECT_EQ(mesh.result.degenerate.interior, 0);

    Mesh rectangle = book;
    rectangle.simplices.conservativeResize(2, Eigen::NoChange);
    EXPECT_EQ(make_merged(rectangle).P().size(2), 1) << "two of them do merge";
}

TEST(MergeByAngle, misfires_on_slivers_whose_dual_edge_is_long) {
    // apexes above and below an edge, one of angle pi - a, the other of angle a + 1e-5
    const double small = 2e-3;
    const double half_width = 0.5, far = half_width / std::tan((small + 1e-5) / 2),
                 near = half_width * std::tan(small / 2);
    const Mesh mesh =
        made_of({{-half_width, 0}, {half_width, 0}, {0, far}, {0, -near}}, {{0, 1, 2}, {1, 0, 3}});
    const auto angle = make_merged(mesh, {MergeCriterion::angle, 1e-4});
    const auto length = make_merged(mesh, {MergeCriterion::dual_length, 1e-4});
    EXPECT_EQ(angle.P().size(2), 1);
    EXPECT_EQ(length.P().size(2), 2);
    EXPECT_GT(std::abs(star(length.volumes, 1).diagonal().cwiseAbs().maxCoeff()), 1);
}

TEST(MergeTolerance, must_be_a_number_that_is_not_negative) {
    const auto refused = [](double value) {
        return refusal([&] {
            make_merged(mesh_named("grid4"), {MergeCriterion::dual_length, value});
        });
    };
    EXPECT_SAYS(refused(-1), "merge tolerance", "-1");
    EXPECT_SAYS(refused(std::numeric_limits<double>::quiet_NaN()), "merge tolerance", "nan");
    EXPECT_SAYS(refused(std::numeric_limits<double>::infinity()), "merge tolerance", "inf");
    EXPECT_EQ(refused(0), "accepted");
}

TEST(MergeTolerance, of_zero_still_merges_what_is_exact_to_rounding) {
    EXPECT_EQ(make_merged(kuhn(3, 3), {MergeCriterion::dual_length, 0}).P().size(3), 27);
}

} // namespace polydec::test::in_merge
