// SPDX-License-Identifier: MIT
#include "dec/fields/streamlines.h"

#include "base/errors.h"
#include "base/exponent.h"
#include "base/lists.h"
#include "complex/sides.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/seams.h"
#include "dec/metric/simplex_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace polydec {

namespace {

constexpr double step_size = 0.25;    // of a barycentric coordinate
constexpr int most_turns = 32;        // from simplex to simplex without progress
constexpr int watched_steps = 100;    // steps after which a line must have progressed
constexpr double least_headway = 0.1; // required progress, as a fraction of its length
constexpr int most_steps = 100'000;   // of a line, in each direction

/// A place in an n-simplex.
struct Spot {
    Index simplex;
    Vector barycentric;
};

/// The first facet on the way, given by the corner that it lacks, and the fraction of the way to
/// it; -1 and 1 if the way stays inside.
std::pair<int, double> first_facet(const Vector& barycentric, const Vector& way) {
    std::pair<int, double> first{-1, 1};
    for (int i = 0; i < barycentric.size(); ++i)
        if (barycentric[i] + first.second * way[i] < 0)
            first = {i, std::max(0.0, barycentric[i] / -way[i])};
    return first;
}

double length(const std::vector<Vector>& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        sum += (line[i] - line[i - 1]).norm();
    return sum;
}

void check_vectors(const Discretization& mesh, const DenseMatrix& vectors) {
    const int n = mesh.dimension(), N = mesh.ambient_dimension();
    if (!mesh.passage().is_identity() || N == 0)
        throw InvalidInput("streamlines need straight simplices between points: give a mesh "
                           "with points, without flips");
    refuse_turned_cells(mesh, "a streamline");
    if (vectors.rows() != mesh.complex().size(n) || vectors.cols() != N)
        throw InvalidInput(fmt::format(
            "{} vectors of {} coordinates: expected one of {} for each of the {} {}-cells",
            vectors.rows(), vectors.cols(), N, mesh.complex().size(n), n));
    for (Index cell = 0; cell < vectors.rows(); ++cell)
        if (!vectors.row(cell).allFinite())
            throw InvalidInput(fmt::format("the vector of {}-cell {} is not finite", n, cell),
                               {.degree = n, .cells = {cell}});
}

class Tracer {
public:
    Tracer(const Discretization& mesh, const DenseMatrix& vectors, const StreamlineOptions& options)
        : pieces_(mesh.pieces()),
          mesh_(mesh),
          n_(mesh.dimension()),
          sides_(pieces_),
          spacing_(options.spacing),
          longest_(options.longest),
          shortest_(options.shortest) {
        const Points& points = mesh.measured_points();
        if (spacing_ == 0)
            spacing_ = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm() / 40;
        if (!(spacing_ > 0 && longest_ > 0 && std::isfinite(spacing_) && std::isfinite(longest_)))
            throw InvalidInput(fmt::format("streamlines {} apart and at most {} spacings long: "
                                           "expected finite numbers above 0",
                                           spacing_, longest_));
        if (!(shortest_ >= 0 && shortest_ <= longest_))
            throw InvalidInput(fmt::format(
                "streamlines of {} to {} spacings: expected ascending numbers of at least 0",
                shortest_, longest_));
        find_rates(vectors);
        find_bins();
    }

