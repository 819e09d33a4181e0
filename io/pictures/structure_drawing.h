// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_structure.h"
#include "io/pictures/dual_rings.h"
#include "io/pictures/structure_style.h"
#include "io/pictures/svg_layout.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// What a cell has over its own ground, in the order in which it is painted.
struct Strokes {
    std::vector<SvgShape> lines, marks;
};

/// A drawing while it is made: of a chain of edges, n = 1, or of a surface, n = 2.
class StructureDrawing {
public:
    StructureDrawing(const Discretization& mesh, const StructureOptions& options);

    SvgDrawing draw();

private:
    using Point = Eigen::Vector3d;

    Point at(const Points& rows, Index row) const {
        Point result = Point::Zero();
        result.head(rows.cols()) = rows.row(row);
        return result;
    }
    SvgPoint seen(const Point& point) const { return seen_at(view_, point); }
    std::pair<Index, Index> ends(Index edge) const;
    std::vector<Index> edges_of(Index cell) const;
    std::vector<Index> numbered_at(int k, Index cell) const;
    double middling_edge() const;
    void fill_dual(const Discretization& given);
    void find_extent();
    void choose_text_size(std::size_t rows_of_words);
    bool is_closed() const;
    bool is_negative(Index facet) const;
    /// Whether the dual of a facet ends in a cell with this sign, by dual_derivative.
    bool is_end_of_dual(int sign) const;
    std::vector<std::vector<Index>> layers() const;
    std::ptrdiff_t layer_to_fill(const std::vector<std::vector<Index>>& layers) const;

    SvgShape ground(Index cell) const;
    Strokes strokes(Index cell) const;
    std::vector<SvgShape> filled() const;
    void append(std::vector<SvgShape>& shapes) {
        std::move(shapes.begin(), shapes.end(), std::back_inserter(drawing_.shapes));
    }
    void add_removed(Index cell, Strokes& strokes) const;
    void add_duals(Index cell, Strokes& strokes) const;
    void add_circle(Index cell, Strokes& strokes) const;
    void add_orientations(Index cell, Strokes& strokes) const;
    Point middle(Index cell) const;
    std::vector<SvgPoint> arc(const Point& center, const Point& u, const Point& w, double begin,
                              double end, int parts) const;
    std::vector<LineInWords> words() const;

    std::vector<SvgPoint> wishes(int k, Index cell) const;
    void add_numbers(const std::vector<std::vector<Index>>& layers);
    void add_number(const std::string& text, const char* color, const std::vector<SvgPoint>& places,
                    SvgObstacles& taken);

    const Discretization& mesh_;
    const int n_;
    const Points& points_; // of its vertices, in its unit
    StructureOptions options_;
    SolidView view_;
    bool is_plane_;
    std::array<Points, 3> centers_;                     ///< by degree
    std::vector<std::vector<Index>> corners_, removed_; ///< of each cell; edges of the pieces
    std::vector<std::vector<DualCorner>> rings_;        ///< of the dual cell that is filled
    std::vector<bool> ends_in_cell_;                    ///< the dual of each facet
    std::array<std::vector<Index>, 3> numbers_;         ///< of the cells, in the mesh that is given
    SvgExtent extent_;
    double text_size_ = 12, pixel_ = 1; ///< pixels; world units a pixel
    SvgDrawing drawing_;
};

} // namespace polydec
