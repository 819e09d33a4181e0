// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "io/byte_order.h"
#include "io/meshes/mesh_files.h"
#include "io/meshes/readers.h"
#include "io/number_lines.h"
#include "io/source_file.h"
#include "system/atomic_file.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace polydec {

namespace {

using Path = std::filesystem::path;

void check_points(const Path& path, const Points& points) {
    for (Eigen::Index vertex = 0; vertex < points.rows(); ++vertex)
        if (!points.row(vertex).allFinite())
            refuse_writing(
                path,
                fmt::format("vertex {} has a coordinate that is NaN or infinite; correct it",
                            vertex),
                {.vertices = {static_cast<Index>(vertex)}});
}

void check_simplices(const Path& path, const Mesh& mesh) {
    for (Eigen::Index cell = 0; cell < mesh.simplices.rows(); ++cell)
        for (const Index vertex : mesh.simplices.row(cell))
            if (vertex < 0 || vertex >= mesh.points.rows())
                refuse_writing(path,
                               fmt::format("cell {} has the vertex {}; {}", cell, vertex,
                                           expected_numbers(0, mesh.points.rows() - 1)),
                               {.degree = mesh.dimension(),
                                .cells = {static_cast<Index>(cell)},
                                .vertices = {vertex}});
}

/// Triangles and polygons alike, for the formats of surfaces; or edges.
struct SurfaceFaces {
    const Points& points;
    std::span<const Index> corners;
    std::size_t count;
    const std::vector<Index>* offsets; ///< none for simplices
    std::size_t size = 3;              ///< number of corners of these

    std::span<const Index> operator[](std::size_t face) const {
        if (offsets == nullptr)
            return corners.subspan(size * face, size);
        const auto begin = static_cast<std::size_t>((*offsets)[face]);
        return corners.subspan(begin, static_cast<std::size_t>((*offsets)[face + 1]) - begin);
    }
};

/// The coordinates of each vertex, with zeros up to `axes`, between these words.
void write_vertices(NumberLines& lines, const Points& points, Eigen::Index axes,
                    const char* before = "", const char* behind = "") {
    for (Eigen::Index vertex = 0; vertex < points.rows(); ++vertex) {
        lines.word(before);
        for (Eigen::Index axis = 0; axis < axes; ++axis)
            lines.number(axis < points.cols() ? points(vertex, axis) : 0.0);
        lines.word(behind);
        lines.end();
    }
}

void write_off(const Path& path, const SurfaceFaces& faces) {
    NumberLines lines(path);
    lines.text(fmt::format("OFF\n{} {} 0\n", faces.points.rows(), faces.count));
    write_vertices(lines, faces.points, 3);
    for (std::size_t face = 0; face < faces.count; ++face) {
        lines.number(faces[face].size());
        lines.numbers(faces[face]);
        lines.end();
    }
    lines.commit();
}

void write_obj(const Path& path, const SurfaceFaces& faces) {
    NumberLines lines(path);
    write_vertices(lines, faces.points, 3, "v");
    for (std::size_t face = 0; face < faces.count; ++face) {
        lines.word(faces.offsets == nullptr && faces.size == 2 ? "l" : "f");
        for (const Index corner : faces[face])
            lines.number(std::int64_t{corner} + 1);
        lines.end();
    }
    lines.commit();
}

Eigen::Vector3d padded(const Points& points, Index vertex) {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    place.head(points.cols()) = points.row(vertex);
    return place;
}

/// The corners of a triangle, one a column. An STL file has floats, into which not every double
/// fits.
Eigen::Matrix3f in_floats(const Path& path, const Points& points, std::span<const Index> corners) {
    Eigen::Matrix3d places;
    for (std::size_t i = 0; i < 3; ++i) {
        places.col(i) = padded(points, corners[i]);
        if (places.col(i).cwiseAbs().maxCoeff() > std::numeric_limits<float>::max())
            refuse_writing(path,
                           fmt::format("a coordinate of vertex {} is too large for the floats of "
                                       "STL; use .off, .obj or .ply",
                                       corners[i]),
                           {.vertices = {corners[i]}});
    }
    const Eigen::Matrix3f rounded = places.cast<float>();
    for (std::size_t i = 0, next = 1; i < 3; ++i, next = (next + 1) % 3)
        if (rounded.col(i) == rounded.col(next) && places.col(i) != places.col(next))
            refuse_writing(path,
                           fmt::format("vertices {} and {} of a triangle are at one place in the "
                                       "floats of STL; use .ply, or move the mesh to the origin",
                                       corners[i], corners[next]),
                           {.vertices = {corners[i], corners[next]}});
    return rounded;
}

void write_ply(const Path& path, const SurfaceFaces& faces) {
    std::size_t most_corners = 3;
    for (std::size_t face = 0; face < faces.count; ++face)
        most_corners = std::max(most_corners, faces[face].size());
    const bool is_short = most_corners < 256;
    AtomicFile file(path);
    file.write(fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
                           "property double x\nproperty double y\nproperty double z\n"
                           "element face {}\nproperty list {} int vertex_indices\nend_header\n",
                           faces.points.rows(), faces.count, is_short ? "uchar" : "uint"));
    for (Index vertex = 0; vertex < faces.points.rows(); ++vertex)
        for (const double value : padded(faces.points, vertex))
            file.write(bytes_of(value));
    for (std::size_t face = 0; face < faces.count; ++face) {
        const auto size = static_cast<std::uint32_t>(faces[face].size());
        file.write(is_short ? bytes_of(static_cast<std::uint8_t>(size)) : bytes_of(size));
        for (const Index corner : faces[face])
            file.write(bytes_of(corner));
    }
    file.commit();
}

