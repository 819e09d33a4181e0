// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "io/pictures/color_map.h"
#include "io/pictures/svg_drawing.h"
#include "meshes/polygons.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Visible polygons in space, e.g. the surface of a solid.
struct SolidFaces {
    PolygonMesh polygons; ///< three coordinates a point
    Vector values = {};   ///< one per polygon, shown as a color; or empty
    std::vector<std::string> fills =
        {}; ///< one color "#rrggbb" per polygon, "" for its value's color; or empty
    /// A point per polygon whose depth sets the painting order; empty: the mean of its corners.
    Points depth_sites = {};
    /// Corners run counterclockwise seen from outside: faces turned away are hidden and omitted.
    bool closed = false;
    std::vector<Index> cells = {}; ///< the n-cell behind each polygon; or empty
};

/// The faces of exactly one kept cell: the closed surface that remains after cutting away the cells
/// whose centroids fail `keep`. `values`, if any, belong to the merged 3-cells, e.g. a dual 0-form.
/// Linear time.
///
/// Cells are painted one after the other by the depth of their circumcenters. In a Delaunay mesh no
/// cell hides one that is painted later (Edelsbrunner 1990, An acyclicity theorem for cell
/// complexes). Throws InvalidInput unless cells and space have three dimensions, for a wrong number
/// of values, for an empty function, and if no cell is kept.
SolidFaces kept_faces(const Discretization& mesh,
                      const std::function<bool(const Vector& centroid)>& keep,
                      const Vector& values = {});

/// All faces of each kept cell, shrunk towards its centroid by the fraction 0 <= gap < 1, so that
/// each cell and its shape are visible. Throws like kept_faces, and for another gap.
SolidFaces kept_cells(const Discretization& mesh,
                      const std::function<bool(const Vector& centroid)>& keep, double gap,
                      const Vector& values = {});

/// The direction of view on a solid, without perspective, and the style.
struct SolidView {
    Vector eye = Eigen::Vector3d(1.0, -2.0, 1.2); ///< direction from the solid to the eye
    /// Upward direction in the picture. Seen along it, y is up, or z if that is seen along y.
    Vector up = Eigen::Vector3d(0.0, 0.0, 1.0);
    std::optional<ColorMap> map = {}; ///< by default from color_range
    /// The values at the ends of the color map; by default their extremes, for a diverging map plus
    /// and minus the largest absolute value.
    std::optional<SvgPoint> range = {};
    std::string plain = "#e4e9ef"; ///< color of polygons without value
    std::string line = "#333333";  ///< color of edges; none: no edges
    double line_width = 0.7;       ///< pixels
    bool legend = true;            ///< a bar with the range below, if there are values
    std::string title = {};
    double width = 720; ///< of the drawing, pixels
};

/// The projection of a point: to the right and up. Throws InvalidInput unless the point, the eye
/// and the upward direction are three finite numbers each, and if both directions are parallel.
SvgPoint seen_at(const SolidView& view, const Vector& point);

/// The polygons to be painted, from far to near; on closed surfaces, only those turned to the eye.
/// O(p log p) for p polygons. Throws like draw_solid.
std::vector<Index> painting_order(const SolidFaces& faces, const SolidView& view = {});

/// The picture of the polygons, painted from far to near, lit from the upper left. The shapes are
/// in painting_order, then the legend; add others as needed (see seen_at). Throws InvalidInput,
/// naming the polygon, like check_polygons, for points that are not in space or not finite, for a
/// wrong number of values, colors or sites, and for values that are not finite; and like seen_at.
SvgDrawing draw_solid(const SolidFaces& faces, const SolidView& view = {});

} // namespace polydec
