// SPDX-License-Identifier: MIT
#include "meshes/split_cells.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/listed.h"
#include "meshes/edges.h"
#include "meshes/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace polydec {

namespace {

using FacetPlaces = std::vector<std::vector<std::size_t>>;

FacetPlaces sides(std::size_t corners) {
    FacetPlaces facets;
    for (std::size_t i = 0; i < corners; ++i)
        facets.push_back({i, (i + 1) % corners});
    return facets;
}

FacetPlaces pyramid() {
    FacetPlaces facets{{0, 3, 2, 1}};
    for (std::size_t i = 0; i < 4; ++i)
        facets.push_back({i, (i + 1) % 4, 4});
    return facets;
}

FacetPlaces prism(std::size_t base) {
    FacetPlaces facets(2);
    for (std::size_t i = 0; i < base; ++i) {
        facets[0].push_back(base - 1 - i);
        facets[1].push_back(base + i);
        const auto next = (i + 1) % base;
        facets.push_back({i, next, base + next, base + i});
    }
    return facets;
}

/// All shapes by dimension and number of corners.
class Shapes {
public:
    Shapes() {
        for (int n = 0; n <= most_dimensions; ++n)
            add(n, static_cast<std::size_t>(n) + 1, {});
        for (const std::size_t corners : {4, 5, 6})
            add(2, corners, sides(corners));
        add(3, 5, pyramid());
        for (const std::size_t base : {3, 4, 5, 6})
            add(3, 2 * base, prism(base));
    }

    std::shared_ptr<const CellShape> find(int dimension, std::size_t corners) const {
        const auto found = shapes_.find({dimension, corners});
        return found == shapes_.end() ? nullptr : found->second;
    }

private:
    static constexpr int most_dimensions = 3;

    void add(int dimension, std::size_t corners, const FacetPlaces& facets) {
        CellShape shape{dimension};
        for (const auto& facet : facets)
            shape.facets.push_back({find(dimension - 1, facet.size()), facet});
        shapes_[{dimension, corners}] = std::make_shared<const CellShape>(std::move(shape));
    }

    std::map<std::pair<int, std::size_t>, std::shared_ptr<const CellShape>> shapes_;
};

class Puller {
public:
    explicit Puller(std::vector<Index>& simplices) : simplices_(simplices) {}

    void pull(const CellShape& shape, std::span<const Index> corners) {
        if (shape.facets.empty()) {
            add(corners);
            return;
        }
        const Index apex = *std::min_element(corners.begin(), corners.end());
        apexes_.push_back(apex);
        std::vector<Index> own;
        for (const auto& facet : shape.facets) {
            own.clear();
            for (const std::size_t place : facet.corners)
                own.push_back(corners[place]);
            if (std::find(own.begin(), own.end(), apex) == own.end())
                pull(*facet.shape, own);
        }
        apexes_.pop_back();
    }

private:
    /// Apexes differ from all that comes behind them.
    void add(std::span<const Index> corners) {
        for (std::size_t i = 0; !apexes_.empty() && i < corners.size(); ++i)
            if (std::find(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(i),
                          corners[i]) != corners.begin() + static_cast<std::ptrdiff_t>(i))
                return;
        simplices_.insert(simplices_.end(), apexes_.begin(), apexes_.end());
        simplices_.insert(simplices_.end(), corners.begin(), corners.end());
    }

