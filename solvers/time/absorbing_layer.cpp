// SPDX-License-Identifier: MIT
#include "solvers/time/absorbing_layer.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/fields/cell_centers.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace polydec {

namespace {

using Axes = std::uint32_t; // one bit per direction in which a cell extends

/// The places and directions of the cells of one degree.
struct LayerCells {
    Points centers;
    std::vector<Axes> axes;
};

LayerCells cells_of(const Discretization& mesh, const std::vector<Index>& kept, int k) {
    constexpr double rounding = 1e-9;
    LayerCells result{cell_centers(mesh, k)(kept, Eigen::indexing::all) / mesh.unit(), {}};
    result.axes.reserve(kept.size());
    for (const Index cell : kept) {
        const Points corners =
            mesh.measured_points()(mesh.merging().vertices(k, cell), Eigen::indexing::all);
        const Eigen::RowVectorXd extent =
            corners.colwise().maxCoeff() - corners.colwise().minCoeff();
        Axes axes = 0;
        for (int a = 0; a < extent.size(); ++a)
            if (extent[a] > rounding * extent.maxCoeff())
                axes |= Axes{1} << a;
        result.axes.push_back(axes);
    }
    return result;
}

/// The rates of decay over the depth, one column per direction, at places.
class Profile {
public:
    explicit Profile(const AbsorbingLayer& layer)
        : layer_(layer),
          width_(layer.width / layer.mesh.unit()),
          low_(layer.mesh.measured_points().colwise().minCoeff()),
          high_(layer.mesh.measured_points().colwise().maxCoeff()) {}

    double rate(const Eigen::RowVectorXd& place, int a) const {
        const double depth = std::max(has(a, 0) ? low_[a] + width_ - place[a] : 0,
                                      has(a, 1) ? place[a] - high_[a] + width_ : 0);
        if (!(depth > rounding * width_))
            return 0;
        const double most = -(layer_.power + 1) * std::log(layer_.reflection) / (2 * width_);
        return most * std::pow(depth / width_, layer_.power);
    }

    Vector sums(const Points& places) const {
        Vector result = Vector::Zero(places.rows());
        for (Index i = 0; i < result.size(); ++i)
            for (int a = 0; a < places.cols(); ++a)
                result[i] += rate(places.row(i), a);
        return result;
    }

private:
    static constexpr double rounding = 1e-9;

    /// A mesh without extent in a direction has no sides there.
    bool has(int a, int end) const {
        return layer_.sides.empty() ? high_[a] > low_[a] : layer_.sides[a][end];
    }

    const AbsorbingLayer& layer_;
    double width_; // in the unit of the mesh
    Eigen::RowVectorXd low_, high_;
};

/// The direction of differentiation of an entry of d between two cells; -1 if they are not parallel
/// to the axes.
int direction(Axes one, Axes other) {
    const Axes difference = one ^ other;
    if (std::popcount(difference) != 1 || ((one & other) != one && (one & other) != other))
        return -1;
    return std::countr_zero(difference);
}

/// The memory of the derivatives on the cells of the rows; none if one of them is not parallel to
/// the axes: `bad` then gets its number.
LayerMemory memory(const SparseMatrix& d, const LayerCells& rows, const LayerCells& columns,
                   int degree, const Profile& profile, double time_step, Index& bad) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    std::vector<Index> cells;
    std::vector<double> decays;
    const int directions = static_cast<int>(rows.centers.cols());
    for (Index row = 0; row < d.rows(); ++row)
        for (int a = 0; a < directions; ++a) {
            const double rate = profile.rate(rows.centers.row(row), a);
            if (rate == 0)
                continue;
            if (std::popcount(rows.axes[row]) != degree)
                bad = row;
            const auto number = static_cast<Index>(cells.size());
            const std::size_t before = entries.size();
            for (SparseMatrix::InnerIterator entry(d, row); entry; ++entry) {
                const int along = direction(rows.axes[row], columns.axes[entry.col()]);
                if (along < 0)
                    bad = row;
                if (along == a)
                    entries.emplace_back(number, static_cast<Index>(entry.col()), entry.value());
            }
            if (entries.size() == before)
                continue;
            cells.push_back(row);
            decays.push_back(std::exp(-rate * time_step));
        }
    SparseMatrix parts(static_cast<Index>(cells.size()), d.cols());
    parts.setFromTriplets(entries.begin(), entries.end());
    return {std::move(parts), std::move(cells),
            Eigen::Map<const Vector>(decays.data(), static_cast<Eigen::Index>(decays.size()))};
}