    Mesh lines() {
        for (Index t = 0; t < pieces_.size(n_); ++t) {
            if (taken_[bins_[t]] != 0)
                continue;
            ++line_;
            const Spot start{t, Vector::Constant(n_ + 1, 1.0 / (n_ + 1))};
            auto ahead = half(start, 1, longest_ * spacing_);
            ahead.insert(ahead.begin(), place(start));
            auto line = half(start, -1, longest_ * spacing_ - length(ahead));
            std::reverse(line.begin(), line.end());
            line.insert(line.end(), ahead.begin(), ahead.end());
            if (length(line) > shortest_ * spacing_)
                add(line);
        }
        Mesh result{Points(std::ssize(points_), mesh_.measured_points().cols()),
                    Eigen::Map<const Simplices>(ends_.data(), std::ssize(ends_) / 2, 2),
                    {}};
        for (std::size_t i = 0; i < points_.size(); ++i)
            result.points.row(static_cast<Index>(i)) = points_[i].transpose();
        return result;
    }

private:
    /// Rates of change of barycentric coordinates along each corner's vector, in some unit of time.
    void find_rates(const DenseMatrix& vectors) {
        const Vector numbers = vectors.reshaped();
        const DenseMatrix in_range =
            times_power(numbers, -exponent_of(numbers)).reshaped(vectors.rows(), vectors.cols());
        const Points& points = mesh_.measured_points();
        const auto& simplices = pieces_.simplices(n_);
        const auto& carriers = mesh_.merging().carriers(n_);
        DenseMatrix at_vertices = DenseMatrix::Zero(points.rows(), points.cols());
        Vector weights = Vector::Zero(points.rows());
        const Vector& volumes = mesh_.geometry().volumes().primal(n_);
        for (Index t = 0; t < pieces_.size(n_); ++t)
            for (int i = 0; i <= n_; ++i) {
                at_vertices.row(simplices(t, i)) += volumes[t] * in_range.row(carriers[t].cell);
                weights[simplices(t, i)] += volumes[t];
            }
        at_vertices.array().colwise() /= weights.array();
        slowest_ = 1e-6 * at_vertices.rowwise().norm().maxCoeff();
        for (Index t = 0; t < pieces_.size(n_); ++t) {
            const auto corners = vertices(simplices, t);
            const DenseMatrix field = at_vertices(corners, Eigen::indexing::all);
            rates_.push_back(barycentric_gradients(points, corners) * field.transpose());
        }
    }

    /// Groups simplices with nearby centroids, numbered by position.
    void find_bins() {
        const Points& points = mesh_.measured_points();
        const auto& simplices = pieces_.simplices(n_);
        std::vector<std::vector<std::int64_t>> keys(static_cast<std::size_t>(pieces_.size(n_)));
        for (Index t = 0; t < pieces_.size(n_); ++t) {
            Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(points.cols());
            for (int i = 0; i <= n_; ++i)
                sum += points.row(simplices(t, i)) - points.row(0);
            for (const double x : sum)
                keys[t].push_back(static_cast<std::int64_t>(std::floor(x / (n_ + 1) / spacing_)));
        }
        std::vector<Index> order = numbers_below(std::ssize(keys));
        std::stable_sort(order.begin(), order.end(),
                         [&](Index a, Index b) { return keys[a] < keys[b]; });
        bins_.resize(keys.size());
        Index bin = -1;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (i == 0 || keys[order[i]] != keys[order[i - 1]])
                ++bin;
            bins_[order[i]] = bin;
        }
        taken_.assign(static_cast<std::size_t>(bin + 1), 0);
        taken_at_.assign(taken_.size(), 0);
    }

    Vector rate(const Spot& spot, double sign) const {
        return sign * rates_[spot.simplex] * spot.barycentric;
    }

    Vector place(const Spot& spot) const {
        Vector sum = Vector::Zero(mesh_.measured_points().cols());
        for (int i = 0; i <= n_; ++i)
            sum += spot.barycentric[i] *
                   mesh_.measured_points().row(pieces_.simplices(n_)(spot.simplex, i)).transpose();
        return sum;
    }

    /// The same place in the simplex across the facet without this corner, if there is one.
    std::optional<Spot> beyond(const Spot& spot, int corner) const {
        const Index facet = pieces_.face(n_, spot.simplex, corner);
        if (!sides_.exist(facet))
            return {};
        const Index first = sides_.first(facet);
        const Index other = first == spot.simplex ? sides_.second(facet) : first;
        if (other == spot.simplex)
            return {};
        const auto& simplices = pieces_.simplices(n_);
        Spot found{other, Vector::Zero(n_ + 1)};
        for (int i = 0; i <= n_; ++i)
            for (int j = 0; j <= n_; ++j)
                if (i != corner && simplices(spot.simplex, i) == simplices(other, j))
                    found.barycentric[j] = spot.barycentric[i];
        return found;
    }

    /// The displacement by a step of the midpoint rule of the given duration.
    Vector way(const Spot& spot, double sign, double time) const {
        Spot middle = spot;
        middle.barycentric += 0.5 * time * rate(spot, sign);
        return time * rate(middle, sign);
    }

