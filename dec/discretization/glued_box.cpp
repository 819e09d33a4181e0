// SPDX-License-Identifier: MIT
#include "dec/discretization/glued_box.h"

#include "base/checks.h"
#include "base/lists.h"
#include "base/permutation_sign.h"
#include "complex/blocks.h"
#include "dec/merging/merged_cells.h"
#include "dec/merging/merged_tags.h"
#include "dec/metric/geometry.h"
#include "dec/metric/plane.h"
#include "dec/metric/simplex_faces.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace polydec {

namespace {

/// For each row of the input its n-simplex.
std::vector<Index> simplices_of_rows(const SimplicialComplex& complex) {
    std::vector<Index> result(static_cast<std::size_t>(complex.size(complex.dimension())));
    for (Index t = 0; t < std::ssize(result); ++t)
        result[complex.input_row(t)] = t;
    return result;
}

/// An n-simplex of the glued mesh in the box: for each of its corners the position among the
/// corners there.
std::vector<int> places_of_corners(const SimplicialComplex& box, Index in_box,
                                   const SimplicialComplex& glued, Index t,
                                   const std::vector<Index>& vertices) {
    const int n = box.dimension();
    std::vector<int> result;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            if (vertices[box.vertex_number(box.simplices(n)(in_box, i))] ==
                glued.vertex_number(glued.simplices(n)(t, j)))
                result.push_back(i);
    check_as_many("corners of a simplex in its box", std::ssize(result), n + 1);
    return result;
}

/// The cells of the glued mesh, cut along the seams.
template <class Onto>
Merging cut_cells(const SimplicialComplex& box, const Merging& glued, Onto onto) {
    const int n = box.dimension();
    if (glued.is_identity())
        return Merging(box);
    const auto dimension_of_cell = [&](int k, Index s) {
        return glued.carriers(k)[onto(k, s)].dimension;
    };
    std::vector<bool> removed;
    for (Index f = 0; f < box.size(n - 1); ++f)
        removed.push_back(box.coface_counts(n - 1)[f] == 2 && dimension_of_cell(n - 1, f) == n);
    const Blocks blocks = join_blocks(box, removed, [&](int k, Index s, Index, Index) {
        return dimension_of_cell(k - 1, s) == k;
    });
    return inadmissible_blocks(box, blocks).empty() ? Merging(box, blocks) : Merging(box);
}

/// The box with these cells, measured between its points.
Discretization measured(const PeriodicMesh& glued, const Discretization& mesh,
                        const SimplicialComplex& box, const Merging& cells,
                        DegenerateFacets degenerate) {
    const int n = box.dimension();
    const Points by_number = glued.box.points / mesh.unit();
    const auto points = std::make_shared<const Points>(vertex_points(box, by_number));
    const Geometry pieces(box, metric_in_plane(box, points), mesh.options().centers);
    const MergedCells merged(cells, pieces, merged_volumes(cells, pieces.volumes()));
    std::vector<std::string> told; // warnings of the glued mesh, discarded
    auto tags = merged_tags(cells, n, tags_of_cells(box, glued.box.tags), told);
    return Discretization({.input = pieces,
                           .passage = Passage(box),
                           .merged = merged,
                           .input_points = points,
                           .options = mesh.options(),
                           .degenerate = std::move(degenerate),
                           .tags = std::move(tags),
                           .unit = mesh.unit(),
                           .isolated = isolated_points(box, glued.box.points),
                           .groups = mesh.groups(),
                           .bisections = mesh.bisections()});
}

} // namespace

