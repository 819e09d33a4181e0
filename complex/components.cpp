// SPDX-License-Identifier: MIT
#include "complex/components.h"

#include "base/checks.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <iterator>

namespace polydec {

namespace {

/// Components of the graph of marked vertices and edges.
template <class Vertex, class Edge>
Components graph_components(const CellComplex& complex, Vertex has_vertex, Edge has_edge) {
    const Incidences& D = complex.incidences(0);
    DisjointSets sets(complex.size(0));
    for (Index e = 0; e < D.rows(); ++e) {
        const IncidenceRow ends = D[e];
        for (Index i = 1; i < ends.size() && has_edge(e); ++i)
            sets.join(ends[0].face, ends[i].face);
    }

    Components result{0, std::vector<Index>(complex.size(0), -1)};
    std::vector<Index> number(complex.size(0), -1);
    for (Index v = 0; v < complex.size(0); ++v) {
        if (!has_vertex(v))
            continue;
        Index& of_root = number[sets.find(v).element];
        if (of_root < 0)
            of_root = result.count++;
        result.of_vertex[v] = of_root;
    }
    return result;
}

} // namespace

CellMarks no_marks(const CellComplex& complex) {
    CellMarks marks;
    for (int k = 0; k <= complex.dimension(); ++k)
        marks.emplace_back(complex.size(k), false);
    return marks;
}

void check_marks(const CellComplex& complex, const CellMarks& marks) {
    check_as_many("lists of marked cells", std::ssize(marks), complex.dimension() + 1);
    for (int k = 0; k <= complex.dimension(); ++k)
        check_as_many(fmt::format("marks of {}-cells", k), std::ssize(marks[k]), complex.size(k));
}

void mark_faces(const CellComplex& complex, CellMarks& marks) {
    check_marks(complex, marks);
    for (int k = complex.dimension(); k > 0; --k) {
        const Incidences& D = complex.incidences(k - 1);
        for (Index t = 0; t < complex.size(k); ++t)
            if (marks[k][t])
                for (const SignedFace& s : D[t])
                    marks[k - 1][s.face] = true;
        for (const auto& [t, s] : complex.canceled(k - 1))
            if (marks[k][t])
                marks[k - 1][s] = true;
    }
}

std::vector<BoundaryFacet> boundary_facets(const CellComplex& complex) {
    const int n = complex.dimension();
    std::vector<BoundaryFacet> facets;
    std::vector<Index> place(static_cast<std::size_t>(complex.size(n - 1)), -1);
    for (Index f = 0; f < complex.size(n - 1); ++f)
        if (complex.coface_counts(n - 1)[f] == 1) {
            place[f] = static_cast<Index>(facets.size());
            facets.push_back({f, -1, 0});
        }
    for (Index t = 0; !facets.empty() && t < complex.size(n); ++t)
        for (const auto& [f, sign] : complex.incidences(n - 1)[t])
            if (place[f] >= 0)
                facets[place[f]] = {f, t, sign};
    return facets;
}

CellMarks boundary_cells(const CellComplex& complex) {
    const int n = complex.dimension();
    CellMarks marks = no_marks(complex);
    const CofaceCounts& counts = complex.coface_counts(n - 1);
    for (std::size_t f = 0; f < counts.size(); ++f)
        marks[n - 1][f] = counts[f] == 1;
    mark_faces(complex, marks);
    return marks;
}

Components components(const CellComplex& complex) {
    const auto all = [](Index) { return true; };
    return graph_components(complex, all, all);
}

Components boundary_components(const CellComplex& complex) {
    // in dimension 1 the edges are the top cells, none of which is marked
    const auto marks = boundary_cells(complex);
    return graph_components(
        complex, [&](Index v) { return marks[0][v]; }, [&](Index e) { return marks[1][e]; });
}

} // namespace polydec
