// SPDX-License-Identifier: MIT
#include "meshes/edges.h"
#include "tests/support/test.h"

namespace polydec::test::in_refine {

/// A box whose vertices are moved at random, with tags of cells and of some facets.
Mesh tagged_box(int n, int cells) {
    Mesh mesh = kuhn(n, cells);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.1, 0.1);
    for (double& x : mesh.points.reshaped())
        x += shift(random);
    const SimplicialComplex complex(mesh.simplices);
    for (Index s = 0; s < mesh.simplices.rows(); ++s)
        mesh.tags.push_back(s % 3);
    mesh.facet_tags.simplices.resize(complex.size(n - 1) / 2, n);
    for (Index f = 0; f < complex.size(n - 1) / 2; ++f) {
        mesh.facet_tags.simplices.row(f) = complex.simplices(n - 1).row(2 * f).reverse();
        mesh.facet_tags.tags.push_back(1 + f % 4);
    }
    return mesh;
}

std::vector<Mesh> meshes() {
    const Mesh book = made_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, .5}},
                              {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    return {kuhn(1, 3),       tagged_box(2, 3), tagged_box(3, 2), tagged_box(4, 1),
            tagged_box(1, 4), icosphere(1),     moebius(9, 3),    book};
}

double longest_edge(const Mesh& mesh) {
    double longest = 0;
    for (const auto& [a, b] : edges_of(mesh.simplices))
        longest = std::max(longest, distance(mesh.points, a, b));
    return longest;
}

/// By tag.
std::map<Index, double> volumes(const Points& points, const TaggedSimplices& given) {
    std::map<Index, double> result;
    for (Index s = 0; s < given.simplices.rows(); ++s) {
        const auto corners = given.simplices.row(s);
        const auto k = corners.size() - 1;
        DenseMatrix edges(k, points.cols());
        for (Eigen::Index i = 0; i < k; ++i)
            edges.row(i) = points.row(corners[i + 1]) - points.row(corners[0]);
        result[given.tags.empty() ? 0 : given.tags[s]] +=
            k == 0 ? 1 : std::sqrt((edges * edges.transpose()).determinant());
    }
    return result;
}

void expect_same(const std::map<Index, double>& a, const std::map<Index, double>& b, double share) {
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [tag, size] : a)
        EXPECT_NEAR(b.at(tag), size, share * size);
}

TEST(Refined, is_the_same_shape_with_the_same_tags) {
    for (const Mesh& mesh : meshes())
        for (const double share : {0.9, 0.4, 0.21}) {
            const double longest = share * longest_edge(mesh);
            const Mesh parts = refined(mesh, longest);
            const int n = mesh.dimension();
            EXPECT_LE(longest_edge(parts), longest * (1 + 2e-12));
            EXPECT_GT(longest_edge(parts), longest / 2.1);
            EXPECT_EQ(parts.points.topRows(mesh.points.rows()), mesh.points);
            expect_same(volumes(mesh.points, {mesh.simplices, mesh.tags}),
                        volumes(parts.points, {parts.simplices, parts.tags}), 1e-13);
            expect_same(volumes(mesh.points, mesh.facet_tags),
                        volumes(parts.points, parts.facet_tags), 1e-13);
            const SimplicialComplex before(mesh.simplices), after(parts.simplices);
            EXPECT_EQ(after.size(0), parts.points.rows());
            EXPECT_EQ(betti_numbers(after), betti_numbers(before));
            EXPECT_EQ(after.orientable(), before.orientable());
            EXPECT_EQ(after.turned() == 0, before.turned() == 0);
            ASSERT_EQ(std::ssize(parts.input_cells.of_simplices), parts.simplices.rows());
            EXPECT_EQ(parts.input_cells.count, mesh.simplices.rows());
            for (Index s = 0; s < std::ssize(parts.tags); ++s)
                EXPECT_EQ(parts.tags[s], mesh.tags[parts.input_cells.of_simplices[s]]);
            // two cells at each facet, or as many as before
            Index most = 0;
            for (const Index count : after.coface_counts(n - 1))
                most = std::max<Index>(most, count);
            EXPECT_LE(most, mesh.simplices.rows() == 3 && n == 2 ? 3 : 2);
        }
}

TEST(Refined, facets_with_tags_are_facets) {
    for (const int n : {2, 3}) {
        const Mesh mesh = refined(tagged_box(n, 2), 0.35);
        const SimplicialComplex complex(mesh.simplices);
        const auto& facets = complex.simplices(n - 1);
        for (Index f = 0; f < mesh.facet_tags.simplices.rows(); ++f) {
            Simplices corners = mesh.facet_tags.simplices.row(f);
            std::sort(corners.data(), corners.data() + n);
            bool is_there = false;
            for (Index g = 0; g < facets.rows() && !is_there; ++g)
                is_there = facets.row(g) == corners.row(0);
            EXPECT_TRUE(is_there);
        }
    }
}

