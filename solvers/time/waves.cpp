// SPDX-License-Identifier: MIT
#include "solvers/time/waves.h"

#include "backends/spectra/mass.h"
#include "base/checks.h"
#include "base/errors.h"
#include "base/exponent.h"
#include "base/parallel.h"
#include "dec/discretization/advice.h"
#include "dec/discretization/positive_mass.h"
#include "dec/forms/operator.h"
#include "dec/stars/star.h"
#include "meshes/unit_of_length.h"
#include "solvers/spectra/laplacian_pencil.h"
#include "solvers/time/largest_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// The cells that carry E and B.
struct Degrees {
    int E, B;
    int low() const { return std::min(E, B); }
};

Degrees degrees(const FormSpace& space) {
    const int n = space.cells().dimension(), degree = space.degree();
    if (degree >= n)
        throw InvalidInput(
            fmt::format("waves of {}-forms do not exist in dimension {}: expected degree 0 to {}",
                        degree, n, n - 1));
    return space.side() == Side::primal ? Degrees{degree, degree + 1}
                                        : Degrees{n - degree, n - degree - 1};
}

void check_wave_stars(const FormSpace& space) {
    const Degrees on = degrees(space);
    const Cells inside = space.inside();
    const HodgeStars& stars = inside.stars();
    check_positive_mass(stars[on.E], space.side(), space.degree());
    if (space.side() == Side::dual)
        return check_positive_mass(stars[on.B], space.side(), space.degree() + 1);
    const auto negative = stars[on.B].negatives();
    if (!negative.empty())
        throw InvalidInput(fmt::format("the duals of {} {}-cells are negative, the first is cell "
                                       "{}: waves would grow without bound; use {}",
                                       negative.size(), on.B,
                                       stars[on.B].numbers({negative.front()}),
                                       positive_stars(stars.dimension())),
                           stars[on.B].place(negative));
}

/// A limit of stable steps, in the unit of the mesh, and the cell with most of the fastest
/// oscillation.
struct Stability {
    double limit = std::numeric_limits<double>::infinity();
    std::string where = {};
};

/// Both sides use primal forms: star_k d star_(k-1)^-1 d^T has the eigenvalues of the reversed
/// product, except for zeros.
Stability stability(const FormSpace& space) {
    const int k = degrees(space).low();
    space.refuse_robin("a wave");
    check_wave_stars(space);
    const Cells inside = space.inside();
    const CellComplex& complex = inside.complex();
    const Operator d = Operator::derivative(complex, k);
    if (complex.incidences(k).size() == 0)
        return {};
    // in the scale of unit mass: R^-T d^T star_(k+1) d R^-1, star_k = R^T R
    const HodgeStar star = inside.stars()[k];
    const Vector scale = diagonal(weights(star)).cwiseSqrt().cwiseInverse();
    const auto mass = make_mass(congruent(weights(star), scale));
    const Operator scaled_d = d * Operator::weights(scale);
    const SparseMatrix stiffness =
        scaled_d.transposed() * Operator::star(inside.stars()[k + 1]) * scaled_d;
    const auto times = [&](const Vector& x) {
        Vector y(x.size());
        for_each_part(static_cast<Index>(x.size()), 1 << 13, [&](Index begin, Index end) {
            y.segment(begin, end - begin) = stiffness.middleRows(begin, end - begin) * x;
        });
        return y;
    };
    const SymmetricOperator A{mass->size(), [&](const Vector& x, Vector& y) {
                                  if (star.is_diagonal()) // and the scale makes it 1
                                      y = times(x);
                                  else
                                      y = mass->transposed_unroot(times(mass->unroot(x)));
                              }};
    const auto [largest, fastest] = largest_pair(A);
    const Vector u = scale.cwiseProduct(Vector(mass->unroot(fastest)));
    Index cell = 0;
    u.cwiseProduct(star * u).maxCoeff(&cell); // of the energy
    return {2 / std::sqrt(largest), fmt::format("{}-cell {}", k, star.numbers({cell}))};
}

