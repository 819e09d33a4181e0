// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// A folder that is removed with all it holds at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path path(const std::string& name) const { return path_ / name; }

    /// Writes a file and gives its path.
    std::filesystem::path write(const std::string& name, const std::string& text) const;

    /// What the folder holds, hidden files included, sorted.
    std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& path);

/// Reads a mesh from this text in a file of this name.
Mesh read_from(const std::string& name, const std::string& text);

/// The kind and the whole message of what is thrown, such as "InvalidInput: ..."; "" if nothing is.
std::string error_of(const std::function<void()>& action);

/// Expects a file of this name and text to be refused with these words, in this order.
#define EXPECT_UNREADABLE(name, text, ...)                                                         \
    EXPECT_REFUSED(::polydec::test::read_from(name, text), __VA_ARGS__)

/// The coordinates, row by row.
std::vector<std::vector<double>> rows(const Points& points);
std::vector<std::vector<Index>> rows(const Simplices& simplices);

/// Expects two tetrahedra of the groups 11 and 12 with a triangle of the group 40, as files of Gmsh
/// and VTK of every kind have them in the tests.
void expect_two_tetrahedra(const Mesh& mesh);

/// Points, cells, and facets with tags that are equal to the last bit.
bool same(const Mesh& a, const Mesh& b);

/// The same cells, by the numbers of their points.
bool same(const VtuGrid& a, const VtuGrid& b);

/// Replaces every line break, which must be LF.
std::string with_line_breaks(const std::string& text, const std::string& line_break);

/// The real meshes of POLYDEC_TEST_DATA below this folder, sorted; none where it is not set.
std::vector<std::filesystem::path> test_data(const std::string& folder);

/// Whether there are any: POLYDEC_TEST_DATA is set and has a folder `meshes`.
bool has_test_data();

/// The one of this name, such as "cad/joint.obj"; nothing where there are none at all. Throws
/// std::runtime_error, which fails the test, where there are others but not this one.
std::optional<std::filesystem::path> test_datum(const std::string& name);

} // namespace polydec::test
