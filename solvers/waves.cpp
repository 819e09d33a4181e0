// SPDX-License-Identifier: MIT
#include "solvers/waves.h"

#include "backends/registry.h"
#include "backends/spectra/mass.h"
#include "base/checks.h"
#include "base/errors.h"
#include "dec/advice.h"
#include "dec/conditioned_complex.h"
#include "dec/forms/operator.h"
#include "dec/forms/star.h"
#include "meshes/unit_of_length.h"
#include "solvers/spectra/laplacian_pencil.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// The cells that E and B live on.
struct Degrees {
    int E, B;
    int low() const { return std::min(E, B); }
};

Degrees degrees(const CellComplex& complex, Side side, int degree) {
    const int n = complex.dimension();
    if (degree < 0 || degree >= n)
        throw InvalidInput(fmt::format("waves of {}-forms are asked for: in dimension {} the "
                                       "degrees are 0 to {}",
                                       degree, n, n - 1));
    return side == Side::primal ? Degrees{degree, degree + 1} : Degrees{n - degree, n - degree - 1};
}

ConditionedComplex conditioned(const Cells& cells,
                               const std::optional<BoundaryConditions>& conditions, Side side,
                               int degree) {
    degrees(cells.complex(), side, degree); // which there must be
    return conditioned_complex(cells, side, degree, conditions.value_or(built_in_conditions(side)));
}

void check_stars(const CellComplex& complex, const HodgeStars& stars, Side side, int degree) {
    const Degrees on = degrees(complex, side, degree);
    check_fit(complex, stars);
    check_positive_mass(stars[on.E], side, degree);
    if (side == Side::dual)
        return check_positive_mass(stars[on.B], side, degree + 1);
    const auto negative = stars[on.B].negatives();
    if (!negative.empty())
        throw InvalidInput(fmt::format("the duals of {} {}-cells are negative, the first is cell "
                                       "{}: waves would grow without bound; take {}",
                                       negative.size(), on.B,
                                       stars[on.B].numbers({negative.front()}),
                                       positive_stars(stars.dimension())),
                           stars[on.B].place(negative));
}

/// Of both sides by primal forms: star_k d star_(k-1)^-1 d^T has the eigenvalues of the product
/// the other way around but for zeros.
double longest_step(const ConditionedComplex& space, Side side, int degree) {
    const CellComplex& complex = space.relative.complex;
    check_stars(complex, space.stars, side, degree);
    const int k = degrees(complex, side, degree).low();
    const Operator d = Operator::derivative(complex, k);
    if (complex.incidences(k).size() == 0)
        return std::numeric_limits<double>::infinity();
    // in the scale in which the mass is 1: R^-T d^T star_(k+1) d R^-1, star_k = R^T R
    const auto mass = make_mass(weights(space.stars[k]));
    const Operator stiffness = d.transposed() * Operator::star(space.stars[k + 1]) * d;
    const SymmetricOperator A{mass->size(), [&](const Vector& x, Vector& y) {
                                  const Vector flow = stiffness * Vector(mass->unroot(x));
                                  y = mass->transposed_unroot(flow.cast<long double>());
                              }};
    const auto largest = make_eigen_solver("spectra")->largest(A, 1, {.tolerance = 1e-8});
    if (largest.converged < 1)
        throw SolverFailure("the largest frequency of the waves could not be found: the "
                            "eigensolver did not converge");
    return 2 / std::sqrt(largest.values[0]);
}

/// Both in the unit of the mesh; what is said in that of the input. Any step is stable where
/// nothing swings.
double chosen_step(const ConditionedComplex& space, Side side, int degree, double time_step,
                   double unit) {
    const double limit = longest_step(space, side, degree);
    if (time_step == 0)
        return std::isfinite(limit) ? part_of_stable_step * limit : 1;
    if (!(time_step > 0 && time_step < limit))
        throw InvalidInput(fmt::format("a time step of {:.6g} is given: expected one above 0 and "
                                       "below {:.6g}, beyond which waves grow",
                                       unit * time_step, unit * limit));
    return time_step;
}

Operator derivative(const ConditionedComplex& space, Side side, int degree) {
    const CellComplex& complex = space.relative.complex;
    const Degrees on = degrees(complex, side, degree);
    const Operator d = Operator::derivative(complex, on.low());
    return side == Side::primal ? d : (on.E % 2 == 0 ? 1.0 : -1.0) * d.transposed();
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

/// M R by the square roots of R, symmetric where M is no diagonal.
SparseMatrix loss_matrix(const HodgeStar& star, const Vector& loss) {
    const Vector root = loss.cwiseSqrt();
    return root.asDiagonal() * star.matrix() * root.asDiagonal();
}

Vector sum(const Vector& a, const Vector& b) {
    return a.size() == 0 ? b : b.size() == 0 ? a : Vector(a + b);
}

} // namespace

double stable_step(const Cells& cells, const BoundaryConditions& conditions, Side side,
                   int degree) {
    return cells.unit() * longest_step(conditioned(cells, conditions, side, degree), side, degree);
}

/// Leapfrog steps, in the unit of the mesh but for E and B of a state.
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

    Scheme(const Cells& cells, const Discretization* mesh, const Cochain& start,
           const WaveOptions& options)
        : Scheme(cells.complex(), conditioned(cells, options.conditions, start.side, start.degree),
                 mesh, start, options) {}
    Scheme(const CellComplex& whole, const ConditionedComplex& space, const Discretization* mesh,
           const Cochain& start, const WaveOptions& options);

    std::vector<Vector> begun(const Vector& start, const Vector& upper) const;
    void step(std::vector<Vector>& state, const WaveOptions& options, double time) const;
    double energy(const std::vector<Vector>& state) const;

    Degrees on;
    int energy_power; ///< of length
    double unit, time_step;
    Operator d, inverse_mass;
    Field E, B;
    LayerKind layer = LayerKind::automatic;
};

