// SPDX-License-Identifier: MIT
#include "complex/pieces.h"

#include "base/errors.h"
#include "complex/incidence_rows.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

namespace polydec {

namespace {

using SimplicesByDegree = std::vector<Simplices>; // of degree k at k

void check_tables(const SimplicesByDegree& faces, const std::vector<std::int8_t>& orientations,
                  const std::vector<Index>& vertices) {
    if (faces.size() < 2)
        throw InvalidInput("tables of faces are missing: expected one for each degree from 1");
    for (std::size_t k = 1; k < faces.size(); ++k) {
        const auto lower = faces[k - 1].rows();
        check_as_many(fmt::format("faces of a {}-simplex", k), faces[k].cols(),
                      static_cast<Index>(k) + 1);
        for (Eigen::Index s = 0; s < faces[k].rows(); ++s)
            for (std::size_t i = 0; i <= k; ++i)
                if (const Index f = faces[k](s, static_cast<Eigen::Index>(i)); f < 0 || f >= lower)
                    throw InvalidInput(
                        fmt::format(
                            "face {} of {}-simplex {} is {}: expected a number from 0 to {}", i, k,
                            s, f, lower - 1),
                        {.degree = static_cast<int>(k), .cells = {static_cast<Index>(s)}});
    }
    check_as_many("orientations", static_cast<Index>(orientations.size()), faces.back().rows());
    for (std::size_t t = 0; t < orientations.size(); ++t)
        if (orientations[t] != 1 && orientations[t] != -1)
            throw InvalidInput(
                fmt::format("the orientation of simplex {} is {}: expected 1 or -1", t,
                            int{orientations[t]}),
                {.degree = static_cast<int>(faces.size()) - 1, .cells = {static_cast<Index>(t)}});
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (vertices[v] < 0)
            throw InvalidInput(
                fmt::format("vertex {} has the number {}: expected 0 or more", v, vertices[v]),
                {.vertices = {static_cast<Index>(v)}});
}

/// Face j of face i is face i of face j + 1, for i <= j: the same corners are lacking.
void check_order(const SimplicesByDegree& faces) {
    for (std::size_t k = 2; k < faces.size(); ++k)
        for (Eigen::Index s = 0; s < faces[k].rows(); ++s)
            for (std::size_t j = 0; j < k; ++j)
                for (std::size_t i = 0; i <= j; ++i)
                    if (faces[k - 1](faces[k](s, i), j) != faces[k - 1](faces[k](s, j + 1), i))
                        throw InvalidInput(
                            fmt::format(
                                "the faces of {}-simplex {} opposite its corners {} and {} do not "
                                "meet: list the corners of each face in the order of the simplex",
                                k, s, i, j + 1),
                            {.degree = static_cast<int>(k), .cells = {static_cast<Index>(s)}});
}

/// The corners of each simplex: all but the last are those of the face without it, the last is that
/// of the face without the first.
SimplicesByDegree corners_of(const SimplicesByDegree& faces) {
    SimplicesByDegree corners(faces.size());
    const auto vertices = static_cast<Index>(faces[0].rows());
    corners[0] = Column<Index>::LinSpaced(vertices, 0, vertices - 1);
    for (std::size_t k = 1; k < faces.size(); ++k) {
        const auto width = static_cast<Eigen::Index>(k);
        corners[k].resize(faces[k].rows(), width + 1);
        for (Eigen::Index s = 0; s < faces[k].rows(); ++s) {
            corners[k].row(s).head(width) = corners[k - 1].row(faces[k](s, width));
            corners[k](s, width) = corners[k - 1](faces[k](s, 0), width - 1);
        }
    }
    return corners;
}

/// The list, or none if it is 0, 1, 2, ..
std::vector<Index> unless_counting(std::vector<Index> numbers) {
    for (std::size_t v = 0; v < numbers.size(); ++v)
        if (numbers[v] != static_cast<Index>(v))
            return numbers;
    return {};
}

} // namespace

Pieces Pieces::glued(std::vector<Simplices> faces, std::vector<std::int8_t> orientations,
                     std::vector<Index> vertices) {
    faces.insert(faces.begin(), Simplices(vertices.size(), 0)); // vertices have no faces
    check_tables(faces, orientations, vertices);
    check_order(faces);
    const auto n = static_cast<int>(faces.size()) - 1;
    std::vector<Coboundary> coboundaries;
    for (int k = 1; k <= n; ++k) {
        IncidenceRows rows(static_cast<Index>(faces[k].rows()),
                           static_cast<Index>(faces[k - 1].rows()),
                           static_cast<Index>(faces[k].size()));
        for (Index s = 0; s < faces[k].rows(); ++s) {
            const int own = k == n ? orientations[s] : 1;
            for (int i = 0; i <= k; ++i)
                rows.add(faces[k](s, i), i % 2 == 0 ? own : -own);
            rows.end_cell();
        }
        coboundaries.push_back(rows.finish());
    }

    const CofaceCounts& counts = coboundaries.back().coface_counts;
    std::vector<int> sums(counts.size(), 0);
    for (Index t = 0; t < faces[n].rows(); ++t)
        for (int i = 0; i <= n; ++i)
            sums[faces[n](t, i)] += i % 2 == 0 ? orientations[t] : -orientations[t];
    auto parts = std::make_shared<Parts>();
    for (std::size_t f = 0; f < sums.size(); ++f)
        parts->orientable = parts->orientable && (counts[f] != 2 || sums[f] == 0);
    for (Simplices& corners : corners_of(faces))
        parts->simplices.push_back(std::make_shared<const Simplices>(std::move(corners)));
    parts->vertex_numbers = unless_counting(std::move(vertices));
    parts->faces = std::move(faces);
    parts->orientations = std::make_shared<const Incidences::Signs>(std::move(orientations));
    return {CellComplex(Unchecked{}, std::move(coboundaries)), std::move(parts)};
}

Pieces::Pieces(std::vector<Simplices> faces, std::vector<std::int8_t> orientations,
               std::vector<Index> vertices)
    : Pieces(glued(std::move(faces), std::move(orientations), std::move(vertices))) {}

Pieces::Pieces(Unchecked, CellComplex cells,
               std::vector<std::shared_ptr<const Simplices>> simplices,
               std::shared_ptr<const Incidences::Signs> orientations, bool orientable,
               std::vector<Index> vertex_numbers)
    : Pieces(std::move(cells), std::make_shared<Parts>(Parts{std::move(simplices),
                                                             {},
                                                             std::move(orientations),
                                                             orientable,
                                                             std::move(vertex_numbers)})) {}

Pieces Pieces::with_orientations(std::vector<std::int8_t> orientations, bool orientable) const {
    auto parts = std::make_shared<Parts>(*parts_);
    parts->orientations = std::make_shared<const Incidences::Signs>(std::move(orientations));
    parts->orientable = orientable;
    std::vector<Coboundary> coboundaries;
    for (int k = 0; k < dimension(); ++k)
        coboundaries.push_back({incidences(k), coface_counts(k)});
    Incidences& tops = coboundaries.back().incidences;
    tops = tops.with_signs(parts->orientations);
    return {CellComplex(Unchecked{}, std::move(coboundaries)), std::move(parts)};
}

std::vector<Index> Pieces::vertex_numbers(std::vector<Index> vertices) const {
    for (Index& v : vertices) {
        check_number("vertex", v, 0, size(0) - 1);
        v = vertex_number(v);
    }
    return vertices;
}

std::vector<Index> Pieces::vertex_numbers(int k, Index s) const {
    check_number("simplex", s, 0, size(k) - 1);
    const auto corners = simplices(k).row(s);
    return vertex_numbers(std::vector<Index>(corners.begin(), corners.end()));
}

Cofaces::Cofaces(const Pieces& pieces, int k) {
    const CofaceCounts& counts = pieces.coface_counts(k - 1);
    begins_.assign(counts.size() + 1, 0);
    std::partial_sum(counts.begin(), counts.end(), begins_.begin() + 1);
    cofaces_.resize(static_cast<std::size_t>(begins_.back()));
    const FaceTable faces = pieces.faces(k);
    std::vector<Index> next(begins_.begin(), begins_.end() - 1);
    for (Index t = 0; t < pieces.size(k); ++t)
        for (int i = k; i >= 0; --i)
            cofaces_[next[faces(t, i)]++] = {t, i};
}

} // namespace polydec
