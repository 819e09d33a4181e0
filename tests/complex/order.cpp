// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_order_file {

class Orders : public testing::TestWithParam<std::string> {
protected:
    const Mesh& mesh() const { return mesh_named(GetParam()); }
};

bool same(const SimplicialComplex& a, const SimplicialComplex& b) {
    bool result = a.dimension() == b.dimension() && a.orientable() == b.orientable();
    for (int k = 0; result && k <= a.dimension(); ++k)
        result = a.size(k) == b.size(k) && a.simplices(k) == b.simplices(k) &&
                 a.coface_counts(k) == b.coface_counts(k) &&
                 equal(integers(a.coboundary(k)), integers(b.coboundary(k)));
    return result;
}

TEST_P(Orders, of_cells_do_not_matter) {
    Simplices reversed = mesh().simplices.colwise().reverse();
    EXPECT_TRUE(same(SimplicialComplex(mesh().simplices), SimplicialComplex(reversed)));

    std::mt19937 random(1);
    std::vector<Index> order(mesh().simplices.rows());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    const Simplices mixed = mesh().simplices(order, Eigen::indexing::all);
    EXPECT_TRUE(same(SimplicialComplex(mesh().simplices), SimplicialComplex(mixed)));
}

TEST_P(Orders, of_vertices_within_cells_do_not_matter_up_to_orientation) {
    // even permutations turn no cell
    std::mt19937 random(2);
    Simplices mixed = mesh().simplices;
    const auto m = mixed.cols();
    for (auto cell : mixed.rowwise())
        for (Index i = 0; m >= 3 && i < 5; ++i) {
            const Index first = static_cast<Index>(random() % (m - 2));
            std::rotate(cell.begin() + first, cell.begin() + first + 1, cell.begin() + first + 3);
        }
    EXPECT_TRUE(same(SimplicialComplex(mesh().simplices), SimplicialComplex(mixed)));
}

TEST_P(Orders, are_told_apart_where_cells_differ) {
    const auto rows = mesh().simplices.rows();
    if (rows > 1) {
        EXPECT_FALSE(same(SimplicialComplex(mesh().simplices),
                          SimplicialComplex(Simplices(mesh().simplices.topRows(rows - 1)))));
    }
}

/// Old vertex numbers of a renumbered simplex, ascending, and the sign of sorting them.
std::pair<std::vector<Index>, int> old_simplex(const SimplicialComplex& complex, int k, Index s,
                                               const std::vector<Index>& old_number) {
    std::vector<Index> list;
    for (const Index v : complex.vertex_numbers(k, s))
        list.push_back(old_number[v]);
    int sign = 1;
    for (std::size_t i = 0; i < list.size(); ++i)
        for (std::size_t j = i + 1; j < list.size(); ++j)
            sign *= list[i] < list[j] ? 1 : -1;
    std::sort(list.begin(), list.end());
    return {list, sign};
}

TEST_P(Orders, of_vertices_rename_the_simplices_and_change_nothing_else) {
    const auto renumbered = shuffled(mesh(), 4);
    const SimplicialComplex K(mesh().simplices), L(renumbered.mesh.simplices);
    const int n = K.dimension();
    EXPECT_EQ(K.orientable(), L.orientable());

    std::vector<std::vector<Index>> number(n + 1);
    std::vector<std::vector<int>> sign(n + 1);
    for (int k = 0; k <= n; ++k) {
        ASSERT_EQ(K.size(k), L.size(k));
        std::map<std::vector<Index>, Index> numbers;
        for (Index s = 0; s < K.size(k); ++s)
            numbers[K.vertex_numbers(k, s)] = s;
        for (Index s = 0; s < L.size(k); ++s) {
            const auto [list, turn] = old_simplex(L, k, s, renumbered.vertices);
            ASSERT_TRUE(numbers.contains(list));
            number[k].push_back(numbers[list]);
            sign[k].push_back(turn);
        }
    }
    for (int k = 0; k < n; ++k)
        for (Index t = 0; t < L.size(k + 1); ++t)
            for (IncidenceMatrix::InnerIterator s(L.coboundary(k), t); s; ++s) {
                const int old = K.coboundary(k).coeff(number[k + 1][t], number[k][s.col()]);
                // top cells may be turned, part by part
                const int kept = s.value() * sign[k + 1][t] * sign[k][s.col()];
                ASSERT_EQ(k + 1 == n ? std::abs(old) : old, k + 1 == n ? std::abs(kept) : kept);
            }
}

POLYDEC_OVER_MESHES(Orders);

} // namespace polydec::test::in_order_file