void write_stl(const Path& path, const SurfaceFaces& faces) {
    AtomicFile file(path);
    file.write(fmt::format("{:80}", "binary STL"));
    file.write(bytes_of(static_cast<std::uint32_t>(faces.count)));
    for (std::size_t face = 0; face < faces.count; ++face) {
        const auto corners = faces[face];
        const Eigen::Vector3d origin = padded(faces.points, corners[0]);
        const Eigen::Vector3d normal = (padded(faces.points, corners[1]) - origin)
                                           .cross(padded(faces.points, corners[2]) - origin)
                                           .stableNormalized();
        for (const double value : normal)
            file.write(bytes_of(std::isfinite(value) ? static_cast<float>(value) : 0.0F));
        const Eigen::Matrix3f places = in_floats(path, faces.points, corners);
        for (const float value : places.reshaped())
            file.write(bytes_of(value));
        file.write(bytes_of(std::uint16_t{0}));
    }
    file.commit();
}

void write_nsc(const Path& path, const Mesh& mesh) {
    NumberLines lines(path);
    lines.text(fmt::format("{} {} {} {}\n", mesh.ambient_dimension(), mesh.dimension(),
                           mesh.points.rows(), mesh.simplices.rows()));
    write_vertices(lines, mesh.points, mesh.points.cols());
    for (Eigen::Index cell = 0; cell < mesh.simplices.rows(); ++cell) {
        lines.numbers(mesh.simplices.row(cell));
        lines.end();
    }
    lines.commit();
}

void write_medit_cells(NumberLines& lines, const Simplices& cells, const std::vector<Index>& tags) {
    constexpr const char* keywords[] = {"Edges", "Triangles", "Tetrahedra"};
    lines.text(fmt::format("{}\n{}\n", keywords[cells.cols() - 2], cells.rows()));
    for (Eigen::Index cell = 0; cell < cells.rows(); ++cell) {
        for (const Index vertex : cells.row(cell))
            lines.number(std::int64_t{vertex} + 1);
        lines.number(tags.empty() ? 0 : tags[cell]);
        lines.end();
    }
}

