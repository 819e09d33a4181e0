// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <unistd.h>

namespace polydec::test {

namespace {

/// The folder of real meshes, or an empty path.
std::filesystem::path real_meshes() {
    const char* root = std::getenv("POLYDEC_TEST_DATA");
    return root == nullptr || *root == 0 ? std::filesystem::path()
                                         : std::filesystem::path(root) / "meshes";
}

} // namespace

TemporaryFolder::TemporaryFolder() {
    static int next = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("polydec-test-" + std::to_string(::getpid()) + "-" + std::to_string(next++));
    std::filesystem::create_directory(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::string& name,
                                             const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Mesh read_from(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    return read_mesh(folder.write(name, text));
}

std::string error_of(const std::function<void()>& action) {
    try {
        action();
        return "";
    } catch (const InvalidInput& error) {
        return std::string("InvalidInput: ") + error.what();
    } catch (const IoError& error) {
        return std::string("IoError: ") + error.what();
    }
}

std::vector<std::vector<double>> rows(const Points& points) {
    std::vector<std::vector<double>> result;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        result.emplace_back(points.row(i).begin(), points.row(i).end());
    return result;
}

std::vector<std::vector<Index>> rows(const Simplices& simplices) {
    std::vector<std::vector<Index>> result;
    for (Eigen::Index i = 0; i < simplices.rows(); ++i)
        result.emplace_back(simplices.row(i).begin(), simplices.row(i).end());
    return result;
}

bool same(const Mesh& a, const Mesh& b) {
    return a.ambient_dimension() == b.ambient_dimension() && a.dimension() == b.dimension() &&
           rows(a.points) == rows(b.points) && rows(a.simplices) == rows(b.simplices) &&
           rows(a.facet_tags.simplices) == rows(b.facet_tags.simplices) &&
           a.facet_tags.tags == b.facet_tags.tags;
}

bool same(const VtuGrid& a, const VtuGrid& b) {
    return a.types == b.types && a.corners == b.corners && a.offsets == b.offsets &&
           a.faces == b.faces && a.face_offsets == b.face_offsets;
}

void expect_two_tetrahedra(const Mesh& mesh) {
    using Rows = std::vector<std::vector<Index>>;
    EXPECT_EQ(rows(mesh.simplices), (Rows{{0, 1, 2, 3}, {1, 2, 3, 4}}));
    EXPECT_EQ(mesh.tags, (std::vector<Index>{11, 12}));
    EXPECT_EQ(rows(mesh.facet_tags.simplices), (Rows{{0, 1, 2}}));
    EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{40}));
    EXPECT_TRUE(mesh.warnings.empty());
}

std::string with_line_breaks(const std::string& text, const std::string& line_break) {
    std::string result;
    for (const char c : text)
        result += c == '\n' ? line_break : std::string(1, c);
    return result;
}

std::vector<std::filesystem::path> test_data(const std::string& folder) {
    std::vector<std::filesystem::path> paths;
    std::error_code none;
    if (has_test_data()) {
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(real_meshes() / folder, none))
            if (entry.is_regular_file())
                paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

bool has_test_data() {
    std::error_code none;
    return std::filesystem::is_directory(real_meshes(), none);
}

std::optional<std::filesystem::path> test_datum(const std::string& name) {
    if (!has_test_data())
        return std::nullopt;
    if (!std::filesystem::is_regular_file(real_meshes() / name))
        throw std::runtime_error("POLYDEC_TEST_DATA has meshes, but no " + name);
    return real_meshes() / name;
}

} // namespace polydec::test
