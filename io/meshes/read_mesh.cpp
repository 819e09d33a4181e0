// SPDX-License-Identifier: MIT
#include "io/meshes/mesh_files.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"
#include "io/source_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <vector>

namespace polydec {

namespace {

struct Format {
    const char* extension;
    Mesh (*read)(const SourceFile&);
};

constexpr std::array formats{
    Format{".off", read_off},  Format{".obj", read_obj},     Format{".ply", read_ply},
    Format{".stl", read_stl},  Format{".nsc", read_nsc},     Format{".mesh", read_medit},
    Format{".msh", read_gmsh}, Format{".node", read_tetgen}, Format{".ele", read_tetgen},
    Format{".vtk", read_vtk},  Format{".vtu", read_vtu},     Format{".pdm", read_pdm},
};

const Format& format_of(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    std::string known;
    for (const auto& format : formats) {
        if (extension == format.extension)
            return format;
        known += std::string(known.empty() ? "" : " ") + format.extension;
    }
    if (is_length_file(path))
        refuse_contents(path.string(), ".nsl holds lengths of edges and no points; expected a mesh "
                                       "with points; read it with read_lengths");
    refuse_contents(path.string(), fmt::format("'{}' is not the extension of a mesh format; "
                                               "expected one of {}, or .nsl for edge lengths "
                                               "without points; rename or convert the file",
                                               extension, known));
}

} // namespace

Mesh read_mesh(const std::filesystem::path& path) {
    // An unknown format is said before the file is looked for.
    format_of(path);
    return parse_mesh(read_source_file(path));
}

int up_axis(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".obj" || extension == ".ply" || extension == ".off" ? 1 : 2;
}

Mesh parse_mesh(const SourceFile& file) {
    const auto& format = format_of(file.name);
    try {
        Mesh mesh = format.read(file);
        if (mesh.points.rows() == 0)
            refuse_contents(file.name,
                            "the file holds no vertices; expected a mesh; export it again");
        if (mesh.simplices.rows() == 0)
            refuse_contents(file.name,
                            fmt::format("the file holds {} vertices but no cells; expected at "
                                        "least one cell; export it with its cells",
                                        mesh.points.rows()));
        return mesh;
    } catch (const InvalidInput&) {
        const auto other = foreign_format(file);
        if (other.empty())
            throw;
        refuse_contents(file.name,
                        fmt::format("the extension {} does not match the file, which is {}",
                                    format.extension, other));
    } catch (const std::bad_alloc&) {
        refuse_reading(file.name, "not enough memory");
    }
}

void end_records(Scanner& scanner, Index count, const char* plural) {
    if (!scanner.at_end())
        scanner.fail(fmt::format("more follows after {} {}; expected the end of the file; correct "
                                 "the number in the first line",
                                 count, plural));
}

void reserve_faces(PolygonMesh& polygons, Index faces, std::size_t remaining) {
    const auto count = std::min(static_cast<std::size_t>(faces), remaining);
    polygons.offsets.reserve(count + 1);
    polygons.corners.reserve(std::min(3 * count, remaining));
}

void close_face(PolygonMesh& polygons, const SourceFile& file) {
    polygons.offsets.push_back(checked_count(polygons.corners.size(), "corners of faces", file));
}

Mesh segments_of(const PolygonMesh& lines) {
    std::vector<Index> ends;
    for (Index line = 0; line < lines.size(); ++line)
        for (std::size_t at = 1; at < lines.face(line).size(); ++at)
            ends.insert(ends.end(), {lines.face(line)[at - 1], lines.face(line)[at]});
    return {lines.points, simplices_of(ends, 2), {}};
}

Index checked_count(std::size_t count, const char* plural, const SourceFile& file) {
    if (count > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
        refuse_contents(
            file.name,
            fmt::format("more than 2^31 - 1 {}; expected fewer; divide the mesh", plural));
    return static_cast<Index>(count);
}

Points points_from(const std::vector<double>& coordinates) {
    const auto rows = static_cast<Eigen::Index>(coordinates.size() / 3);
    return Eigen::Map<const Points>(coordinates.data(), rows, 3);
}

} // namespace polydec
