// SPDX-License-Identifier: MIT
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

} // namespace polydec::test
