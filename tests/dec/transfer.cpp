// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_transfer {

class Transfers : public OverMeshes {
protected:
    const Discretization& bundle() const { return discretized(GetParam()); }
    int n() const { return bundle().dimension(); }
};

constexpr double rounding = 1e-12;

TEST_P(Transfers, there_and_back_is_the_identity_on_merged_cells) {
    const auto& [merging, volumes] =
        std::tie(bundle().merging(), bundle().input_geometry().volumes());
    for (int k = 0; k <= n(); ++k) {
        const SparseMatrix I = identity(bundle().complex().size(k));
        EXPECT_CLOSE(product(primal_to_merged(merging, k), primal_to_input(merging, volumes, k)), I,
                     rounding);
        EXPECT_CLOSE(
            product(dual_to_merged(merging, volumes, n() - k), dual_to_input(merging, n() - k)), I,
            rounding);
    }
}

TEST_P(Transfers, sums_commute_with_d_and_copies_with_the_dual_d) {
    const auto& merging = bundle().merging();
    const auto& K = bundle().input();
    const auto& P = bundle().complex();
    for (int k = 0; k < n(); ++k) {
        EXPECT_EQ(relative_difference(product(primal_to_merged(merging, k + 1), derivative(K, k)),
                                      product(derivative(P, k), primal_to_merged(merging, k))),
                  0);
        EXPECT_EQ(relative_difference(product(dual_to_input(merging, k + 1), dual_derivative(P, k)),
                                      product(dual_derivative(K, k), dual_to_input(merging, k))),
                  0);
    }
}

TEST_P(Transfers, shares_and_copies_are_transposed) {
    const auto& [merging, volumes] =
        std::tie(bundle().merging(), bundle().input_geometry().volumes());
    for (int k = 0; k <= n(); ++k) {
        EXPECT_EQ(
            relative_difference(SparseMatrix(primal_to_input(merging, volumes, k).transpose()),
                                dual_to_merged(merging, volumes, n() - k)),
            0);
        EXPECT_EQ(relative_difference(SparseMatrix(primal_to_merged(merging, k).transpose()),
                                      dual_to_input(merging, n() - k)),
                  0);
    }
}

TEST_P(Transfers, the_star_of_merged_cells_is_that_of_the_simplices_between_the_maps) {
    // star_k^P = R_k^T star_k R_k: what the volumes of merged cells are made for
    for (int k = 0; k <= n(); ++k) {
        const SparseMatrix R =
            primal_to_input(bundle().merging(), bundle().input_geometry().volumes(), k);
        const SparseMatrix between =
            SparseMatrix(R.transpose()) *
            star(bundle().input_geometry().volumes(), k).diagonal().asDiagonal() * R;
        EXPECT_CLOSE(Vector(between.diagonal()), star(bundle().volumes(), k).diagonal(), 1e-11)
            << "k = " << k;
    }
}

TEST_P(Transfers, operators_act_on_the_input_as_on_merged_cells) {
    for (int k = 0; k <= n(); ++k)
        for (const Side side : {Side::primal, Side::dual}) {
            const int degree = side == Side::primal ? k : n() - k;
            const Cochain w{side, degree, random_vector(bundle().complex().size(k), 3)};
            if (degree == n())
                continue;
            const SparseMatrix O = side == Side::primal
                                       ? derivative(bundle().complex(), degree)
                                       : dual_derivative(bundle().complex(), degree);
            const SparseMatrix wrapped = on_input(bundle(), O, {side, degree}, {side, degree + 1});
            const Cochain seen{side, degree + 1, wrapped * to_input(bundle(), w).values};
            const Cochain there = d(bundle().complex(), w);
            EXPECT_CLOSE(to_merged(bundle(), seen).values, there.values, rounding);
            EXPECT_CLOSE(seen.values, to_input(bundle(), there).values, rounding);
        }
}

TEST_P(Transfers, copies_are_consistent_and_nothing_else_is) {
    for (int j = 0; j <= n(); ++j) {
        const int k = n() - j;
        const Cochain merged_form{Side::dual, j, random_vector(bundle().complex().size(k), 4)};
        Cochain form = to_input(bundle(), merged_form);
        EXPECT_TRUE(consistency(bundle(), form).within(rounding)) << "j = " << j;

        // one removed simplex, or one piece among several, that is changed must be found
        for (Index s = 0; s < form.values.size(); ++s) {
            const auto& carrier = bundle().merging().carriers(k)[s];
            const auto pieces =
                carrier.dimension == k
                    ? SparseMatrix::StorageIndex(
                          bundle().merging().diamond(k).outerIndexPtr()[carrier.cell + 1] -
                          bundle().merging().diamond(k).outerIndexPtr()[carrier.cell])
                    : 0;
            if (pieces == 1)
                continue;
            form.values[s] += 10;
            const auto result = consistency(bundle(), form);
            EXPECT_GT(result.worst, 1) << "j = " << j << ", simplex " << s;
            form.values[s] -= 10;
            break;
        }
    }
}

POLYDEC_OVER_MESHES(Transfers);

TEST(TransfersBroken, adding_the_entries_of_star_2_is_not_the_star_of_merged_cells) {
    const auto bundle = discretize(grid(3, 3));
    const Vector sums = primal_to_merged(bundle.merging(), 2) *
                        star(bundle.input_geometry().volumes(), 2).diagonal();
    EXPECT_GT(relative_difference(sums, star(bundle.volumes(), 2).diagonal()), 1);
}

TEST(Consistency, names_the_worst_offender) {
    const auto bundle = discretize(grid(1, 1));
    Cochain circulation{Side::dual, 1, Vector::Zero(5)};
    EXPECT_EQ(consistency(bundle, circulation).description, "");
    Index diagonal = 0;
    while (bundle.merging().carriers(1)[diagonal].dimension == 1)
        ++diagonal;
    circulation.values[diagonal] = 0.25;
    EXPECT_SAYS(consistency(bundle, circulation).description, "1-simplex 2", "vertices 0, 3",
                "merged 2-cell", "dual", "0.25");
    EXPECT_SAYS(consistency(bundle, {Side::dual, 0, Eigen::Vector2d(1, 3)}).description,
                "2-simplex 0", "vertices 0, 1, 3", "merged 2-cell 0", "1", "2");
}

TEST(TransferErrors, name_what_does_not_fit) {
    const auto bundle = discretize(grid(1, 1));
    EXPECT_REFUSED(consistency(bundle, {Side::primal, 1, Vector::Zero(5)}), "primal 1-form",
                   "dual forms");
    EXPECT_REFUSED(to_merged(bundle, {Side::dual, 1, Vector::Zero(4)}), "dual 1-form", "4 values",
                   "5 1-cells");
    EXPECT_REFUSED(on_input(bundle, SparseMatrix(3, 3), {Side::dual, 0}, {Side::dual, 1}),
                   "dual 0-forms", "dual 1-forms", "4 x 1", "3 x 3");
}

} // namespace polydec::test::in_transfer
