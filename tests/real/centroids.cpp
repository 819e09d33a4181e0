// SPDX-License-Identifier: MIT
//
// Duals between centroids on meshes that are made with negative duals between circumcenters, and on
// every one below the folder of test data.
#include "tests/io/support.h"
#include "tests/real/samples.h"

namespace polydec::test::in_centroids {

constexpr double rounding = 1e-12;

/// How far the sum of |s||*s| over k-cells is from `times` |K|, relative.
double partition_defect(const CellVolumes& volumes, int k, double times) {
    const double whole = volumes.primal(volumes.dimension()).sum();
    return std::abs(volumes.primal(k).dot(volumes.dual(k)) / whole - times) / times;
}

void expect_positive_duals(const CellVolumes& volumes) {
    const int n = volumes.dimension();
    for (int k = 0; k <= n; ++k) {
        EXPECT_LE(partition_defect(volumes, k, binomial(n, k)), rounding) << "k = " << k;
        if (0 < k && k < n) {
            EXPECT_GT(partition_defect(volumes, k, 1), 0.1) << "of so many parts";
        }
        EXPECT_GT(volumes.dual(k).minCoeff(), 0) << "k = " << k;
        EXPECT_TRUE(star(volumes, k).zeros().empty()) << "k = " << k;
        const Vector diagonal = star(volumes, k).diagonal();
        EXPECT_TRUE(diagonal.allFinite() && diagonal.minCoeff() > 0) << "k = " << k;
    }
}

/// The files there are, those among them that hold meshes, and on how many of these circumcenters
/// would make a dual negative.
struct Counts {
    int files = 0, meshes = 0, negative = 0;
};

bool circumcenters_fail(const Discretization& mesh) {
    const auto volumes = circumcentric_volumes(mesh.input(), mesh.input_geometry().metric());
    for (int k = 0; k < mesh.dimension(); ++k)
        if (!star(volumes, k).negatives().empty())
            return true;
    return false;
}

void check_mesh(const Discretization& mesh, Counts& counts) {
    ++counts.meshes;
    counts.negative += circumcenters_fail(mesh);
    expect_positive_duals(mesh.volumes());
}

constexpr auto between_centroids = [](const Mesh& mesh) {
    return discretize(mesh, {.centers = Centers::centroids()});
};

void check_file(const std::filesystem::path& path, Counts& counts) {
    Mesh mesh;
    std::optional<Discretization> made;
    const auto reading = test::error_of([&] { mesh = read_mesh(path); });
    if (!reading.empty()) {
        EXPECT_TRUE(path.string().find("/bad/") != std::string::npos) << reading;
        EXPECT_TRUE(reading.starts_with("InvalidInput: ") || reading.starts_with("IoError: "))
            << reading;
        return;
    }
    const auto making = test::error_of([&] { made = between_centroids(mesh); });
    if (!made) {
        EXPECT_TRUE(making.starts_with("InvalidInput: ")) << making;
        EXPECT_NE(making.find("without"), std::string::npos) << making;
        return;
    }
    check_mesh(*made, counts);
}

TEST(RealCentroids, give_positive_duals_that_fill_every_mesh) {
    Counts counts;
    for (const int n : {2, 3})
        for (const auto& name : samples(n)) {
            SCOPED_TRACE(name);
            check_mesh(between_centroids(mesh_of(name)), counts);
        }
    EXPECT_EQ(counts.negative, counts.meshes) << "between circumcenters";
    for (const auto& path : test::test_data("."))
        if (path.extension() != ".md") {
            SCOPED_TRACE(path.string());
            ++counts.files;
            check_file(path, counts);
        }
    EXPECT_EQ(counts.files > 0, test::has_test_data());
    RecordProperty("files", counts.files);
    RecordProperty("meshes", counts.meshes);
    EXPECT_GT(counts.meshes, counts.files / 2);
    EXPECT_GT(counts.negative, counts.meshes / 2);
}

} // namespace polydec::test::in_centroids