Waves::Scheme::Scheme(const CellComplex& whole, const ConditionedComplex& space,
                      const Discretization* mesh, const Cochain& start, const WaveOptions& options)
    : on(degrees(whole, start.side, start.degree)),
      energy_power((start.side == Side::primal ? 1 : -1) * (whole.dimension() - 2 * on.E)),
      unit(space.unit),
      time_step(chosen_step(space, start.side, start.degree, options.time_step / unit, unit)),
      d(derivative(space, start.side, start.degree)),
      inverse_mass(start.side == Side::primal ? Operator::inverse_star(space.stars[on.E])
                                              : Operator::star(space.stars[on.E])),
      E{space.relative.cells[on.E], whole.size(on.E), mass(space.stars[on.E], start.side)},
      B{space.relative.cells[on.B], whole.size(on.B), mass(space.stars[on.B], start.side)} {
    check(whole, start);
    LayerParts parts;
    if (options.layer.width != 0) {
        if (!mesh)
            throw InvalidInput("an absorbing layer needs to know where the cells are: expected a "
                               "mesh (Discretization), not cells alone");
        AbsorbingLayer in_unit = options.layer;
        in_unit.width /= unit;
        parts = layer_parts(*mesh, space, d.matrix(), on.E, on.B, in_unit, time_step);
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
        const HodgeStar& star = space.stars[k];
        if (field.loss.size() == 0 || star.is_diagonal())
            return;
        field.lost = loss_matrix(star, field.loss);
        field.mid = std::make_shared<HodgeStar>(
            space.stars.volumes(), k, SparseMatrix(star.matrix() + time_step / 2 * field.lost));
        if (start.side == Side::dual)
            field.star_of = std::make_shared<HodgeStar>(star);
    };
    lose(E, options.loss, parts.E_loss, on.E, "E");
    lose(B, options.upper_loss, parts.B_loss, on.B, "B");
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

/// By the midpoint rule: the loss is that of the mean of the values before and after. Dual values
/// are stars of primal ones, which lose as primal ones do.
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

/// E as the conditions have it, and its B half a step before; no memories.
std::vector<Vector> Waves::Scheme::begun(const Vector& start, const Vector& upper) const {
    std::vector<Vector> state{Vector(E.whole), Vector(B.whole), {}, {}};
    Vector values = E.restricted(start, "E");
    if (upper.size() > 0) {
        check_as_many("values of B", upper.size(), B.whole);
        state[1] = upper;
    } else {
        B.put_back(unit * (time_step / 2 * (d * values)), state[1]);
    }
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
double Waves::Scheme::energy(const std::vector<Vector>& state) const {
    const Vector e = E.restricted(state[0], "E"), b = B.restricted(state[1], "B") / unit;
    const Vector next = b - time_step * (d * e);
    return (e.dot(E.mass * e) + b.dot(B.mass * next)) / 2;
}

Waves::Waves(const Discretization& mesh, const Cochain& start, const WaveOptions& options)
    : Waves(std::make_shared<Scheme>(mesh, &mesh, start, options), start, options,
            [mesh] { return Fingerprint().add(mesh); }) {}

Waves::Waves(const Cells& cells, const Cochain& start, const WaveOptions& options)
    : Waves(std::make_shared<Scheme>(cells, nullptr, start, options), start, options,
            [cells] { return Fingerprint().add(cells); }) {}

Waves::Waves(std::shared_ptr<const Scheme> scheme, const Cochain& start, WaveOptions options,
             std::function<Fingerprint()> cells)
    : FixedSteps(scheme->unit * scheme->time_step, scheme->begun(start.values, options.B)),
      scheme_(std::move(scheme)),
      side_(start.side),
      degree_(start.degree),
      options_(std::move(options)),
      start_(now()),
      cells_(std::move(cells)) {}

void Waves::step(std::vector<Vector>& state) const {
    scheme_->step(state, options_, time());
}

std::vector<Cochain> Waves::forms() const {
    return {{side_, degree_, now()[0]}, {side_, degree_ + 1, now()[1]}};
}

std::optional<Fingerprint> Waves::fingerprint() const {
    const bool has_functions = options_.source || options_.upper_source;
    if (has_functions && options_.label.empty())
        return std::nullopt;
    Fingerprint result = cells_();
    result.add("waves").add(options_.label).add(has_functions).add(side_).add(degree_);
    result.add(time_step()).add(options_.loss).add(options_.upper_loss);
    result.add(options_.conditions.value_or(built_in_conditions(side_)));
    const AbsorbingLayer& layer = options_.layer;
    result.add(layer.width).add(layer.kind).add(layer.reflection).add(layer.power);
    for (const auto& sides : layer.sides)
        result.add(sides[0]).add(sides[1]);
    for (const Vector& values : start_)
        result.add(values);
    if (options_.source)
        result.add(options_.source(time_step() / 2));
    if (options_.upper_source)
        result.add(options_.upper_source(0));
    return result;
}

double Waves::energy() const {
    return in_input_units(Vector::Constant(1, scheme_->energy(now())), scheme_->unit,
                          scheme_->energy_power, "the energy")[0];
}

std::optional<double> Waves::relative_energy() const {
    const double before = scheme_->energy(start_);
    return before > 0 ? std::optional(scheme_->energy(now()) / before) : std::nullopt;
}

LayerKind Waves::layer() const {
    return scheme_->layer;
}

} // namespace polydec
