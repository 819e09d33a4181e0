// SPDX-License-Identifier: MIT
#include "shape/shape_spectrum.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/lists.h"
#include "dec/metric/simplex_geometry.h"
#include "shape/lower_bounds.h"
#include "shape/one_forms.h"
#include "shape/ritz_pairs.h"
#include "shape/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace polydec {

namespace {

class Enclosing {
public:
    Enclosing(const Shape& shape, const ShapeSpectrumOptions& options)
        : shape_(shape),
          options_(options),
          ratio_(metric_ratio(shape)),
          conforming_(shape, options.level),
          lower_(lower_form(shape, options.level)),
          counter_(lower_, options.linear_solver) {
        result_.zeros = zero_eigenvalues(shape);
    }

    /// Whether there are as many functions as eigenvalues.
    bool suffices() const { return options_.count <= conforming_.family().size(); }

    /// Simplices that are too large for good lower bounds.
    std::vector<Index> coarse() {
        find_upper();
        constexpr double most = 0.3; // of s C^2
        return lower_.beyond(result_.upper[options_.count - 1] / (ratio_ * most));
    }

    /// After coarse().
    ShapeSpectrum enclose() {
        count_all();
        take_modes();
        find_lower();
        warn();
        result_.simplices = shape_.pieces.size(dimension());
        return result_;
    }

    /// The simplices that make enclosures wide: a share of their indicators is that of all. After
    /// enclose().
    std::vector<Index> marked();

private:
    void tell(std::string_view what) const {
        if (options_.progress)
            options_.progress(what);
    }
    int dimension() const { return shape_.pieces.dimension(); }

    void find_upper();
    void take(RitzPairs pairs);
    void take_modes();
    void count_all();
    void find_lower();
    void warn();

    const Shape& shape_;
    const ShapeSpectrumOptions& options_;
    double ratio_; // of eigenvalues computed and meant
    ConformingForm conforming_;
    FormFamily lower_;
    FamilyCounter counter_; // of it
    std::optional<RitzSolver> solver_;
    RitzPairs pairs_;
    std::optional<LowerBounds> bounds_;
    ShapeSpectrum result_;
};

void Enclosing::find_upper() {
    if (!suffices())
        throw InvalidInput(fmt::format("{} eigenvalues of a shape: expected at most as many as the "
                                       "mesh has functions of degree {}, which are {}; refine the "
                                       "mesh for more",
                                       options_.count, options_.level,
                                       conforming_.family().size()));
    tell("upper bounds");
    take(solver_.emplace(shape_, conforming_, result_.zeros, options_).smallest(options_.count));
}

void Enclosing::take(RitzPairs pairs) {
    pairs_ = std::move(pairs);
    result_.upper = pairs_.upper.head(options_.count) / ratio_;
}

void Enclosing::take_modes() {
    const Pieces& pieces = shape_.pieces;
    const auto& pairs = conforming_.pairs();
    const Unknowns& points = conforming_.points();
    result_.modes = DenseMatrix::Zero(pieces.size(0), options_.count);
    if (options_.level == 2)
        result_.edge_modes = DenseMatrix::Zero(pieces.size(1), options_.count);
    const int n = dimension();
    std::size_t entry = 0;
    for (Index s = 0; s < pieces.size(n); ++s)
        for (const auto& [i, j] : pairs) {
            const Index unknown = points.of_simplices[entry];
            const int sign = points.signs[entry++];
            const std::array<int, 2> corners{i, j};
            const bool is_vertex = i == j;
            const Index row =
                is_vertex ? pieces.simplices(n)(s, i) : face_at(pieces, n, s, corners);
            if (unknown >= 0)
                (is_vertex ? result_.modes : result_.edge_modes).row(row) =
                    sign * pairs_.vectors.row(unknown).head(options_.count);
        }
}

/// How many eigenvalues lie below the largest gap behind them. Those that may be missing are looked
/// for.
void Enclosing::count_all() {
    const Vector upper = pairs_.upper / ratio_;
    const Index gap = largest_gap(upper, options_.count);
    result_.count_at = (1 + 1e-9) * upper[options_.count - 1];
    if (gap < upper.size())
        result_.count_at = std::max(result_.count_at, (upper[gap - 1] + upper[gap]) / 2);
    bound_above(result_.count, shape_, counter_, result_.count_at, ratio_);
    const auto& at_most = result_.count.at_most;
    result_.factorizations += at_most ? 1 : 0;
    const auto below = [&] {
        return static_cast<Index>((pairs_.upper.array() < result_.count_at * ratio_).count());
    };
    const Index most = 2 * options_.count; // more are better known by counts of their own
    if (at_most > below() && at_most <= most)
        take(solver_->smallest(std::min(*at_most, conforming_.family().size())));
    result_.count.at_least = below();
}

void Enclosing::find_lower() {
    tell("lower bounds");
    bounds_.emplace(counter_, options_, result_.upper * ratio_, result_.zeros,
                    facet_moments(shape_, options_.level, conforming_, pairs_.vectors));
    result_.lower = bounds_->prove(result_.count.at_most) * (ratio_ * (1 - 1e-15));
    result_.factorizations += bounds_->counts();
}

std::vector<Index> Enclosing::marked() {
    // at level 2 the gradient that no quadratic function has, and the doubt of the mass; at level 1
    // the gradient that conforming functions do not have
    const bool by_means = options_.level == 1;
    const auto factors = [=](double s, double) {
        return by_means ? std::vector<double>{1, 0, 0} : std::vector<double>{0, 1, 0, 2 * s * s};
    };
    auto [values, vectors] = bounds_->guesses();
    if (by_means)
        vectors -= bounds_->vectors() * least_squares(bounds_->vectors(), vectors).shortest;
    Vector indicators = Vector::Zero(shape_.pieces.size(dimension()));
    for (Index j = result_.zeros; j < options_.count; ++j) {
        const double s = values[j] > 0 ? values[j] : pairs_.upper[j]; // a guess may be 0
        indicators += lower_.local_values(factors, s, vectors.col(j)) / s;
    }
    std::vector<Index> order = numbers_below(indicators.size());
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return indicators[a] > indicators[b]; });
    constexpr double bulk = 0.5; // Doerfler 1996
    double rest = bulk * indicators.sum();
    std::size_t count = 0;
    while (count < order.size() && rest > 0)
        rest -= indicators[order[count++]];
    order.resize(count);
    return order;
}

