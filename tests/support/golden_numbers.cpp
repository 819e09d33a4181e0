// SPDX-License-Identifier: MIT
#include "dec/metric/subsets.h"
#include "tests/support/read_golden.h"
#include "tests/support/test.h"

namespace polydec::test {

Json golden_numbers(const std::string& file) {
    std::ifstream stream(test_file("golden/" + file));
    return Json::parse(stream);
}

std::string stem(const std::string& file) {
    return file.substr(0, file.rfind('.'));
}

bool is_golden(const Json& expected, double value) {
    const auto number = expected.get<double>();
    const double scale = std::abs(number) < 1e-8 ? 1 : std::abs(number);
    return std::abs(value - number) <= 1e-8 * scale;
}

void expect_stars(const Json& expected, const Merged& mesh, int k) {
    using Entry = std::pair<std::vector<Index>, double>;
    std::vector<Entry> found, wanted;
    const Vector values = star(mesh.volumes, k).diagonal();
    for (Index F = 0; F < values.size(); ++F)
        found.emplace_back(mesh.K().vertex_numbers(mesh.merging().vertices(k, F)), values[F]);
    for (const auto& entry : expected)
        wanted.emplace_back(entry.at(0).get<std::vector<Index>>(), entry.at(1).get<double>());
    std::sort(found.begin(), found.end());
    std::sort(wanted.begin(), wanted.end());
    ASSERT_EQ(found.size(), wanted.size()) << "star" << k;
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].first, wanted[i].first) << "star" << k;
        EXPECT_GOLDEN(wanted[i].second, found[i].second) << "star" << k;
    }
}

namespace {

/// A point as (x, y, z, w), missing coordinates being 0.
Eigen::Vector4d padded(const Vector& point) {
    Eigen::Vector4d result = Eigen::Vector4d::Zero();
    result.head(point.size()) = point;
    return result;
}

} // namespace

const Json& golden_calculus() {
    static const Json numbers = golden_numbers("expected_calculus.json");
    return numbers;
}

std::vector<std::string> golden_calculus_names() {
    std::vector<std::string> result;
    for (const auto& [name, numbers] : golden_calculus().items())
        if (name.find('/') == std::string::npos)
            result.push_back(name);
    return result;
}

Vector alpha(const Vector& point) {
    const auto p = padded(point);
    const double x = p[0], y = p[1], z = p[2], w = p[3];
    return Eigen::Vector4d(1 - y + x * z, x * x + y, y * z + x, w + x).head(point.size());
}

Vector beta(const Vector& point) {
    const auto p = padded(point);
    const double x = p[0], y = p[1], z = p[2], w = p[3];
    return Eigen::Vector4d(y, z - x, x * y + 1, w * w).head(point.size());
}

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

Vector on_merged_cells(const Merged& mesh, int k, const Form& form) {
    return mesh.merging().diamond(k).cast<double>() * integrate(mesh.K(), mesh.points, k, form);
}

} // namespace polydec::test
