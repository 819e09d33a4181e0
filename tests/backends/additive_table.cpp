// SPDX-License-Identifier: MIT
#include "backends/integrators/additive_table.h"

#include "tests/support/test.h"

namespace polydec::test::in_additive_table {

/// The largest defect of the conditions of order 1 .. 4 for weights, with each of the parts in
/// every place: b.1 = 1, b.c = 1/2, b.c^2 = 1/3, b.Ac = 1/6, b.c^3 = 1/4, b.cAc = 1/8, b.Ac^2 =
/// 1/12, b.AAc = 1/24 (Hairer, Norsett, Wanner 1993, II.2).
double defect(const AdditiveTable& table, const Vector& b, int order) {
    const Vector& c = table.times;
    std::vector<DenseMatrix> parts{table.explicit_part};
    if (table.implicit_part.size() > 0)
        parts.push_back(table.implicit_part);
    std::vector<double> defects{b.sum() - 1, b.dot(c) - 1. / 2, b.dot(c.cwiseAbs2()) - 1. / 3};
    for (const DenseMatrix& A : parts) {
        defects.push_back((A.rowwise().sum() - c).cwiseAbs().maxCoeff());
        defects.push_back(b.dot(A * c) - 1. / 6);
    }
    if (order > 3)
        defects.push_back(b.dot(c.array().cube().matrix()) - 1. / 4);
    for (const DenseMatrix& A : parts)
        if (order > 3) {
            defects.push_back(b.dot(c.cwiseProduct(A * c)) - 1. / 8);
            defects.push_back(b.dot(A * c.cwiseAbs2()) - 1. / 12);
            for (const DenseMatrix& B : parts)
                defects.push_back(b.dot(A * (B * c)) - 1. / 24);
        }
    double result = 0;
    for (const double each : defects)
        result = std::max(result, std::abs(each));
    return result;
}

TEST(additive_table, the_methods_have_their_orders) {
    for (const auto& table : {dormand_prince(), kennedy_carpenter()}) {
        EXPECT_LE(defect(table, table.weights, 4), 1e-14);
        const Vector embedded = table.weights - table.error_weights;
        EXPECT_LE(defect(table, embedded, table.embedded_order), 1e-14);
    }
    // the ninth condition of order 5, and the embedded method has it not
    const auto fifth = [](const Vector& b) {
        return b.dot(dormand_prince().times.array().pow(4).matrix()) - 1. / 5;
    };
    EXPECT_NEAR(fifth(dormand_prince().weights), 0, 1e-15);
    EXPECT_GT(std::abs(fifth(dormand_prince().weights - dormand_prince().error_weights)), 1e-4);
}

TEST(additive_table, the_implicit_part_is_stiffly_accurate_and_has_one_diagonal) {
    const auto& table = kennedy_carpenter();
    const DenseMatrix& I = table.implicit_part;
    EXPECT_EQ(I.row(5), table.weights.transpose());
    EXPECT_EQ(I(0, 0), 0);
    EXPECT_EQ(I.diagonal().tail(5), Vector::Constant(5, 0.25));
}

// The twin: a single wrong digit is seen.
TEST(additive_table, a_wrong_coefficient_is_seen) {
    for (auto table : {dormand_prince(), kennedy_carpenter()}) {
        table.explicit_part(3, 1) += 1e-6;
        EXPECT_GT(defect(table, table.weights, 4), 1e-8);
    }
}

} // namespace polydec::test::in_additive_table
