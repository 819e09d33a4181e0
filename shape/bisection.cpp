// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "shape/measured_simplex.h"
#include "shape/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// Simplices of every degree by their faces, and what their parts take over. Corners are in order,
/// and the middle of an edge is the last corner of all around it.
class Bisection {
public:
    explicit Bisection(const Shape& shape);

    void bisect(Index simplex);
    bool is_new(Index simplex, int times) const { return generations_[simplex] >= times; }
    Shape result(const Shape& shape, double error) const;

private:
    /// The half at the first end of the divided edge, the half at its second end, and the simplex
    /// between them, which has the middle and the other corners.
    struct Parts {
        std::array<Index, 2> halves = {-1, -1};
        Index inside = -1;
    };
    struct Degree {
        std::vector<Index> faces;   // k+1 of each simplex, the i-th lacking corner i
        std::vector<Index> parents; // of the input, -1 inside of larger simplices
        std::vector<Index> longest; // edge
        std::vector<Parts> parts;   // of divided simplices; an n-simplex is its own first half
        std::vector<std::vector<Index>> cofaces; // as often as they meet
    };

    int dimension() const { return static_cast<int>(degrees_.size()) - 1; }
    Index face(int k, Index s, int omitted) const {
        return degrees_[k].faces[std::size_t(k + 1) * s + omitted];
    }
    Index edge_at(int k, Index s, int i, int j) const;
    std::array<int, 2> ends_in(int k, Index s, Index edge) const;
    bool is_longer(Index edge, Index other) const;
    Index longer_around(int k, Index s, Index edge) const;
    Index add(int k, Index parent);
    void set_faces(int k, Index s, const std::vector<Index>& faces);
    void join(int k, Index s, Index coface);
    void leave(int k, Index s, Index coface);
    void divide(Index edge);
    void split(int k, Index s, Index edge);
    Index add_inside(int k, const std::vector<Index>& whole, const std::array<int, 2>& ends);
    double median(const std::vector<Index>& edges, int omitted) const;
    double rounding(Index simplex) const;
    std::vector<std::vector<Index>> whole() const;
    Pieces pieces(const Pieces& of, const std::vector<std::vector<Index>>& kept) const;

    std::vector<Degree> degrees_;
    std::vector<double> lengths_;
    std::vector<int> orientations_, generations_; // of n-simplices
    std::vector<double> errors_;                  // of squares within them, as shares
};

Bisection::Bisection(const Shape& shape)
    : degrees_(shape.pieces.dimension() + 1), lengths_(shape.lengths.begin(), shape.lengths.end()) {
    const Pieces& pieces = shape.pieces;
    for (int k = 0; k <= dimension(); ++k)
        for (Index s = 0; s < pieces.size(k); ++s) {
            add(k, s);
            if (k == 0)
                continue;
            std::vector<Index> faces(k + 1);
            for (int i = 0; i <= k; ++i)
                faces[i] = pieces.face(k, s, i);
            set_faces(k, s, faces);
            join(k - 1, faces[k], s);
        }
    for (Index s = 0; s < pieces.size(dimension()); ++s)
        orientations_.push_back(pieces.orientation(s));
    generations_.assign(orientations_.size(), 0);
    errors_.assign(orientations_.size(), 0);
}

Index Bisection::add(int k, Index parent) {
    Degree& all = degrees_[k];
    all.faces.resize(all.faces.size() + k + 1);
    all.parents.push_back(parent);
    all.longest.push_back(-1);
    all.parts.emplace_back();
    all.cofaces.emplace_back();
    return static_cast<Index>(all.parents.size()) - 1;
}

/// And joins it to all but the last of them.
void Bisection::set_faces(int k, Index s, const std::vector<Index>& faces) {
    Degree& all = degrees_[k];
    const auto& below = degrees_[k - 1].longest;
    std::copy(faces.begin(), faces.end(), all.faces.begin() + std::ptrdiff_t(k + 1) * s);
    for (int i = 0; i < k; ++i)
        join(k - 1, faces[i], s);
    all.longest[s] = s;
    if (k > 1)
        all.longest[s] = below[*std::max_element(faces.begin(), faces.end(), [&](Index a, Index b) {
            return is_longer(below[b], below[a]);
        })];
}

/// Nobody looks for what is around a vertex.
void Bisection::join(int k, Index s, Index coface) {
    if (k > 0)
        degrees_[k].cofaces[s].push_back(coface);
}

void Bisection::leave(int k, Index s, Index coface) {
    auto& around = degrees_[k].cofaces[s];
    if (k > 0)
        around.erase(std::find(around.begin(), around.end(), coface));
}

/// Of equally long ones the first, so that all simplices agree.
bool Bisection::is_longer(Index edge, Index other) const {
    return lengths_[edge] > lengths_[other] || (lengths_[edge] == lengths_[other] && edge < other);
}