TEST(Refined, with_edges_that_are_short_enough_is_itself) {
    for (const Mesh& mesh : meshes()) {
        const Mesh same = refined(mesh, longest_edge(mesh));
        EXPECT_EQ(same.simplices, mesh.simplices);
        EXPECT_EQ(same.points, mesh.points);
        EXPECT_EQ(same.bisections, 0);
        EXPECT_EQ(same.facet_tags.simplices, mesh.facet_tags.simplices);
    }
}

TEST(Refined, by_lengths_alone_is_the_same) {
    for (const Mesh& mesh : meshes()) {
        const double longest = 0.3 * longest_edge(mesh);
        const Mesh parts = refined(mesh, longest);
        const LengthMesh expected = length_mesh(parts), found = refined(length_mesh(mesh), longest);
        EXPECT_GT(parts.bisections, 0);
        EXPECT_EQ(found.bisections, parts.bisections);
        EXPECT_EQ(found.simplices, expected.simplices);
        EXPECT_EQ(found.vertices, expected.vertices);
        EXPECT_EQ(found.edges, expected.edges);
        EXPECT_WITHIN(found.lengths, expected.lengths, 1e-13);
        EXPECT_EQ(found.input_cells.of_simplices, parts.input_cells.of_simplices);
        EXPECT_NO_THROW(check(found));
    }
}

TEST(Refined, fits_across_the_seams_of_a_glued_box) {
    for (const int n : {2, 3}) {
        Mesh box = kuhn(n, 3);
        std::vector<Vector> translations;
        for (int axis = 0; axis < n; ++axis)
            translations.emplace_back(Vector::Unit(n, axis));
        const double middle = 0.37; // unlike 1/3 and 2/3
        for (double& x : box.points.reshaped())
            x = x > 0.3 && x < 0.4 ? middle : x;
        const PeriodicMesh mesh = periodic(box, translations), parts = refined(mesh, 0.25);
        EXPECT_NO_THROW(check(parts.quotient));
        EXPECT_LE(parts.quotient.lengths.maxCoeff(), 0.25 * (1 + 2e-12));
        EXPECT_EQ(betti_numbers(SimplicialComplex(parts.quotient.simplices)),
                  betti_numbers(SimplicialComplex(mesh.quotient.simplices)));
        EXPECT_EQ(parts.points.rows(), parts.quotient.vertices);
        EXPECT_EQ(std::ssize(parts.vertices), parts.box.points.rows());
        for (Index s = 0; s < parts.box.simplices.rows(); ++s)
            for (int i = 0; i <= n; ++i)
                EXPECT_EQ(parts.vertices[parts.box.simplices(s, i)],
                          parts.quotient.simplices(s, i));
        // both ends of the box have the same places
        for (std::size_t v = 0; v < parts.vertices.size(); ++v) {
            const Vector apart =
                parts.box.points.row(Index(v)) - parts.points.row(parts.vertices[v]);
            EXPECT_WITHIN(apart, Vector(apart.array().round()), 1e-14);
        }
        expect_same(volumes(box.points, {box.simplices, {}}),
                    volumes(parts.box.points, {parts.box.simplices, {}}), 1e-13);
    }
}

TEST(Refined, is_well_shaped_in_space) {
    double least = 1;
    const Mesh mesh = refined(kuhn(3, 1), 0.1);
    for (Index s = 0; s < mesh.simplices.rows(); ++s) {
        const TaggedSimplices one{mesh.simplices.row(s), {}};
        const Mesh alone{mesh.points, one.simplices, {}};
        least = std::min(least, volumes(mesh.points, one).at(0) / std::pow(longest_edge(alone), 3));
    }
    EXPECT_GE(least, 0.17);
}

TEST(Refined, works_in_any_unit) {
    for (const double unit : {1e-200, 1e-8, 1e150}) {
        Mesh mesh = tagged_box(3, 1);
        const auto expected = refined(mesh, 0.4).simplices;
        const LengthMesh lengths = length_mesh(mesh);
        LengthMesh scaled = lengths;
        scaled.lengths *= unit;
        EXPECT_EQ(refined(scaled, 0.4 * unit).simplices, expected);
    }
}

TEST(Refined, refuses_lengths_that_make_too_much) {
    const Mesh mesh = kuhn(2, 2);
    for (const double length : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_REFUSED(refined(mesh, length), "above 0");
    EXPECT_REFUSED(refined(mesh, 1e-6), "1e-06", "at least 2.31e+12", "1e+08");
    EXPECT_REFUSED(refined(mesh, 1e-300), "1e-300", "at least inf");
}

} // namespace polydec::test::in_refine
