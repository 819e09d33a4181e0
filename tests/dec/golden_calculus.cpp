// SPDX-License-Identifier: MIT
#include "complex/homology.h"
#include "dec/derivative.h"
#include "dec/lift.h"
#include "dec/star.h"
#include "dec/whitney.h"
#include "tests/dec/golden_numbers.h"
#include "tests/support/forms.h"
#include "tests/support/relative.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace polydec::test {
namespace {

const Json& expected() {
    static const Json numbers = golden_numbers("expected_calculus.json");
    return numbers;
}

/// A point as (x, y, z, w), missing coordinates being 0.
Eigen::Vector4d padded(const Vector& point) {
    Eigen::Vector4d result = Eigen::Vector4d::Zero();
    result.head(point.size()) = point;
    return result;
}

/// (1 - y + x z, x^2 + y, y z + x, w + x) . dl
Vector alpha(const Vector& point) {
    const auto p = padded(point);
    const double x = p[0], y = p[1], z = p[2], w = p[3];
    return Eigen::Vector4d(1 - y + x * z, x * x + y, y * z + x, w + x).head(point.size());
}

/// (y, z - x, x y + 1, w^2) . dl
Vector beta(const Vector& point) {
    const auto p = padded(point);
    const double x = p[0], y = p[1], z = p[2], w = p[3];
    return Eigen::Vector4d(y, z - x, x * y + 1, w * w).head(point.size());
}

/// (1 + y) dx^dy + (x - z^2) dx^dz + (x y + 2) dy^dz
Vector eta(const Vector& point) {
    const auto p = padded(point);
    const double x = p[0], y = p[1], z = p[2];
    const auto axes = subsets(static_cast<int>(point.size()), 2);
    Vector result = Vector::Zero(static_cast<Index>(axes.size()));
    for (std::size_t I = 0; I < axes.size(); ++I) {
        if (axes[I] == std::vector<int>{0, 1})
            result[I] = 1 + y;
        if (axes[I] == std::vector<int>{0, 2})
            result[I] = x - z * z;
        if (axes[I] == std::vector<int>{1, 2})
            result[I] = x * y + 2;
    }
    return result;
}

class GoldenCalculus : public testing::TestWithParam<std::string> {
protected:
    const Merged& mesh() const { return merged(stem(GetParam())); }
    const Json& numbers() const { return expected().at(GetParam()); }

    Vector on_merged_cells(const Form& form, int k) const {
        return mesh().merging().diamond(k).cast<double>() *
               integrate(mesh().K(), mesh().points, k, form);
    }

    void expect_cochain(const std::string& key, const Form& form, int k) const {
        const Vector w = on_merged_cells(form, k);
        const auto& form_numbers = numbers().at(key);
        EXPECT_GOLDEN(form_numbers.at("norm"), w.norm()) << key;
        EXPECT_GOLDEN(form_numbers.at("abs_sum"), w.cwiseAbs().sum()) << key;
        if (form_numbers.contains("d_norm")) {
            EXPECT_GOLDEN(form_numbers.at("d_norm"), (derivative(mesh().P(), k) * w).norm()) << key;
        }
        EXPECT_GOLDEN(form_numbers.at("star_square"),
                      w.dot(star(mesh().volumes, k).cwiseProduct(w)))
            << key;
    }

    void expect_lift(const std::string& key, const Vector& lifted) const {
        EXPECT_GOLDEN(numbers().at(key).at("norm"), lifted.norm()) << key;
        EXPECT_GOLDEN(numbers().at(key).at("abs_sum"), lifted.cwiseAbs().sum()) << key;
    }
};

TEST_P(GoldenCalculus, counts_and_betti_numbers) {
    std::vector<Index> sizes;
    for (int k = 0; k <= mesh().n(); ++k)
        sizes.push_back(mesh().P().size(k));
    EXPECT_EQ(numbers().at("counts"), sizes);
    EXPECT_EQ(numbers().at("betti"), betti_numbers(mesh().P()));
    EXPECT_EQ(numbers().at("betti_relative"), betti_numbers(relative_to_boundary(mesh().P())));
}

TEST_P(GoldenCalculus, integrals_of_the_test_forms) {
    expect_cochain("alpha", alpha, 1);
    expect_cochain("beta", beta, 1);
    expect_cochain("eta", eta, 2);
}

TEST_P(GoldenCalculus, lifts_of_the_test_forms) {
    const auto S = commuting_lift(mesh().merging(), mesh().points, mesh().input_volumes);
    const Vector a = on_merged_cells(alpha, 1);
    expect_lift("lift1_alpha", S[1] * a);
    expect_lift("lift2_eta", S[2] * on_merged_cells(eta, 2));
    expect_lift("lift2_d_alpha", S[2] * (derivative(mesh().P(), 1) * a));
}

TEST_P(GoldenCalculus, stars_by_vertices) {
    for (int k = 0; k <= mesh().n(); ++k)
        if (const auto key = fmt::format("star{}", k); numbers().contains(key))
            expect_stars(numbers().at(key), mesh(), k);
}

std::vector<std::string> names() {
    std::vector<std::string> result;
    for (const auto& [name, numbers] : expected().items())
        if (name.find('/') == std::string::npos)
            result.push_back(name);
    return result;
}

INSTANTIATE_TEST_SUITE_P(Meshes, GoldenCalculus, testing::ValuesIn(names()),
                         [](const auto& instance) { return stem(instance.param); });

} // namespace
} // namespace polydec::test