/// Both in the unit of the mesh; messages use the input's. Any step is stable without oscillations.
double chosen_step(double limit, double time_step, double unit) {
    if (time_step == 0)
        return std::isfinite(limit) ? part_of_stable_step * limit : 1;
    if (!(time_step > 0 && time_step < limit))
        throw InvalidInput(fmt::format("the time step is {:.6g}: expected a number above 0 and "
                                       "below {:.6g}, the limit of stability",
                                       unit * time_step, unit * limit));
    return time_step;
}

Operator derivative(const FormSpace& space) {
    const Degrees on = degrees(space);
    const Operator d = Operator::derivative(space.relative().complex, on.low());
    return space.side() == Side::primal ? d : (on.E % 2 == 0 ? 1.0 : -1.0) * d.transposed();
}

Operator mass(const HodgeStar& star, Side side) {
    return side == Side::primal ? Operator::star(star) : Operator::inverse_star(star);
}

void check_loss(const char* what, const Vector& loss, Index values) {
    check_as_many(fmt::format("losses of {}", what), loss.size(), values);
    for (Index i = 0; i < loss.size(); ++i)
        if (!(loss[i] >= 0 && std::isfinite(loss[i])))
            throw InvalidInput(fmt::format("the loss of value {} of {} is {}: expected a rate of "
                                           "at least 0",
                                           i, what, loss[i]));
}

/// M R from square roots of R, so that it is symmetric if M is not diagonal.
SparseMatrix loss_matrix(const HodgeStar& star, const Vector& loss) {
    const Vector root = loss.cwiseSqrt();
    return root.asDiagonal() * star.matrix() * root.asDiagonal();
}

Vector sum(const Vector& a, const Vector& b) {
    return a.size() == 0 ? b : b.size() == 0 ? a : Vector(a + b);
}

} // namespace

double stable_step(const FormSpace& space) {
    return space.cells().unit() * stability(space).limit;
}

/// Leapfrog steps, in the unit of the mesh except for E and B of a state.
struct Waves::Scheme {
    /// Values of one degree, as they change in a step.
    struct Field {
        std::vector<Index> kept; ///< the cells whose values are not fixed at 0
        Index whole;             ///< how many cells there are
        Operator mass;
        Vector loss = {};                        ///< rates; or none
        SparseMatrix lost = {};                  ///< mass times loss, where the mass is a matrix
        std::shared_ptr<HodgeStar> mid = {};     ///< with half a step's loss in it, there
        std::shared_ptr<HodgeStar> star_of = {}; ///< that dual values are stars by, there
        LayerMemory layer = {};

        Vector restricted(const Vector& values, const char* what) const;
        void put_back(Vector&& of_kept, Vector& values) const;
        void advance(Vector& values, Vector rate, double time_step) const;
    };

    Scheme(const FormSpace& space, const WaveOptions& options);

    HodgeStar star(int k) const { return space.inside().stars()[k]; }
    Field field(int k) const;
    std::vector<Vector> begun(const Vector& start, const Vector& upper) const;
    void step(std::vector<Vector>& state, const WaveOptions& options, double time) const;
    ScaledNumber energy(const std::vector<Vector>& state) const;

    FormSpace space;
    Degrees on;
    int energy_power; ///< of length
    Stability stable;
    double unit, time_step;
    Operator d, inverse_mass;
    Field E, B;
    LayerKind layer = LayerKind::automatic;
};

