// SPDX-License-Identifier: MIT
#include "meshes/tetgen/tetgen_files.h"
#include "system/temporary_folder.h"
#include "tests/fuzz/targets.h"

#include <filesystem>
#include <fstream>

namespace polydec::fuzz {

namespace {

/// A file with these bytes, the same one for all that a target is given.
std::filesystem::path file_with(std::string_view bytes) {
    static const TemporaryFolder folder;
    auto path = folder.path() / "mesh.1.node";
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    file.close();
    require(file.good(), "there is room for the bytes of a file");
    return path;
}

} // namespace

/// What TetGen may have written: points, cells, faces or, on its output, facets that cross. There
/// are 9 points and facets.
void mesher_files(std::string_view bytes) {
    constexpr Index most = 9;
    const auto path = file_with(bytes);
    accepts<SolverFailure>(
        [&] { require(read_tetgen_points(path).allFinite(), "coordinates are finite"); });
    accepts<SolverFailure>([&] {
        const auto cells = read_tetgen_cells(path, most);
        require(cells.size() == 0 || (cells.minCoeff() >= 0 && cells.maxCoeff() < most),
                "vertex numbers are in range");
    });
    accepts<SolverFailure>([&] {
        const auto [faces, facets] = read_tetgen_faces(path, most, most);
        require(faces.size() == 0 || (faces.minCoeff() >= 0 && faces.maxCoeff() < most),
                "vertex numbers are in range");
        for (const Index facet : facets)
            require(facet >= 0 && facet < most, "facets are in range");
    });
    for (const auto& [a, b] : crossing_facets(std::string(bytes), most))
        require(0 <= a && a < b && b < most, "facets are in range");
}

} // namespace polydec::fuzz