/// Between two corners, i < j.
Index Bisection::edge_at(int k, Index s, int i, int j) const {
    for (; k > 1; --k) {
        const int omitted = j < k ? k : i < k - 1 ? k - 1 : 0;
        s = face(k, s, omitted);
        j -= omitted < j ? 1 : 0;
        i -= omitted < i ? 1 : 0;
    }
    return s;
}

/// The corners between which a simplex has the edge: of several such pairs the last, so that its
/// faces agree with it.
std::array<int, 2> Bisection::ends_in(int k, Index s, Index edge) const {
    for (int i = k - 1; i > 0; --i)
        for (int j = k; j > i; --j)
            if (edge_at(k, s, i, j) == edge)
                return {i, j};
    int j = k;
    while (edge_at(k, s, 0, j) != edge)
        --j;
    return {0, j};
}

/// The longest edge of an n-simplex around this one, if it is another than `edge`, or -1.
Index Bisection::longer_around(int k, Index s, Index edge) const {
    if (k == dimension())
        return degrees_[k].longest[s] == edge ? -1 : degrees_[k].longest[s];
    for (const Index coface : degrees_[k].cofaces[s])
        if (const Index longer = longer_around(k + 1, coface, edge); longer >= 0)
            return longer;
    return -1;
}

/// Until the simplex is divided: first the last of those to which longer and longer edges lead.
void Bisection::bisect(Index simplex) {
    const int generation = generations_[simplex];
    while (generations_[simplex] == generation) {
        Index edge = degrees_[dimension()].longest[simplex];
        for (Index next = edge; next >= 0; next = longer_around(1, edge, edge))
            edge = next;
        divide(edge);
    }
}

/// Divides an edge, and the simplices around it by ascending degree.
void Bisection::divide(Index edge) {
    std::vector<Index> divided{edge};
    split(1, edge, edge);
    for (int k = 2; k <= dimension(); ++k) {
        std::vector<Index> next;
        for (const Index s : divided)
            while (!degrees_[k - 1].cofaces[s].empty()) { // it may be there twice
                next.push_back(degrees_[k - 1].cofaces[s].back());
                split(k, next.back(), edge);
            }
        divided = std::move(next);
    }
}

double Bisection::median(const std::vector<Index>& edges, int omitted) const {
    long double square = 0;
    for (int i = 0; i < 3; ++i) {
        const long double length = lengths_[edges[i]];
        square += length * length * (i == omitted ? -0.25L : 0.5L);
    }
    return static_cast<double>(std::sqrt(square));
}

/// Halves are exact, and a median is known as well as its triangle is, but for its rounding: how
/// much that changes squares of lengths within an n-simplex, as a share.
double Bisection::rounding(Index simplex) const {
    const int n = dimension();
    LongMatrix squares = LongMatrix::Zero(n + 1, n + 1);
    for (int j = 1; j <= n; ++j)
        for (int i = 0; i < j; ++i) {
            const long double length = lengths_[edge_at(n, simplex, i, j)];
            squares(i, j) = squares(j, i) = length * length;
        }
    const auto measured = measured_simplex(std::move(squares));
    return std::numeric_limits<double>::epsilon() *
           (measured ? measured->sensitivity : std::numeric_limits<double>::infinity());
}

/// The simplex of the middle and all corners but the ends, in a k-simplex whose faces are these.
Index Bisection::add_inside(int k, const std::vector<Index>& whole,
                            const std::array<int, 2>& ends) {
    const Index inside = add(k - 1, -1);
    if (k == 1)
        return inside;
    const Index across = face(k - 1, whole[ends[1]], ends[0]);
    std::vector<Index> faces;
    int omitted = -1;
    for (int v = 0; v <= k; ++v)
        if (v != ends[0] && v != ends[1]) {
            faces.push_back(degrees_[k - 1].parts[whole[v]].inside);
            omitted = v;
        }
    faces.push_back(across);
    if (k == 2)
        lengths_.push_back(median(whole, omitted));
    set_faces(k - 1, inside, faces);
    join(k - 2, across, inside);
    return inside;
}