Waves::Scheme::Scheme(const FormSpace& on_space, const WaveOptions& options)
    : space(on_space),
      on(degrees(space)),
      energy_power((space.side() == Side::primal ? 1 : -1) *
                   (space.cells().dimension() - 2 * on.E)),
      stable(stability(space)),
      unit(space.cells().unit()),
      time_step(chosen_step(stable.limit, options.time_step / unit, unit)),
      d(derivative(space)),
      inverse_mass(space.side() == Side::primal ? Operator::inverse_star(star(on.E))
                                                : Operator::star(star(on.E))),
      E(field(on.E)),
      B(field(on.B)) {
    LayerParts parts;
    if (options.layer) {
        parts = layer_parts(*options.layer, space, d.matrix(), on.E, on.B, time_step);
        layer = parts.kind;
        E.layer = parts.of_E;
        B.layer = parts.of_B;
    }
    const auto lose = [&](Field& field, const Vector& given, const Vector& in_layer, int k,
                          const char* what) {
        if (given.size() > 0)
            check_loss(what, given, field.whole);
        field.loss =
            sum(given.size() > 0 ? unit * field.restricted(given, what) : Vector(), in_layer);
        const HodgeStar of = star(k);
        if (field.loss.size() == 0 || of.is_diagonal())
            return;
        field.lost = loss_matrix(of, field.loss);
        const Cells inside = space.inside();
        field.mid = std::make_shared<HodgeStar>(
            inside.stars().volumes(), k, SparseMatrix(of.matrix() + time_step / 2 * field.lost));
        if (space.side() == Side::dual)
            field.star_of = std::make_shared<HodgeStar>(of);
    };
    lose(E, options.loss, parts.E_loss, on.E, "E");
    lose(B, options.upper_loss, parts.B_loss, on.B, "B");
}

Waves::Scheme::Field Waves::Scheme::field(int k) const {
    return {space.relative().cells[k], space.relative().whole_sizes[k],
            mass(star(k), space.side())};
}

Vector Waves::Scheme::Field::restricted(const Vector& values, const char* what) const {
    check_as_many(fmt::format("values of {}", what), values.size(), whole);
    return std::ssize(kept) == whole ? values : Vector(values(kept));
}

void Waves::Scheme::Field::put_back(Vector&& of_kept, Vector& values) const {
    if (std::ssize(kept) == whole) {
        values = std::move(of_kept);
        return;
    }
    values.setZero();
    values(kept) = of_kept;
}

/// The midpoint rule: the loss applies to the mean of the values before and after. Dual values are
/// stars of primal ones, with the same loss.
void Waves::Scheme::Field::advance(Vector& values, Vector rate, double time_step) const {
    if (star_of)
        values += *star_of * mid->solve(time_step * (rate - lost * Vector(mass * values)));
    else if (mid)
        values += mid->solve(time_step * (mass * rate - lost * values));
    else if (loss.size() > 0)
        values.array() += time_step * (rate.array() - loss.array() * values.array()) /
                          (1 + time_step / 2 * loss.array());
    else
        values += time_step * rate;
}

/// E under the conditions, its B half a step before, and memories that are 0.
std::vector<Vector> Waves::Scheme::begun(const Vector& start, const Vector& upper) const {
    std::vector<Vector> state{Vector(E.whole), Vector(B.whole), E.layer.at_start(),
                              B.layer.at_start()};
    space.check({space.side(), space.degree(), start});
    Vector values = E.restricted(start, "E");
    if (upper.size() > 0)
        check_values("values of B", upper, B.whole);
    B.put_back(upper.size() > 0 ? B.restricted(upper, "B")
                                : Vector(unit * (time_step / 2 * (d * values))),
               state[1]);
    E.put_back(std::move(values), state[0]);
    return state;
}

void Waves::Scheme::step(std::vector<Vector>& state, const WaveOptions& options,
                         double time) const {
    const auto source = [](const Field& field, const auto& given, double at, const char* what) {
        return given ? field.restricted(given(at), what) : Vector();
    };
    const Vector E_source =
        unit * source(E, options.source, time + unit * time_step / 2, "the source of E");
    const Vector B_source = source(B, options.upper_source, time, "the source of B");
    Vector e = E.restricted(state[0], "E"), b = B.restricted(state[1], "B") / unit;

    Vector change = d * e;
    B.layer.add(e, state[3], change);
    B.advance(b, sum(-change, B_source), time_step);

    const Vector flow = B.mass * b;
    change = d.transposed() * flow;
    E.layer.add(flow, state[2], change);
    E.advance(e, sum(inverse_mass * change, E_source), time_step);
    E.put_back(std::move(e), state[0]);
    B.put_back(unit * b, state[1]);
}