void Enclosing::warn() {
    const double top = result_.upper[options_.count - 1] / ratio_;
    if (const auto too_large = lower_.beyond(top); !too_large.empty())
        result_.warnings.push_back(warning_of_large(shape_, too_large, top, lower_.limit()));
}

void warn_of_widths(ShapeSpectrum& spectrum, double width) {
    const Vector wide = widths(spectrum);
    const auto rough = (wide.array() > width).count();
    if (width > 0 && rough > 0)
        spectrum.warnings.push_back(
            fmt::format("{} of {} enclosures are wider than the requested relative width {:.3g}, "
                        "the widest {:.3g}: refine the mesh",
                        rough, wide.size(), width, wide.maxCoeff()));
}

/// Bisects as many of these simplices, those in front first, as leave at most `most`. Not all may
/// fit.
Shape bisected_up_to(const Shape& shape, const std::vector<Index>& simplices, Index most) {
    const int n = shape.pieces.dimension();
    const auto first = [&](std::size_t count) {
        return bisected(shape, {simplices.begin(), simplices.begin() + count});
    };
    std::size_t low = 0, high = simplices.size();
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (first(middle).pieces.size(n) <= most ? low : high) = middle;
    }
    return first(low);
}

/// On the shape as it is, or bisected until all enclosures are narrow, no simplex makes them wide,
/// or no more simplices fit. At least as many eigenvalues as are 0.
ShapeSpectrum enclosed(Shape shape, const ShapeSpectrumOptions& options) {
    const int n = shape.pieces.dimension();
    const Index vertices = shape.pieces.size(0), simplices = shape.pieces.size(n);
    bool full = simplices >= options.max_triangles;
    // the best of all rounds: many small simplices may widen an enclosure by rounding
    Vector lower = Vector::Zero(options.count),
           upper = Vector::Constant(options.count, std::numeric_limits<double>::infinity());
    for (;;) {
        Enclosing enclosing(shape, options);
        auto marked =
            full || enclosing.suffices() ? enclosing.coarse() : numbers_below(shape.pieces.size(n));
        if (full || marked.empty()) {
            marked.clear();
            ShapeSpectrum result = enclosing.enclose();
            result.lower = lower = lower.cwiseMax(result.lower);
            result.upper = upper = upper.cwiseMin(result.upper);
            if (!full && widths(result).maxCoeff() > options.width)
                marked = enclosing.marked();
            if (marked.empty()) {
                if (shape.pieces.size(n) > simplices) {
                    result.modes = DenseMatrix(result.modes.topRows(vertices));
                    result.edge_modes = {};
                }
                warn_of_widths(result, options.width);
                return result;
            }
        }
        const Shape all = bisected(shape, marked);
        full = all.pieces.size(n) > options.max_triangles;
        shape = flipped(full ? bisected_up_to(shape, marked, options.max_triangles) : all).shape;
    }
}

} // namespace

ShapeSpectrum shape_spectrum(const Shape& shape, const ShapeSpectrumOptions& options) {
    check(shape);
    check_level(options.level);
    if (options.count < 1)
        throw InvalidInput(
            fmt::format("{} eigenvalues of a shape: expected at least 1", options.count));
    if (!(options.width >= 0))
        throw InvalidInput(fmt::format(
            "enclosures of relative width {}: expected a number of at least 0", options.width));
    check_number("the limit on simplices", options.max_triangles, 0,
                 std::numeric_limits<Index>::max());
    if (are_one_forms(shape, options.degree))
        return one_form_spectrum(shape, options);
    const Shape of = options.degree == 0 ? shape : top_forms(shape);
    // all zeros: iterations begin behind them
    ShapeSpectrumOptions more = options;
    more.count = std::max(options.count, zero_eigenvalues(of));
    ShapeSpectrum result = enclosed(of, more);
    const Index count = options.count;
    result.lower.conservativeResize(count);
    result.upper.conservativeResize(count);
    result.zeros = std::min(result.zeros, count);
    for (DenseMatrix* const modes : {&result.modes, &result.edge_modes})
        modes->conservativeResize(Eigen::NoChange, std::min<Eigen::Index>(modes->cols(), count));
    return result;
}

Vector widths(const ShapeSpectrum& spectrum) {
    Vector result = Vector::Zero(spectrum.upper.size());
    for (Index j = spectrum.zeros; j < result.size(); ++j)
        result[j] = (spectrum.upper[j] - spectrum.lower[j]) / spectrum.upper[j];
    return result;
}

} // namespace polydec