    /// Makes a step, at most to the boundary of the simplex; returns false where the line ends.
    bool advance(Spot& spot, double sign) const {
        for (int turn = 0; turn < most_turns; ++turn) {
            const double fastest = rate(spot, sign).cwiseAbs().maxCoeff();
            if (!(fastest > 0))
                return false;
            double time = step_size / fastest;
            auto [corner, part] = first_facet(spot.barycentric, way(spot, sign, time));
            const bool is_there = part * step_size < 1e-9;
            if (!is_there) { // the midpoint of the shortened step
                time *= part;
                const Vector step = way(spot, sign, time);
                std::tie(corner, part) = first_facet(spot.barycentric, step);
                spot.barycentric += part * step;
            }
            if (corner < 0)
                return true;
            spot.barycentric[corner] = 0;
            const auto next = beyond(spot, corner);
            if (!next)
                return false;
            spot = *next;
            if (!is_there)
                return true;
        }
        return false;
    }

    /// Speed of the field along the simplex.
    double speed(const Spot& spot) const { return place({spot.simplex, rate(spot, 1)}).norm(); }

    /// Whether no other line has passed here, and this line has not come around.
    bool is_open(Index bin, double at) const {
        return taken_[bin] == 0 ||
               (taken_[bin] == line_ && std::abs(at - taken_at_[bin]) <= 3 * spacing_);
    }

    void take(Index bin, double at) {
        taken_[bin] = line_;
        taken_at_[bin] = at;
    }

    /// The places of a line after a spot, along the field or against it, at most this far.
    std::vector<Vector> half(Spot spot, double sign, double longest) {
        std::vector<Vector> places;
        Vector last = place(spot), watched = last;
        double length = 0, watched_length = 0;
        Index bin = bins_[spot.simplex];
        take(bin, 0);
        for (int step = 1; step <= most_steps && length < longest; ++step) {
            if (!(speed(spot) > slowest_))
                break;
            bool goes_on = advance(spot, sign);
            Vector next = place(spot);
            if (const double rest = longest - length, way = (next - last).norm(); way > rest) {
                next = last + rest / way * (next - last);
                goes_on = false;
            }
            length += (next - last).norm();
            const Index left = std::exchange(bin, bins_[spot.simplex]);
            if (bin != left && !is_open(bin, sign * length)) // one step may be several spacings
                break;
            take(bin, sign * length);
            if ((next - last).norm() > 1e-9 * spacing_) {
                places.push_back(next);
                last = next;
            }
            if (!goes_on)
                break;
            if (step % watched_steps == 0) {
                const double travelled = length - std::exchange(watched_length, length);
                if (!((next - std::exchange(watched, next)).norm() > least_headway * travelled))
                    break;
            }
        }
        return places;
    }

    void add(const std::vector<Vector>& line) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (i > 0) {
                const auto end = static_cast<Index>(points_.size());
                ends_.insert(ends_.end(), {end - 1, end});
            }
            points_.push_back(line[i]);
        }
    }

    const Pieces& pieces_;
    const Discretization& mesh_;
    int n_;
    Sides sides_;
    double spacing_, longest_, shortest_;
    std::vector<DenseMatrix> rates_; // of barycentric coordinates along the field, per n-simplex
    std::vector<Index> bins_;        // of each n-simplex
    std::vector<Index> taken_;       // the last line in each bin, from 1
    std::vector<double> taken_at_;   // position along that line, from its start
    Index line_ = 0;
    double slowest_ = 0;
    std::vector<Vector> points_;
    std::vector<Index> ends_; // of segments, two each
};

} // namespace

Mesh streamlines(const Discretization& mesh, const DenseMatrix& vectors,
                 StreamlineOptions options) {
    check_vectors(mesh, vectors);
    const DenseMatrix in_box =
        vectors(cells_of_places(mesh, mesh.dimension()), Eigen::indexing::all);
    options.spacing /= mesh.unit();
    Mesh lines = Tracer(placed(mesh), in_box, options).lines();
    lines.points *= mesh.unit();
    return lines;
}

} // namespace polydec