/// Half of <E, E> + <B, B'>, in the unit of the mesh.
ScaledNumber Waves::Scheme::energy(const std::vector<Vector>& state) const {
    Vector e = E.restricted(state[0], "E"), b = B.restricted(state[1], "B") / unit;
    const int exponent =
        exponent_of(Vector{{e.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>()}});
    e = times_power(e, -exponent);
    b = times_power(b, -exponent);
    const Vector next = b - time_step * (d * e);
    return {(e.dot(E.mass * e) + b.dot(B.mass * next)) / 2, 2 * exponent};
}

Waves::Waves(const FormSpace& space, const Vector& start, const WaveOptions& options)
    : Waves(std::make_shared<Scheme>(space, options), start, options) {}

Waves::Waves(std::shared_ptr<const Scheme> scheme, const Vector& start, const WaveOptions& options)
    : FixedSteps(scheme->unit * scheme->time_step, scheme->begun(start, options.B)),
      scheme_(std::move(scheme)),
      options_(options),
      start_(now()) {}

void Waves::step(std::vector<Vector>& state) const {
    scheme_->step(state, options_, time());
}

StepPlan Waves::limit() const {
    const auto& [limit, where] = scheme_->stable;
    if (where.empty())
        return {.limit = "nothing", .advice = "WaveOptions::time_step changes that"};
    return {
        .limit = fmt::format("stability (below {:.3g}, set near {})", scheme_->unit * limit, where),
        .advice = "WaveOptions::time_step shortens steps; larger cells there, or merging them by "
                  "a larger DiscretizeOptions::tolerance, allow longer ones"};
}

std::vector<Cochain> Waves::forms() const {
    const FormSpace& space = scheme_->space;
    return {{space.side(), space.degree(), now()[0]}, {space.side(), space.degree() + 1, now()[1]}};
}

std::optional<Fingerprint> Waves::fingerprint() const {
    const bool has_functions = options_.source || options_.upper_source;
    if (has_functions && options_.label.empty())
        return std::nullopt;
    Fingerprint result;
    result.add("waves").add(options_.label).add(has_functions).add(scheme_->space);
    result.add(time_step()).add(options_.loss).add(options_.upper_loss);
    if (options_.layer) {
        const AbsorbingLayer& layer = *options_.layer;
        result.add(layer.mesh).add(layer.width).add(layer.kind);
        result.add(layer.reflection).add(layer.power);
        for (const auto& sides : layer.sides)
            result.add(sides[0]).add(sides[1]);
    }
    for (const Vector& values : start_)
        result.add(values);
    if (options_.source)
        result.add(options_.source(time_step() / 2));
    if (options_.upper_source)
        result.add(options_.upper_source(0));
    return result;
}

std::vector<std::string> Waves::warnings() const {
    std::vector<std::string> result;
    const auto look_at = [&](const Scheme::Field& field, const Vector& given, const char* what) {
        if (given.size() == 0)
            return;
        const Vector loss = field.restricted(given, what);
        if (loss.size() > 0 && loss.maxCoeff() * time_step() > 2)
            result.push_back(fmt::format("the losses of {} are up to {:.3g}, too fast for steps of "
                                         "{:.3g}: there, values change "
                                         "sign in each step instead of dying away; use steps below "
                                         "{:.3g}, or fix the values of "
                                         "good conductors at 0",
                                         what, loss.maxCoeff(), time_step(), 2 / loss.maxCoeff()));
    };
    look_at(scheme_->E, options_.loss, "E");
    look_at(scheme_->B, options_.upper_loss, "B");
    return result;
}

double Waves::energy() const {
    const auto [part, exponent] = scheme_->energy(now());
    return ScaledNumber{part, exponent + scheme_->energy_power * std::ilogb(scheme_->unit)}
        .in_range("the energy");
}

std::optional<double> Waves::relative_energy() const {
    const auto before = scheme_->energy(start_), after = scheme_->energy(now());
    if (!(before.part > 0))
        return std::nullopt;
    return ratio(after, before);
}

LayerKind Waves::layer() const {
    return scheme_->layer;
}

} // namespace polydec
