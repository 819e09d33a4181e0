// SPDX-License-Identifier: MIT
#include "meshes/generate.h"
#include "meshes/generate_parts.h"

#include <cmath>
#include <vector>

namespace polydec {

namespace {

/// Hexagons stand on a corner. Row r has vertical sides with a lower and an upper end; in even
/// rows they are at the multiples of the column width, in odd rows half a column to the right.
class HexagonRows {
public:
    explicit HexagonRows(Index columns) : columns_(columns) {
        // Rows that make regular hexagons; an odd number of them, since a row of halves with a
        // flat end would have corners on no circle.
        const double regular = (columns * std::sqrt(3.0) + 0.5) / 1.5;
        rows_ = 2 * static_cast<Index>(std::lround((regular - 1.0) / 2.0)) + 1;

        // With sides of height a and slants of height b, corners are concyclic iff b (a + b) is
        // the square of half the column width; and the rows fill the unit square.
        const double q = rows_ / (static_cast<double>(columns) * columns);
        slant_ = 0.5 * q / (1.0 + std::sqrt(1.0 + q));
        side_ = (1.0 - (rows_ - 1) * slant_) / rows_;
    }

    Index rows() const { return rows_; }
    Index polygons(Index row) const { return columns_ + row % 2; }
    double vertices() const { return 2.0 * rows_ * columns_ + rows_ + 1.0; }
    double triangles() const { return 4.0 * columns_ * rows_ - 2.0 * columns_; }

    Points points() const {
        Points points(static_cast<Index>(vertices()), 2);
        for (Index row = 0; row < rows_; ++row)
            for (Index end = 0; end < 2; ++end)
                for (Index i = 0; i < sides(row); ++i)
                    points.row(vertex(row, end, i)) << (i + 0.5 * (row % 2)) / columns_,
                        height(2 * row + end);
        return points;
    }

    /// Corners counterclockwise, from the lower left side onwards, as far as there are any.
    std::vector<Index> corners(Index row, Index i) const {
        const bool odd = row % 2 == 1;
        const Index left = odd ? i - 1 : i;
        const Index right = left + 1;
        const bool has_left = left >= 0, has_right = right < sides(row);

        std::vector<Index> result;
        if (has_left)
            result.push_back(vertex(row, 0, left));
        if (row > 0)
            result.push_back(vertex(row - 1, 1, i));
        if (has_right) {
            result.push_back(vertex(row, 0, right));
            result.push_back(vertex(row, 1, right));
        }
        if (row + 1 < rows_)
            result.push_back(vertex(row + 1, 0, i));
        if (has_left)
            result.push_back(vertex(row, 1, left));
        return result;
    }

private:
    Index sides(Index row) const { return columns_ + 1 - row % 2; }

    Index vertex(Index row, Index end, Index i) const {
        const Index sides_below = row * columns_ + (row + 1) / 2;
        return 2 * sides_below + end * sides(row) + i;
    }

    /// Height of the ends of the sides, counted upwards; symmetric about the middle.
    double height(Index level) const {
        if (level >= rows_)
            return 1.0 - height(2 * rows_ - 1 - level);
        return level / 2 * (side_ + slant_) + level % 2 * side_;
    }

    Index columns_;
    Index rows_;
    double side_;
    double slant_;
};

} // namespace

Mesh grid(int nx, int ny, double width, double height) {
    check_count("grid", "nx", nx, 1);
    check_count("grid", "ny", ny, 1);
    check_length("grid", "width", width);
    check_length("grid", "height", height);
    check_sizes("grid", (nx + 1.0) * (ny + 1.0), 2.0 * nx * ny);
    return kuhn({nx, ny}, {width, height});
}

Mesh hexagons(int columns) {
    // Beyond the upper end the number of rows would not fit into an Index either.
    check_count("hexagons", "columns", columns, 2, 1'000'000'000);
    const HexagonRows hexagon_rows(columns);
    check_sizes("hexagons", hexagon_rows.vertices(), hexagon_rows.triangles());

    Mesh mesh;
    mesh.points = hexagon_rows.points();
    mesh.simplices.resize(static_cast<Index>(hexagon_rows.triangles()), 3);
    Index triangle = 0;
    for (Index row = 0; row < hexagon_rows.rows(); ++row)
        for (Index i = 0; i < hexagon_rows.polygons(row); ++i) {
            const std::vector<Index> corners = hexagon_rows.corners(row, i);
            for (std::size_t c = 2; c < corners.size(); ++c)
                mesh.simplices.row(triangle++) << corners[0], corners[c - 1], corners[c];
        }
    return mesh;
}

Mesh well_centered(int rows) {
    check_count("well_centered", "rows", rows, 2, 1'000'000'000);

    // Long rows of m vertices, whose ends are the boundary, and short rows of m - 1 between them.
    // A short row begins 0.95 steps inside, which keeps the triangles at the boundary acute.
    const auto m = static_cast<Index>(std::lround(std::sqrt(3.0) * rows));
    check_sizes("well_centered", rows * (2.0 * m - 1.0) + m, 4.0 * rows * (m - 1.0));
    const auto long_row = [m](Index row, Index i) { return row * (2 * m - 1) + i; };
    const auto short_row = [m](Index row, Index i) { return row * (2 * m - 1) + m + i; };

    Mesh mesh;
    mesh.points.resize(long_row(rows, m), 2);
    for (Index row = 0; row <= rows; ++row) {
        for (Index i = 0; i < m; ++i)
            mesh.points.row(long_row(row, i)) << (20.0 * i + 9.0) / (20.0 * m - 2.0),
                static_cast<double>(row) / rows;
        mesh.points(long_row(row, 0), 0) = 0.0;
        mesh.points(long_row(row, m - 1), 0) = 1.0;
        for (Index i = 0; i + 1 < m && row < rows; ++i)
            mesh.points.row(short_row(row, i)) << (20.0 * i + 19.0) / (20.0 * m - 2.0),
                (row + 0.5) / rows;
    }

    mesh.simplices.resize(4 * rows * (m - 1), 3);
    Index triangle = 0;
    const auto add = [&](Index a, Index b, Index c) { mesh.simplices.row(triangle++) << a, b, c; };
    for (Index row = 0; row < rows; ++row) {
        for (Index i = 0; i + 1 < m; ++i) {
            const Index middle = short_row(row, i);
            add(long_row(row, i), long_row(row, i + 1), middle);
            add(long_row(row + 1, i + 1), long_row(row + 1, i), middle);
            if (i + 2 == m)
                continue;
            add(short_row(row, i + 1), middle, long_row(row, i + 1));
            add(middle, short_row(row, i + 1), long_row(row + 1, i + 1));
        }
        add(long_row(row + 1, 0), long_row(row, 0), short_row(row, 0));
        add(long_row(row, m - 1), long_row(row + 1, m - 1), short_row(row, m - 2));
    }
    return mesh;
}

} // namespace polydec