/// Once those of its faces that have the edge between the same corners are divided.
void Bisection::split(int k, Index s, Index edge) {
    const bool is_top = k == dimension();
    const std::array<int, 2> ends = ends_in(k, s, edge);
    std::vector<Index> whole(k + 1);
    for (int v = 0; v <= k; ++v)
        whole[v] = face(k, s, v);
    for (int v = 0; v <= k; ++v)
        if (v != ends[0] && v != ends[1])
            leave(k - 1, whole[v], s);
    Parts parts;
    parts.halves[0] = is_top ? s : add(k, degrees_[k].parents[s]);
    parts.halves[1] = add(k, degrees_[k].parents[s]);
    if (k == 1) {
        const double half = lengths_[s] / 2;
        lengths_.resize(degrees_[1].parents.size(), half);
        lengths_[parts.halves[0]] = half;
    }
    parts.inside = add_inside(k, whole, ends);
    for (int kept = 0; kept < 2; ++kept) {
        const int replaced = ends[1 - kept];
        std::vector<Index> faces;
        for (int v = 0; v <= k; ++v)
            if (v == ends[kept])
                faces.push_back(parts.inside);
            else if (v != replaced)
                faces.push_back(degrees_[k - 1].parts[whole[v]].halves[kept]);
        faces.push_back(whole[replaced]);
        set_faces(k, parts.halves[kept], faces);
        if (parts.halves[kept] == s)
            continue;
        leave(k - 1, whole[replaced], s);
        join(k - 1, whole[replaced], parts.halves[kept]);
    }
    if (!is_top) {
        degrees_[k].parts[s] = parts;
        return;
    }
    // the middle takes the place of an end, and moves from there to the last
    generations_.push_back(++generations_[s]);
    errors_.push_back(errors_[s] + rounding(parts.halves[1]));
    errors_[s] += rounding(s);
    orientations_.push_back((k - ends[0]) % 2 == 0 ? orientations_[s] : -orientations_[s]);
    orientations_[s] *= (k - ends[1]) % 2 == 0 ? 1 : -1;
}

/// Of all parts what their parents have, or else this.
template <class Values>
Values of_parents(const Values& values, const std::vector<Index>& parents,
                  typename Values::value_type otherwise = {}) {
    Values result(values.size() == 0 ? 0 : parents.size());
    for (std::size_t s = 0; s < static_cast<std::size_t>(result.size()); ++s)
        result[s] = parents[s] < 0 ? otherwise : values[parents[s]];
    return result;
}

/// Whole simplices of each degree, in order.
std::vector<std::vector<Index>> Bisection::whole() const {
    std::vector<std::vector<Index>> kept(degrees_.size());
    for (std::size_t k = 0; k < kept.size(); ++k)
        for (Index s = 0; s < std::ssize(degrees_[k].parents); ++s)
            if (degrees_[k].parts[s].inside < 0)
                kept[k].push_back(s);
    return kept;
}

Pieces Bisection::pieces(const Pieces& of, const std::vector<std::vector<Index>>& kept) const {
    const int n = dimension();
    std::vector<Simplices> tables;
    for (int k = 1; k <= n; ++k) {
        std::vector<Index> numbers(degrees_[k - 1].parents.size(), -1);
        for (std::size_t i = 0; i < kept[k - 1].size(); ++i)
            numbers[kept[k - 1][i]] = static_cast<Index>(i);
        Simplices& faces = tables.emplace_back(std::ssize(kept[k]), k + 1);
        for (Index s = 0; s < faces.rows(); ++s)
            for (int i = 0; i <= k; ++i)
                faces(s, i) = numbers[face(k, kept[k][s], i)];
    }
    std::vector<Index> names;
    for (Index v = 0; v < of.size(0); ++v)
        names.push_back(of.vertex_number(v));
    while (names.size() < kept[0].size())
        names.push_back(names.back() + 1);
    return {std::move(tables), {orientations_.begin(), orientations_.end()}, std::move(names)};
}

Shape Bisection::result(const Shape& shape, double error) const {
    const int n = dimension();
    const auto kept = whole();
    Shape result = shape;
    result.pieces = pieces(shape.pieces, kept);
    result.lengths.resize(std::ssize(kept[1]));
    for (std::size_t e = 0; e < kept[1].size(); ++e)
        result.lengths[e] = lengths_[kept[1][e]];
    std::vector<Index> parents;
    for (const Index facet : kept[n - 1])
        parents.push_back(degrees_[n - 1].parents[facet]);
    auto& [everywhere, facets, coefficients, vertices] = result.conditions;
    vertices.clear(); // of which none is fixed
    facets = of_parents(facets, parents, BoundaryCondition::natural);
    if (std::ssize(coefficients) == shape.pieces.size(n - 1))
        coefficients = of_parents(coefficients, parents, 1.0);
    result.conductivity = of_parents(shape.conductivity, degrees_[n].parents, 1.0);
    result.density = of_parents(shape.density, degrees_[n].parents, 1.0);
    result.length_error = 0;
    result.metric_error = error + *std::max_element(errors_.begin(), errors_.end());
    return result;
}

} // namespace

Shape bisected(const Shape& shape, const std::vector<Index>& simplices) {
    check(shape);
    for (const Index s : simplices)
        check_number("the bisection of simplex", s, 0,
                     shape.pieces.size(shape.pieces.dimension()) - 1);
    const double error = metric_share(shape); // throws where there is no simplex of such lengths
    Bisection bisection(shape);
    for (int times = 1; times <= 2; ++times)
        for (const Index s : simplices)
            if (!bisection.is_new(s, times))
                bisection.bisect(s);
    return bisection.result(shape, error);
}

} // namespace polydec
