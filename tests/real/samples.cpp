// SPDX-License-Identifier: MIT
#include "tests/real/samples.h"

#include "tests/io/support.h"

namespace polydec::test {

namespace {

/// A block with a hole through its middle.
Mesh ring() {
    return without(kuhn({6, 6, 3}, {2, 2, 1}), [](const Vector& centroid) {
        return (centroid.head(2).array() - 1).abs().maxCoeff() < 1.0 / 3;
    });
}

Mesh bowl() {
    return without(uv_sphere(14, 8), [](const Vector& centroid) { return centroid[2] > 0.3; });
}

const std::vector<NamedMesh>& all_made() {
    static const std::vector<NamedMesh> all{{"made/torus", shaken(torus(18, 10), 0.25, 1)},
                                            {"made/genus_two", shaken(genus_two(), 0.25, 2)},
                                            {"made/bowl", shaken(bowl(), 0.2, 3)},
                                            {"made/flange", shaken(flange(12), 0.2, 4)},
                                            {"made/cubes", shaken(kuhn(3, 4), 0.15, 5)},
                                            {"made/ring", shaken(ring(), 0.15, 6)},
                                            {"made/bcc", shaken(bcc(3), 0.15, 7)}};
    return all;
}

} // namespace

std::vector<std::string> samples(int dimension, const std::vector<std::string>& files) {
    std::vector<std::string> names;
    for (const auto& [name, mesh] : all_made())
        if (mesh.dimension() == dimension)
            names.push_back(name);
    if (test::has_test_data())
        names.insert(names.end(), files.begin(), files.end());
    return names;
}

Mesh mesh_of(const std::string& name) {
    for (const auto& made : all_made())
        if (made.name == name)
            return made.mesh;
    const auto path = test::test_datum(name);
    if (!path)
        throw std::runtime_error("no mesh is called " + name);
    return read_mesh(*path);
}

std::string test_name(const std::string& name) {
    std::string result = std::filesystem::path(name).stem().string();
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return result;
}

} // namespace polydec::test