void write_medit(const Path& path, const Mesh& mesh) {
    const auto axes = mesh.ambient_dimension();
    const auto dimension = mesh.dimension();
    if (axes < 2 || axes > 3 || dimension < 1 || dimension > 3)
        refuse_writing(path, fmt::format("MEDIT holds edges, triangles and tetrahedra in R^2 and "
                                         "R^3, not {}-simplices in R^{}; use .nsc",
                                         dimension, axes));
    if (dimension == 1 && !mesh.facet_tags.tags.empty())
        refuse_writing(path,
                       "MEDIT holds no groups of the vertices of a curve; clear its facet_tags");
    NumberLines lines(path);
    lines.text(fmt::format("MeshVersionFormatted 2\nDimension {}\nVertices\n{}\n", axes,
                           mesh.points.rows()));
    write_vertices(lines, mesh.points, axes, "", " 0");
    write_medit_cells(lines, mesh.simplices, mesh.tags);
    if (!mesh.facet_tags.tags.empty())
        write_medit_cells(lines, mesh.facet_tags.simplices, mesh.facet_tags.tags);
    lines.text("End\n");
    lines.commit();
}

void write_surface(const Path& path, const std::string& extension, const SurfaceFaces& faces) {
    if (extension == ".off")
        write_off(path, faces);
    else if (extension == ".obj")
        write_obj(path, faces);
    else if (extension == ".ply")
        write_ply(path, faces);
    else
        write_stl(path, faces);
}

} // namespace

void write_mesh(const std::filesystem::path& path, const Mesh& mesh) {
    check_points(path, mesh.points);
    check_simplices(path, mesh);
    if (!mesh.tags.empty() && static_cast<Eigen::Index>(mesh.tags.size()) != mesh.simplices.rows())
        refuse_writing(
            path, fmt::format("{} tags are given for {} simplices; expected one for each, or none",
                              mesh.tags.size(), mesh.simplices.rows()));
    check_facet_tags(mesh);
    const auto extension = lower_extension(path);
    if (extension == ".nsc") {
        write_nsc(path, mesh);
    } else if (extension == ".pdm") {
        write_pdm(path, mesh);
    } else if (extension == ".mesh") {
        write_medit(path, mesh);
    } else if (extension == ".off" || extension == ".obj" || extension == ".ply" ||
               extension == ".stl") {
        const bool has_lines = extension == ".obj" && mesh.dimension() == 1;
        if ((mesh.dimension() != 2 && !has_lines) || mesh.ambient_dimension() > 3)
            refuse_writing(
                path,
                fmt::format("{} holds triangles in R^2 and R^3, not {}-simplices in R^{}; use .nsc",
                            extension, mesh.dimension(), mesh.ambient_dimension()));
        const auto corners = static_cast<std::size_t>(mesh.simplices.size());
        const auto size = static_cast<std::size_t>(mesh.simplices.cols());
        write_surface(
            path, extension,
            {mesh.points, {mesh.simplices.data(), corners}, corners / size, nullptr, size});
    } else {
        refuse_writing(path, fmt::format("'{}' is not the extension of a mesh format; use .off, "
                                         ".obj, .ply, .stl, .mesh, .nsc or .pdm",
                                         extension));
    }
}

void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh) {
    check_polygons(mesh);
    check_points(path, mesh.points);
    const auto extension = lower_extension(path);
    if (extension != ".off" && extension != ".obj" && extension != ".ply")
        refuse_writing(
            path, fmt::format(
                      "'{}' is not the extension of a format for polygons; use .off, .obj or .ply",
                      extension));
    if (mesh.points.cols() > 3)
        refuse_writing(
            path, fmt::format(
                      "{} holds polygons in R^2 and R^3, not in R^{}; write the triangles as .nsc",
                      extension, mesh.points.cols()));
    write_surface(path, extension,
                  {mesh.points, mesh.corners, mesh.offsets.size() - 1, &mesh.offsets});
}

} // namespace polydec