    std::vector<Index>& simplices_;
    std::vector<Index> apexes_;
};

/// Turns the simplices of a solid in R^n around if its volume is negative: programs differ in how
/// they list the corners of wedges.
void orient(const Points& points, int dimension, std::span<Index> simplices) {
    const auto n = static_cast<std::size_t>(dimension);
    if (points.cols() != dimension)
        return;
    double volume = 0.0;
    for (std::size_t s = 0; s < simplices.size(); s += n + 1)
        volume += edges_at_first(points, simplices.subspan(s, n + 1)).determinant();
    for (std::size_t s = 0; volume < 0 && s < simplices.size(); s += n + 1)
        std::swap(simplices[s], simplices[s + 1]);
}

Mesh split_solids(PolygonMesh cells, int dimension) {
    check_polygons(cells);
    Mesh mesh;
    std::vector<Index> simplices, cells_of;
    Tally split, flat;
    for (Index cell = 0; cell < cells.size(); ++cell) {
        const auto corners = cells.face(cell);
        const auto* const shape = cell_shape(dimension, corners.size());
        if (shape == nullptr)
            throw InvalidInput(
                fmt::format(
                    "cell {} has {} corners; expected {} (simplex) or, in space, 5 (pyramid), 6 "
                    "(wedge), 8 (hexahedron), 10 or 12 (prism); split the cell first",
                    cell, corners.size(), dimension + 1),
                {.degree = dimension, .cells = {cell}});
        const auto before = simplices.size();
        pull_cell(*shape, corners, simplices);
        if (simplices.size() == before)
            flat.add(cell);
        else if (!shape->facets.empty()) {
            split.add(cell);
            orient(cells.points, dimension, std::span(simplices).subspan(before));
        }
        cells_of.resize(simplices.size() / (static_cast<std::size_t>(dimension) + 1), cell);
    }
    mesh.tags = std::move(cells.tags);
    follow_rows(mesh, cells_of, cells.size());
    mesh.points = std::move(cells.points);
    mesh.simplices = simplices_of(simplices, dimension + 1);
    if (split.count > 0)
        mesh.warnings.push_back(fmt::format("split {} into tetrahedra; the first is cell {}",
                                            counted(split.count, "solid", "solids"), split.first));
    if (flat.count > 0)
        mesh.warnings.push_back(
            fmt::format("left out {} with too few different corners; the first is cell {}",
                        counted(flat.count, "solid", "solids"), flat.first));
    return mesh;
}

} // namespace

const CellShape* cell_shape(int dimension, std::size_t corners) {
    static const Shapes shapes;
    return shapes.find(dimension, corners).get();
}

CellShape cube_shape(int n) {
    check_number("a cube of dimension", n, 1, 30);
    CellShape shape{n};
    if (n == 1)
        return shape;
    const auto facet = std::make_shared<const CellShape>(cube_shape(n - 1));
    const std::size_t corners = std::size_t{1} << static_cast<unsigned>(n - 1);
    for (int axis = 0; axis < n; ++axis)
        for (std::size_t side = 0; side < 2; ++side) {
            std::vector<std::size_t> places;
            const std::size_t low = (std::size_t{1} << static_cast<unsigned>(axis)) - 1;
            for (std::size_t c = 0; c < corners; ++c)
                places.push_back((c & low) | side << static_cast<unsigned>(axis) |
                                 (c & ~low) << 1U);
            shape.facets.push_back({facet, std::move(places)});
        }
    return shape;
}

void pull_cell(const CellShape& shape, std::span<const Index> corners,
               std::vector<Index>& simplices) {
    Puller(simplices).pull(shape, corners);
}

Mesh split_cells(PolygonMesh cells, int dimension) {
    return dimension == 2 ? split_polygons(std::move(cells))
                          : split_solids(std::move(cells), dimension);
}

TaggedSimplices pull_tagged(const PolygonMesh& cells, int dimension) {
    TaggedSimplices result;
    std::vector<Index> simplices;
    for (Index cell = 0; cell < std::ssize(cells.tags); ++cell) {
        const auto* const shape = cell_shape(dimension, cells.face(cell).size());
        const Index tag = cells.tags[cell];
        if (tag == 0 || shape == nullptr)
            continue;
        pull_cell(*shape, cells.face(cell), simplices);
        result.tags.resize(simplices.size() / (static_cast<std::size_t>(dimension) + 1), tag);
    }
    result.simplices = simplices_of(simplices, dimension + 1);
    return result;
}

} // namespace polydec
