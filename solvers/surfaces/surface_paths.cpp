// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/parallel.h"
#include "dec/discretization/cell_data.h"
#include "meshes/unit_of_length.h"
#include "shape/geodesics.h"
#include "solvers/surfaces/geodesic_distance.h"

namespace polydec {

namespace {

Triangles triangles_of(const Discretization& mesh) {
    if (mesh.places().points.cols() == 0)
        throw InvalidInput("only lengths of the surface are known, so paths have no positions in "
                           "space: use ShortestPaths");
    return Triangles(mesh.input());
}

/// The corner of a simplex, in vertex order, where a half-edge begins.
int corner(const Pieces& pieces, Index halfedge) {
    const int i = halfedge % 3;
    return pieces.orientation(Triangles::triangle(halfedge)) > 0 ? i : (3 - i) % 3;
}

} // namespace

struct SurfacePaths::Parts {
    Discretization mesh;
    Triangles surface;
    ShortestPaths paths;

    Parts(const Discretization& given, std::span<const Index> sources, const Progress& progress)
        : mesh(given),
          surface(triangles_of(given)),
          paths(surface, given.input_geometry().volumes().primal(1), sources, progress) {}

    /// The point of the tail of a half-edge, as a row; in the unit of the mesh.
    Eigen::RowVectorXd place(Index halfedge) const {
        const PlacedSimplices places = mesh.places();
        const Index row =
            places.corners(Triangles::triangle(halfedge), corner(mesh.input(), halfedge));
        return places.points.row(row);
    }

    Eigen::RowVectorXd place(const SidePoint& point) const {
        return (1 - point.fraction) * place(point.halfedge) +
               point.fraction * place(Triangles::next(point.halfedge));
    }
};

SurfacePaths::SurfacePaths(const Discretization& mesh, std::span<const Index> sources,
                           const Progress& progress)
    : parts_(std::make_shared<Parts>(mesh, sources, progress)) {}

SurfacePath SurfacePaths::from(Index vertex) const {
    const Parts& parts = *parts_;
    const ShortestPath path = parts.paths.from(vertex);
    SurfacePath drawn{path.source, path.length * parts.mesh.unit(), {}};
    Points& points = drawn.lines.points;
    points.resize(2 * std::ssize(path.pieces), parts.mesh.ambient_dimension());
    Index count = 0;
    for (const PathPiece& piece : path.pieces) {
        points.row(2 * count) = parts.place(piece.begin);
        points.row(2 * count + 1) = parts.place(piece.end);
        const double length = (points.row(2 * count + 1) - points.row(2 * count)).norm();
        if (length > 1e-12 * path.length) // else through a vertex
            ++count;
    }
    points.conservativeResize(2 * Eigen::Index(count), Eigen::NoChange);
    points *= parts.mesh.unit();
    drawn.lines.simplices.resize(count, 2);
    for (Index i = 0; i < count; ++i)
        drawn.lines.simplices.row(i) << 2 * i, 2 * i + 1;
    return drawn;
}

LevelSets SurfacePaths::isolines(const Vector& levels, Index divisions) const {
    check_number("the divisions of a triangle", divisions, 1, 1000);
    const Parts& parts = *parts_;
    const Index triangles = parts.surface.triangles();
    const Index points = (divisions + 1) * (divisions + 2) / 2;
    Mesh fine;
    fine.points.resize(Eigen::Index(points) * triangles, parts.mesh.ambient_dimension());
    fine.simplices.resize(Eigen::Index(divisions) * divisions * triangles, 3);
    Vector values(fine.points.rows());
    for_each_part(triangles, 64, [&](Index begin, Index end) {
        for (Index t = begin; t < end; ++t) {
            Index row = points * t, simplex = divisions * divisions * t;
            for (Index i = 0; i <= divisions; ++i)
                for (Index j = 0; j <= divisions - i; ++j, ++row) {
                    const Eigen::Vector3d at =
                        Eigen::Vector3d(divisions - i - j, i, j) / double(divisions);
                    values[row] = parts.paths.at(t, at) * parts.mesh.unit();
                    fine.points.row(row) = at[0] * parts.place(3 * t) +
                                           at[1] * parts.place(3 * t + 1) +
                                           at[2] * parts.place(3 * t + 2);
                    const Index behind = row + divisions - i + 1; // the same j at the next i
                    if (j < divisions - i)
                        fine.simplices.row(simplex++) << row, behind, row + 1;
                    if (j > 0 && j < divisions - i)
                        fine.simplices.row(simplex++) << row, behind - 1, behind;
                }
        }
    });
    fine.points *= parts.mesh.unit();
    LevelSets sets = level_sets(fine, values, levels);
    for (Index& owner : sets.owners)
        owner /= divisions * divisions;
    return sets;
}

} // namespace polydec
