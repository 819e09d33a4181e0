// SPDX-License-Identifier: MIT
#include "complex/blocks.h"
#include "dec/merging/facet_defects.h"
#include "tests/support/test.h"

namespace polydec::test::in_guards {

/// Fine meshes under tolerances of angles so large that chains of almost concyclic pairs close
/// around a pole or a tube. By dual length, heights forbid it.
struct Accident {
    std::string name;
    Mesh mesh;
    double tolerance;
    std::vector<Index> betti;
};

void PrintTo(const Accident& accident, std::ostream* out) {
    *out << accident.name;
}

class Guards : public testing::TestWithParam<Accident> {
protected:
    Merged guarded() const {
        return make_merged(GetParam().mesh, {MergeCriterion::angle, GetParam().tolerance});
    }

    /// Joins whatever is degenerate, without looking at what comes of it.
    std::pair<SimplicialComplex, Blocks> unguarded() const {
        SimplicialComplex K(GetParam().mesh.simplices);
        const auto volumes = circumcentric_volumes(K, GetParam().mesh.points);
        const auto defects = facet_defects({K, GetParam().mesh.points, volumes},
                                           {MergeCriterion::angle, GetParam().tolerance});
        std::vector<bool> removed = defects.degenerate.marks;
        for (std::size_t f = 0; f < removed.size(); ++f)
            removed[f] = removed[f] && K.coface_counts(K.dimension() - 1)[f] == 2;
        auto blocks = join_blocks(K, removed, [](int, Index, Index, Index) { return true; });
        return {std::move(K), std::move(blocks)};
    }
};

/// Vertices that no kept edge reaches.
Index swallowed(const CellComplex& complex) {
    Index count = 0;
    for (const Index edges : complex.coface_counts(0))
        count += edges == 0;
    return count;
}

TEST_P(Guards, keep_the_topology) {
    const auto mesh = guarded();
    EXPECT_EQ(betti_numbers(mesh.K()), GetParam().betti);
    EXPECT_EQ(betti_numbers(mesh.P()), GetParam().betti);
    EXPECT_EQ(euler_characteristic(mesh.P()), euler_characteristic(mesh.K()));
}

TEST_P(Guards, keep_every_vertex_and_still_merge) {
    const auto mesh = guarded();
    EXPECT_EQ(swallowed(mesh.P()), 0);
    EXPECT_LT(mesh.P().size(2), mesh.K().size(2));
}

TEST_P(Guards, are_needed) {
    auto [K, blocks] = unguarded();
    EXPECT_FALSE(inadmissible_blocks(K, blocks).empty());
    const Merging merging(std::move(K), blocks);
    EXPECT_TRUE(swallowed(merging.merged()) > 0 ||
                betti_numbers(merging.merged()) != GetParam().betti);
}

TEST(GuardRounds, split_up_what_made_no_disc) {
    const auto mesh = make_merged(icosphere(6), {MergeCriterion::angle, 1.05});
    EXPECT_GT(mesh.result.rounds, 0);
}

TEST(GuardRounds, restore_every_facet_of_a_ring_that_is_cospherical_up_to_rounding) {
    bool any_defect = false;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const auto mesh = make_merged(shuffled(spherical_ring(), seed).mesh);
        EXPECT_EQ(mesh.P().size(3), mesh.K().size(3)) << seed;
        const auto defects = facet_defects(mesh.geometry(), {});
        any_defect =
            any_defect || (defects.defect.array() > 0 && defects.defect.array() < 1e-9).any();
    }
    EXPECT_TRUE(any_defect); // by rounding, in some orders
}

TEST(GuardRounds, keep_the_homology_of_cospherical_cells_around_a_handle_and_a_cavity) {
    const auto mesh = make_merged(handle_and_cavity());
    EXPECT_GT(mesh.result.rounds, 0);
    EXPECT_EQ(betti_numbers(mesh.P()), betti_numbers(mesh.K()));
}

INSTANTIATE_TEST_SUITE_P(
    Accidents, Guards,
    testing::Values(Accident{"sphere_with_64_meridians", uv_sphere(64, 32), 0.24, {1, 0, 1}},
                    Accident{"sphere_with_many_bands", uv_sphere(64, 200), 0.24, {1, 0, 1}},
                    Accident{"icosphere", icosphere(6), 1.05, {1, 0, 1}},
                    Accident{"thin_torus", torus(100, 6), 0.4, {1, 2, 1}}),
    [](const auto& instance) { return instance.param.name; });

} // namespace polydec::test::in_guards