void check(const AbsorbingLayer& layer, const FormSpace& space) {
    const Discretization& mesh = layer.mesh;
    for (int k = 0; k <= mesh.dimension(); ++k)
        check_as_many(fmt::format("{}-cells of the layer's mesh", k), mesh.complex().size(k),
                      space.cells().complex().size(k));
    if (mesh.measured_points().cols() == 0 || !mesh.passage().is_identity())
        throw InvalidInput("an absorbing layer needs the coordinates of the cells: expected a mesh "
                           "with points, without flips");
    if (!layer.sides.empty())
        check_as_many("pairs of sides", std::ssize(layer.sides), mesh.measured_points().cols());
    const Eigen::RowVectorXd extent =
        mesh.measured_points().colwise().maxCoeff() - mesh.measured_points().colwise().minCoeff();
    double smallest = std::numeric_limits<double>::infinity();
    for (int a = 0; a < extent.size(); ++a)
        if (layer.sides.empty() ? extent[a] > 0 : layer.sides[a][0] || layer.sides[a][1])
            smallest = std::min(smallest, extent[a]);
    const double width = layer.width / mesh.unit();
    if (!(width > 0 && width < smallest))
        throw InvalidInput(fmt::format("the width of the absorbing layer is {:.6g}: expected a "
                                       "number above 0 and below {:.6g}, the width of the mesh",
                                       layer.width, mesh.unit() * smallest));
    if (!(layer.reflection > 0 && layer.reflection < 1 && layer.power >= 1 &&
          std::isfinite(layer.power)))
        throw InvalidInput(
            fmt::format("the absorbing layer has reflection {:.6g} and power {:.6g}: expected a "
                        "reflection between 0 and 1, and a power of at least 1",
                        layer.reflection, layer.power));
}

} // namespace

const char* name(LayerKind kind) {
    constexpr std::array names{"stretched", "conducting", "automatic"};
    return names[static_cast<std::size_t>(kind)];
}

void LayerMemory::add(const Vector& values, Vector& memory, Vector& derivative) const {
    if (is_empty())
        return;
    check_as_many("values of the layer's memory", memory.size(), decays_.size());
    memory.array() =
        decays_.array() * memory.array() + (decays_.array() - 1) * (parts_ * values).array();
    for (Index i = 0; i < memory.size(); ++i)
        derivative[cells_[i]] += memory[i];
}

LayerParts layer_parts(const AbsorbingLayer& layer, const FormSpace& space, const SparseMatrix& d,
                       int e_degree, int b_degree, double time_step) {
    check(layer, space);
    const Discretization& mesh = layer.mesh;
    const auto& cells = space.relative().cells;
    const Profile profile(layer);
    const LayerCells E = cells_of(mesh, cells[e_degree], e_degree);
    const LayerCells B = cells_of(mesh, cells[b_degree], b_degree);
    if (layer.kind != LayerKind::conducting) {
        constexpr Index none = -1;
        Index bad_E = none, bad_B = none;
        LayerParts parts;
        parts.of_B = memory(d, B, E, b_degree, profile, time_step, bad_B);
        parts.of_E = memory(d.transpose(), E, B, e_degree, profile, time_step, bad_E);
        if (bad_E == none && bad_B == none)
            return parts;
        const int degree = bad_B != none ? b_degree : e_degree;
        const Index cell = cells[degree][bad_B != none ? bad_B : bad_E];
        if (layer.kind == LayerKind::stretched)
            throw InvalidInput(
                fmt::format("{}-cell {} lies in the absorbing layer and is not parallel to the "
                            "axes, so coordinates cannot be stretched there: use a conducting "
                            "layer, or boxes as cells",
                            degree, cell),
                {.degree = degree, .cells = {cell}});
    }
    return {LayerKind::conducting, {}, {}, profile.sums(E.centers), profile.sums(B.centers)};
}

} // namespace polydec
