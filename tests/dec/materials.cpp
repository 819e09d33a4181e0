// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_materials {

const DiscretizeOptions apart{.tolerance = tolerance, .materials = Materials::keep_apart};

/// The mesh with one of some tags on each simplex, at random.
Mesh tagged(const std::string& name, Index tags) {
    Mesh mesh = mesh_named(name);
    std::mt19937 random(9);
    mesh.tags.resize(static_cast<std::size_t>(mesh.simplices.rows()));
    for (Index& tag : mesh.tags)
        tag = 1 + static_cast<Index>(random() % static_cast<unsigned>(tags));
    return mesh;
}

/// Facets between simplices of different tags that are not there any more.
Index removed_walls(const Discretization& mesh, const std::vector<Index>& tags) {
    const int n = mesh.dimension();
    const Cofaces cofaces(mesh.pieces(), n);
    Index removed = 0;
    for (Index f = 0; f < mesh.pieces().size(n - 1); ++f) {
        const auto around = cofaces.of(f);
        const auto tag = [&](const Coface& t) { return tags[mesh.input().input_row(t.cell)]; };
        const bool is_wall = std::any_of(around.begin(), around.end(), [&](const Coface& t) {
            return tag(t) != tag(around.front());
        });
        removed += is_wall && mesh.merging().carriers(n - 1)[f].dimension == n ? 1 : 0;
    }
    return removed;
}

class MaterialsOf : public OverMeshes {};

TEST_P(MaterialsOf, a_mesh_are_kept_apart_by_all_facets_between_them) {
    const Mesh input = tagged(GetParam(), 3);
    const auto mesh = discretize(input, apart);
    const int n = mesh.dimension();
    EXPECT_EQ(removed_walls(mesh, input.tags), 0);
    ASSERT_EQ(mesh.tags().size(), static_cast<std::size_t>(mesh.complex().size(n)));
    for (Index t = 0; t < mesh.pieces().size(n); ++t)
        EXPECT_EQ(mesh.tags()[mesh.merging().carriers(n)[t].cell],
                  input.tags[mesh.input().input_row(t)]);
    EXPECT_EQ(betti_numbers(mesh.complex()), betti_numbers(mesh.input()));
}

TEST_P(MaterialsOf, one_kind_merge_as_if_there_were_none) {
    const auto one = discretize(tagged(GetParam(), 1), apart);
    const auto none = discretize(mesh_named(GetParam()), {.tolerance = tolerance});
    for (int k = 0; k <= none.dimension(); ++k) {
        EXPECT_EQ(one.complex().size(k), none.complex().size(k));
        EXPECT_EQ(one.volumes().dual(k), none.volumes().dual(k));
    }
}

/// How far vertices lie from the nearest k-plane, in parts of how far they lie apart.
double bend(const Points& points, const std::vector<Index>& vertices, int k) {
    const Points corners = points(vertices, Eigen::seqN(0, points.cols()));
    const DenseMatrix centered = corners.rowwise() - corners.colwise().mean();
    const Vector sizes = Eigen::JacobiSVD<DenseMatrix>(centered).singularValues();
    return k < sizes.size() ? sizes[k] / sizes[0] : 0;
}

TEST_P(MaterialsOf, flat_meshes_lie_in_planes_cell_by_cell) {
    if (mesh().points.cols() != mesh().n())
        return;
    const auto mesh = discretize(tagged(GetParam(), 2), apart);
    const int n = mesh.dimension();
    for (int k = 1; k <= n; ++k)
        for (Index c = 0; c < mesh.complex().size(k); ++c) {
            const auto vertices = mesh.merging().vertices(k, c);
            EXPECT_LE(bend(mesh.points(), vertices, k), 1e-7) << "cell " << c;
            EXPECT_GT(bend(mesh.points(), vertices, k - 1), 1e-7) << "cell " << c;
        }
}

TEST_P(MaterialsOf, flat_meshes_known_by_lengths_alone_have_the_same_facets) {
    const Merged& one = mesh();
    if (one.points.cols() != one.n())
        return;
    const auto tags = tagged(GetParam(), 2).tags;
    KeptFacets kept{std::vector<bool>(one.K().size(one.n() - 1), false), {}};
    const Cofaces cofaces(one.K(), one.n());
    for (Index f = 0; f < std::ssize(kept.stay); ++f)
        for (const Coface& t : cofaces.of(f))
            kept.stay[f] = kept.stay[f] || tags[t.cell] != tags[cofaces.of(f).front().cell];
    const auto merge = [&](const SimplexMetric& metric) {
        const auto volumes = circumcentric_volumes(one.K(), metric);
        return merge_cospherical({one.K(), metric, volumes}, {.tolerance = tolerance}, kept)
            .merging.merged();
    };
    const auto ours = merge({one.K(), edge_lengths(one.K(), one.points)});
    const auto theirs = merge(one.points);
    for (int k = std::max(0, one.n() - 1); k <= one.n(); ++k)
        EXPECT_EQ(ours.size(k), theirs.size(k)) << k;
}

POLYDEC_OVER_MESHES(MaterialsOf);

TEST(MaterialsOfCubes, are_joined_unless_they_are_to_be_kept_apart) {
    const Mesh input = tagged("kuhn3", 3);
    EXPECT_GT(removed_walls(discretize(input), input.tags), 0);
    EXPECT_EQ(removed_walls(discretize(input, apart), input.tags), 0);
}

TEST(GroupsOnTheBoundary, are_kept_apart_also_within_its_flat_parts) {
    Mesh input = kuhn(3, 3);
    const SimplicialComplex K(input.simplices);
    const auto outside = boundary_facets(K);
    input.facet_tags.simplices.resize(std::ssize(outside), 3);
    for (std::size_t i = 0; i < outside.size(); ++i) {
        input.facet_tags.simplices.row(i) = K.simplices(2).row(outside[i].facet);
        input.facet_tags.tags.push_back(1 + i % 2);
    }
    const auto mixed = [](const Discretization& mesh) {
        const auto facets = boundary_facets(mesh.complex());
        return std::count_if(facets.begin(), facets.end(), [&](const BoundaryFacet& on) {
            return mesh.facet_tags()[on.facet] == 0;
        });
    };
    EXPECT_GT(mixed(discretize(input)), 0);
    EXPECT_EQ(mixed(discretize(input, apart)), 0);
}

TEST(MaterialsOfSurfaces, do_not_go_with_flips) {
    auto options = apart;
    options.delaunay = Delaunay::flips;
    EXPECT_REFUSED(discretize(tagged("grid4", 2), options), "flips", "groups");
}

TEST(KeptFacets, are_given_by_as_many_entries_as_facets) {
    const Mesh mesh = grid(2, 2);
    const SimplicialComplex K(mesh.simplices);
    const auto volumes = circumcentric_volumes(K, mesh.points);
    const std::vector<bool> marks(2, true);
    EXPECT_REFUSED(merge_cospherical({K, mesh.points, volumes}, {}, {.stay = marks}), "2 marks",
                   "facets", "16");
    EXPECT_REFUSED(merge_cospherical({K, mesh.points, volumes}, {}, {.tags = {1, 2, 3}}), "3 tags",
                   "facets", "16");
}

} // namespace polydec::test::in_materials
