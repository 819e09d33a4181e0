// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_golden {

const Json& expected() {
    static const Json numbers = golden_numbers("expected.json");
    return numbers;
}

/// Numbers of an independent program; the parameter is the name of a golden mesh without ending.
class Golden : public testing::TestWithParam<std::string> {
protected:
    const Merged& mesh() const { return merged(stem(GetParam())); }
    const Json& numbers() const { return expected().at(GetParam()); }
    const Json& summary() const { return numbers().at("summary"); }
};

TEST_P(Golden, counts) {
    EXPECT_EQ(summary().at("N"), mesh().points.cols());
    EXPECT_EQ(summary().at("n"), mesh().n());
    EXPECT_EQ(summary().at("counts_simplicial"), sizes(mesh().K()));
    EXPECT_EQ(summary().at("counts_merged"), sizes(mesh().P()));
    EXPECT_EQ(summary().at("euler").at(0), euler_characteristic(mesh().K()));
    EXPECT_EQ(summary().at("euler").at(1), euler_characteristic(mesh().P()));
}

TEST_P(Golden, betti_numbers) {
    EXPECT_EQ(numbers().at("betti").at("simplicial"), betti_numbers(mesh().K()));
    EXPECT_EQ(numbers().at("betti").at("merged"), betti_numbers(mesh().P()));
}

TEST_P(Golden, degenerate_facets) {
    const auto& found = mesh().result.degenerate;
    EXPECT_EQ(summary().at("degenerate_facets"), found.interior);
    EXPECT_EQ(summary().at("boundary_degenerate"), found.boundary);
    EXPECT_EQ(summary().at("branching_degenerate"), found.branching);
    EXPECT_EQ(summary().at("guard").at("backoff"), mesh().result.rounds);
}

TEST_P(Golden, vertices_per_cell) {
    std::map<std::string, Index> histogram;
    for (Index F = 0; F < mesh().P().size(mesh().n()); ++F)
        ++histogram[std::to_string(mesh().merging().vertices(mesh().n(), F).size())];
    EXPECT_EQ(numbers().at("cells").at("vertices_per_cell"), Json(histogram));
}

TEST_P(Golden, incidences) {
    for (int k = 0; k < mesh().n(); ++k) {
        const auto& d = mesh().P().coboundary(k);
        const auto& numbers = summary().at(fmt::format("d{}", k));
        EXPECT_EQ(numbers.at("shape").at(0), d.rows());
        EXPECT_EQ(numbers.at("shape").at(1), d.cols());
        EXPECT_EQ(numbers.at("nnz"), d.nonZeros());
        std::set<double> values;
        for (Index i = 0; i < d.nonZeros(); ++i)
            values.insert(d.valuePtr()[i]);
        EXPECT_EQ(numbers.at("values"), Json(values));
    }
}

void expect_summary(const Json& numbers, const Vector& values, const std::string& what) {
    EXPECT_EQ(numbers.at("size"), values.size()) << what;
    EXPECT_GOLDEN(numbers.at("sum"), values.sum()) << what;
    EXPECT_GOLDEN(numbers.at("abs_sum"), values.cwiseAbs().sum()) << what;
    EXPECT_GOLDEN(numbers.at("norm2"), values.norm()) << what;
    EXPECT_GOLDEN(numbers.at("min"), values.minCoeff()) << what;
    EXPECT_GOLDEN(numbers.at("max"), values.maxCoeff()) << what;
    EXPECT_GOLDEN(numbers.at("min_abs"), values.cwiseAbs().minCoeff()) << what;
    // rounding decides the sign of what is zero
    if (values.cwiseAbs().minCoeff() > 1e-8) {
        EXPECT_EQ(numbers.at("negative"), (values.array() < 0).count()) << what;
    }
}

TEST_P(Golden, volumes_and_stars) {
    EXPECT_GOLDEN(summary().at("total_volume"), mesh().volumes.primal(mesh().n()).sum());
    for (int k = 0; k <= mesh().n(); ++k) {
        expect_summary(summary().at(fmt::format("star{}", k)), star(mesh().volumes, k).diagonal(),
                       fmt::format("star{}", k));
        expect_summary(summary().at(fmt::format("dual{}", k)), mesh().volumes.dual(k),
                       fmt::format("dual{}", k));
        expect_summary(summary().at(fmt::format("vol{}", k)), mesh().volumes.primal(k),
                       fmt::format("vol{}", k));
    }
}

TEST_P(Golden, stars_by_vertices) {
    for (int k = 0; k <= mesh().n(); ++k)
        if (const auto key = fmt::format("star{}", k); numbers().contains(key))
            expect_stars(numbers().at(key), mesh(), k);
}

TEST_P(Golden, laplacians) {
    for (int k = 0; k <= mesh().n(); ++k) {
        const auto key = fmt::format("L{}", k);
        if (!numbers().contains(key))
            continue;
        const DenseMatrix L(laplacian({mesh().P(), mesh().volumes}, k).matrix());
        EXPECT_GOLDEN(numbers().at(key).at("trace"), L.trace()) << key;
        EXPECT_GOLDEN(numbers().at(key).at("frobenius"), L.norm()) << key;
        EXPECT_GOLDEN(numbers().at(key).at("abs_sum"), L.cwiseAbs().sum()) << key;
        if (k == 0) {
            EXPECT_NEAR(L.sum(), 0, 1e-8 * L.cwiseAbs().sum()) << key;
        }
    }
}

std::vector<std::string> names() {
    std::vector<std::string> result;
    for (const auto& [name, numbers] : expected().items())
        result.push_back(name);
    return result;
}

INSTANTIATE_TEST_SUITE_P(Meshes, Golden, testing::ValuesIn(names()),
                         [](const auto& instance) { return stem(instance.param); });

TEST(GoldenNumbers, tell_an_error_of_1e_7) {
    EXPECT_TRUE(is_golden(2.0, 2.0 * (1 + 5e-9)));
    EXPECT_FALSE(is_golden(2.0, 2.0 * (1 + 1e-7)));
    EXPECT_TRUE(is_golden(2e-16, 1e-15));
    EXPECT_FALSE(is_golden(0, 1e-7));
    EXPECT_FALSE(is_golden(1, std::numeric_limits<double>::quiet_NaN()));
}

} // namespace polydec::test::in_golden