GluedBox::Parts GluedBox::parts(const PeriodicMesh& glued, const Discretization& mesh) {
    const SimplicialComplex& K = mesh.input();
    const int n = K.dimension();
    SimplicialComplex box(glued.box.simplices);
    check_as_many("cells of a quotient", K.size(n), box.size(n));
    const auto rows = simplices_of_rows(K);
    std::vector<Index> tops;              // for each n-simplex of the box
    std::vector<std::vector<int>> places; // of its corners
    std::vector<std::int8_t> orientations;
    Simplices corners(K.size(n), n + 1);
    for (Index i = 0; i < box.size(n); ++i) {
        const Index t = tops.emplace_back(rows[box.input_row(i)]);
        const auto& own = places.emplace_back(places_of_corners(box, i, K, t, glued.vertices));
        orientations.push_back(static_cast<std::int8_t>(permutation_sign(own) * K.orientation(t)));
        for (int j = 0; j <= n; ++j)
            corners(t, j) = box.simplices(n)(i, own[j]);
    }
    box = box.oriented(std::move(orientations), K.orientable());

    std::vector<Map> maps;
    for (int k = 0; k <= n; ++k) {
        Map& map = maps.emplace_back();
        map.onto.resize(static_cast<std::size_t>(box.size(k)));
        map.signs.resize(map.onto.size());
        map.size = K.size(k);
        SimplexFaces in_box(box, n, k), in_glued(K, n, k);
        for (Index i = 0; i < box.size(n); ++i) {
            const auto& faces = in_glued.of(tops[i]);
            const auto& others = in_box.of(i);
            for (std::size_t f = 0; f < faces.size(); ++f) {
                std::vector<int> position; // position of the face in the box
                for (const int corner : in_glued.positions()[f])
                    position.push_back(places[i][corner]);
                const double sign = permutation_sign(position);
                std::sort(position.begin(), position.end());
                const Index s = others[place_in(in_box.positions(), position)];
                map.onto[s] = faces[f];
                map.signs[s] = k < n ? static_cast<std::int8_t>(sign) : std::int8_t{1};
            }
        }
    }
    const auto onto = [&](int k, Index s) { return maps[k].onto[s]; };
    Merging cells = cut_cells(box, mesh.merging(), onto);
    DegenerateFacets degenerate;
    for (Index f = 0; f < box.size(n - 1); ++f)
        degenerate.marks.push_back(mesh.degenerate()[onto(n - 1, f)]);
    return {measured(glued, mesh, box, std::move(cells), std::move(degenerate)), std::move(maps),
            std::move(corners)};
}

namespace {

DenseMatrix at_first(const GluedBox::Map& map, const DenseMatrix& values) {
    const auto& [onto, signs, size] = map;
    check_as_many("values on a box", values.rows(), std::ssize(onto));
    DenseMatrix result(size, values.cols());
    for (auto s = std::ssize(onto) - 1; s >= 0; --s) // the first one wins
        result.row(onto[s]) = signs[s] * values.row(s);
    return result;
}

} // namespace

GluedBox::GluedBox(const PeriodicMesh& glued, const Discretization& mesh)
    : parts_(parts(glued, mesh)),
      vertices_(at_first(parts_.maps[0], parts_.mesh.measured_input_points())) {}

const GluedBox::Map& GluedBox::map(int k) const& {
    check_number("the simplices of a box of degree", k, 0, mesh().dimension());
    return parts_.maps[k];
}

const Discretization& placed(const Discretization& mesh) {
    return mesh.box() ? mesh.box()->mesh() : mesh;
}

std::vector<Index> cells_of_places(const Discretization& mesh, int k) {
    std::vector<Index> result;
    const Merging& cells = placed(mesh).merging();
    for (Index cell = 0; cell < cells.diamond(k).rows(); ++cell) {
        if (!mesh.box()) {
            result.push_back(cell);
            continue;
        }
        const Index first = cells.pieces_of(k, cell).front();
        const auto& carrier = mesh.merging().carriers(k)[mesh.box()->map(k).onto[first]];
        result.push_back(carrier.dimension == k ? carrier.cell : -1);
    }
    return result;
}

DenseMatrix to_places(const Discretization& mesh, int k, const DenseMatrix& values) {
    if (!mesh.box())
        return values;
    const auto& [onto, signs, size] = mesh.box()->map(k);
    check_as_many("values on a glued mesh", values.rows(), size);
    DenseMatrix result(std::ssize(onto), values.cols());
    for (std::size_t s = 0; s < onto.size(); ++s)
        result.row(s) = signs[s] * values.row(onto[s]);
    return result;
}

DenseMatrix from_places(const Discretization& mesh, int k, const DenseMatrix& values) {
    return mesh.box() ? at_first(mesh.box()->map(k), values) : values;
}

DenseMatrix sums_from_places(const Discretization& mesh, int k, const DenseMatrix& values) {
    if (!mesh.box())
        return values;
    const auto& [onto, signs, size] = mesh.box()->map(k);
    check_as_many("values on a box", values.rows(), std::ssize(onto));
    DenseMatrix result = DenseMatrix::Zero(size, values.cols());
    for (std::size_t s = 0; s < onto.size(); ++s)
        result.row(onto[s]) += signs[s] * values.row(s);
    return result;
}

} // namespace polydec
