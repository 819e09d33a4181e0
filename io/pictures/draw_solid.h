// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "io/pictures/svg_drawing.h"
#include "meshes/polygons.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Polygons in space that are to be seen, e.g. the surface of a solid.
struct SolidFaces {
    PolygonMesh polygons;                ///< three coordinates a point
    Vector values = {};                  ///< of each polygon, shown as a color; or empty
    std::vector<std::string> fills = {}; ///< of each polygon a color "#rrggbb", "": that of its
                                         ///< value; or empty
    /// Of each polygon the place whose depth says when it is painted; empty: the mean of its
    /// corners.
    Points depth_sites = {};
    /// Corners run counterclockwise seen from outside: what is turned away is hidden and left out.
    bool closed = false;
    std::vector<Index> cells = {}; ///< of each polygon the n-cell behind it; or empty
};

/// The faces with exactly one kept cell behind them: the surface, closed, of what is left if all
/// cells but those are cut away whose centroids `keep` is true of. `values`, if any, are those of
/// the merged 3-cells, e.g. a dual 0-form. Linear time.
///
/// They are painted cell after cell by the depth of the circumcenters. In a Delaunay mesh no cell
/// hides one that is painted later (Edelsbrunner 1990, An acyclicity theorem for cell complexes).
/// Throws InvalidInput unless cells and space have three dimensions and there are as many values as
/// cells, or none; and if nothing is kept.
SolidFaces kept_faces(const Discretization& mesh,
                      const std::function<bool(const Vector& centroid)>& keep,
                      const Vector& values = {});

/// All faces of each kept cell, shrunk towards its centroid by the part 0 <= gap < 1, so that cells
/// and their shapes are seen one by one. Throws like kept_faces, and for another gap.
SolidFaces kept_cells(const Discretization& mesh,
                      const std::function<bool(const Vector& centroid)>& keep, double gap,
                      const Vector& values = {});

/// Colors by value, which the color-blind can tell apart.
enum class ColorMap {
    sequential, ///< from light to dark
    diverging,  ///< blue below the middle, light there, orange above
};

/// The color "#rrggbb" of a number from 0 to 1; those outside are as the nearer end.
/// Throws InvalidInput if it is NaN.
std::string color_at(ColorMap map, double t);

/// From where a solid is seen, without perspective, and how it is painted.
struct SolidView {
    Vector eye = Eigen::Vector3d(1.0, -2.0, 1.2); ///< direction from the solid to the eye
    Vector up = Eigen::Vector3d(0.0, 0.0, 1.0);   ///< direction that points upwards in the picture
    std::optional<ColorMap> map = {}; ///< by default diverging if values have both signs
    /// The values at the ends of the color map; by default their extremes, in a diverging one plus
    /// and minus the largest.
    std::optional<SvgPoint> range = {};
    std::string plain = "#e4e9ef"; ///< color of polygons without value
    std::string line = "#333333";  ///< color of edges; none: no edges
    double line_width = 0.7;       ///< pixels
    bool legend = true;            ///< whether a bar with the range is below, if there are values
    std::string title = {};
    double width = 720; ///< of the drawing, pixels
};

/// Where a point is seen: to the right and up. Throws InvalidInput for a point, an eye or an upward
/// direction that are not three finite numbers, and if both directions are parallel.
SvgPoint seen_at(const SolidView& view, const Vector& point);

/// The numbers of the polygons to be painted, from far to near; those of closed surfaces that are
/// turned away are left out. O(p log p) for p polygons. Throws like draw_solid.
std::vector<Index> painting_order(const SolidFaces& faces, const SolidView& view = {});

/// The picture of the polygons, the nearer over the farther ones, lit from the upper left. The
/// shapes are those of painting_order, then the legend's; add others (see seen_at) at will.
/// Throws InvalidInput, naming the polygon, for corners that check_polygons refuses, points that
/// are not in space or not finite, values, colors or places that are not one for each polygon, and
/// values that are not finite; and like seen_at.
SvgDrawing draw_solid(const SolidFaces& faces, const SolidView& view = {});

} // namespace polydec
