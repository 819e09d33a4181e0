// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_form_space {

/// Essential, natural, and both: on every second facet.
std::vector<BoundaryConditions> conditions_on(const CellComplex& complex) {
    BoundaryConditions mixed{BoundaryCondition::natural};
    for (Index f = 0; f < complex.size(complex.dimension() - 1); ++f)
        mixed.facets.push_back(f % 2 == 0 ? BoundaryCondition::essential
                                          : BoundaryCondition::natural);
    return {{BoundaryCondition::essential}, {BoundaryCondition::natural}, mixed};
}

class FormSpaces : public OverMeshes {
protected:
    /// Calls law(space) for every side, degree and condition that the cells have forms for.
    template <class Law>
    void for_all(Law law) const {
        const Cells cells(mesh().P(), mesh().volumes);
        for (const Side side : {Side::primal, Side::dual})
            for (int degree = 0; degree <= mesh().n(); ++degree)
                for (const auto& conditions : conditions_on(mesh().P())) {
                    SCOPED_TRACE(name(side) + std::to_string(degree));
                    if (refusal([&] { FormSpace(cells, side, degree, conditions); }) == "accepted")
                        law(FormSpace(cells, side, degree, conditions));
                }
    }
};

TEST_P(FormSpaces, fix_some_values_and_leave_the_others_free) {
    for_all([](const FormSpace& space) {
        const int k = space.cell_degree();
        const Index size = space.cells().complex().size(k);
        const Vector all = random_vector(size, 1);
        const Vector kept = space.extend(space.restrict(all));
        const std::set<Index> free(space.free().begin(), space.free().end());
        ASSERT_EQ(std::ssize(free), space.size());
        for (Index cell = 0; cell < size; ++cell) {
            EXPECT_EQ(kept[cell], free.contains(cell) ? all[cell] : 0);
            EXPECT_FALSE(free.contains(cell) && space.fixed()[k][cell]);
        }
    });
}

TEST_P(FormSpaces, have_cells_inside_that_are_a_complex) {
    for_all([](const FormSpace& space) {
        const Cells inside = space.inside();
        EXPECT_EQ(inside.complex().size(space.cell_degree()), space.size());
        for (int k = 0; k + 1 < inside.dimension(); ++k) {
            const IncidenceMatrix twice =
                inside.complex().coboundary(k + 1) * inside.complex().coboundary(k);
            EXPECT_EQ(twice.cast<int>().cwiseAbs().sum(), 0) << k;
        }
    });
}

TEST_P(FormSpaces, of_all_forms_share_the_cells) {
    const Cells cells(mesh().P(), mesh().volumes);
    for (int k = 0; k <= mesh().n(); ++k) {
        const auto space = FormSpace::vanishing_on(cells, Side::primal, k);
        EXPECT_EQ(space.size(), mesh().P().size(k));
        EXPECT_EQ(&space.relative().complex.coface_counts(0), &mesh().P().coface_counts(0));
    }
}

TEST_P(FormSpaces, of_functions_have_the_stiffness_of_their_free_vertices) {
    const Cells cells(mesh().P(), mesh().volumes);
    const SparseMatrix whole = symmetric_laplacian(cells, 0);
    for (const auto& conditions : conditions_on(mesh().P())) {
        const FormSpace space(cells, Side::primal, 0, conditions);
        const SparseMatrix P = inclusion(space.free(), mesh().P().size(0));
        EXPECT_CLOSE(space.stiffness().matrix(), SparseMatrix(P.transpose() * whole * P), 1e-14);
    }
}

POLYDEC_OVER_MESHES(FormSpaces);

TEST(FormSpace, has_what_robins_condition_adds_in_the_stiffness_or_in_the_star_below) {
    const auto mesh = circumcentric(mesh_named("grid4"));
    const BoundaryConditions robin{BoundaryCondition::robin, {}, {2.5}};
    const FormSpace primal(mesh, Side::primal, 0, robin), free(mesh, Side::primal, 0),
        dual(mesh, Side::dual, 0, robin);
    const Vector facets = Vector::Constant(mesh.complex().size(1), 2.5);
    EXPECT_EQ(primal.size(), mesh.complex().size(0));
    EXPECT_CLOSE(SparseMatrix(primal.stiffness().matrix() - free.stiffness().matrix()),
                 mesh.boundary_star(0, facets), 1e-12);
    EXPECT_EQ(primal.robin_layer().size() + dual.robin_weights().size(), 0);
    const Cells inside = dual.inside();
    EXPECT_CLOSE(SparseMatrix(inside.stars()[1].matrix() - mesh.stars()[1].matrix()),
                 mesh.boundary_star(1, facets.cwiseInverse()), 1e-12);
}

TEST(FormSpace, refuses_robins_condition_beside_negative_duals_by_name) {
    const BoundaryConditions robin{BoundaryCondition::robin, {}, {2.5}};
    const auto mesh = circumcentric(mesh_named("obtuse_planar"));
    const auto negative = star(mesh, 1).negatives();
    ASSERT_FALSE(negative.empty());
    const FormSpace space(mesh, Side::dual, 0, robin);
    EXPECT_REFUSED(space.inside(), "1-cells", "Robin", "duals have negative",
                   "StarKind::automatic");
    const auto positive = discretize(mesh_named("obtuse_planar"), {.star = StarKind::automatic});
    EXPECT_NO_THROW(FormSpace(positive, Side::dual, 0, robin).inside());
}

TEST(FormSpace, is_told_apart_by_cells_side_degree_conditions_and_what_is_fixed) {
    const auto mesh = circumcentric(mesh_named("grid4")), other = circumcentric(kuhn(2, 3));
    const BoundaryConditions essential{BoundaryCondition::essential};
    const std::vector<FormSpace> spaces{
        {mesh, Side::primal, 0},
        {other, Side::primal, 0},
        {mesh, Side::dual, 2, {BoundaryCondition::natural}},
        {mesh, Side::primal, 1},
        {mesh, Side::primal, 0, essential},
        FormSpace::vanishing_on(mesh, Side::primal, 0, boundary_cells(mesh.complex()))};
    std::set<std::uint64_t> values;
    for (const FormSpace& space : spaces)
        values.insert(Fingerprint().add(space).value());
    EXPECT_EQ(values.size(), spaces.size());
}

TEST(FormSpace, refuses_forms_and_conditions_of_others) {
    const auto mesh = circumcentric(mesh_named("grid4"));
    const FormSpace space(mesh, Side::primal, 1);
    const Index size = mesh.complex().size(1);
    EXPECT_REFUSED(space.check({Side::dual, 1, Vector::Zero(size)}), "dual 1-form",
                   "primal 1-form");
    EXPECT_THROW(space.check({Side::primal, 1, Vector::Zero(size - 1)}), InvalidInput);
    EXPECT_THROW(space.check({Side::primal, 1, Vector::Constant(size, NAN)}), InvalidInput);
    EXPECT_NO_THROW(space.check({Side::primal, 1, Vector::Zero(size)}));
    EXPECT_THROW(FormSpace(mesh, Side::primal, 3), InvalidInput);
    BoundaryConditions few;
    few.facets = {BoundaryCondition::natural};
    EXPECT_THROW(FormSpace(mesh, Side::primal, 0, few), InvalidInput);
    CellMarks open = boundary_cells(mesh.complex());
    open[0].assign(open[0].size(), false); // edges without their ends
    EXPECT_REFUSED(FormSpace::vanishing_on(mesh, Side::primal, 0, open).size(), "1-cell", "0-cell");
}

} // namespace polydec::test::in_form_space
