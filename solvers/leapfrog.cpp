// SPDX-License-Identifier: MIT
#include "solvers/leapfrog.h"

#include "backends/registry.h"
#include "backends/spectra/mass.h"
#include "base/checks.h"
#include "base/errors.h"
#include "dec/advice.h"
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

ConditionedComplex built_in(const CellComplex& complex, const HodgeStars& stars, Side side,
                            int degree) {
    degrees(complex, side, degree); // which there must be
    return conditioned_complex(complex, stars, side, degree, built_in_conditions(side));
}

ConditionedComplex conditioned(const Discretization& mesh, const BoundaryConditions& conditions,
                               Side side, int degree) {
    degrees(mesh.complex(), side, degree);
    return conditioned_complex(mesh.complex(), mesh.stars(), side, degree, conditions);
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

/// Both in the unit of the mesh; what is said in that of the input.
double checked_step(const ConditionedComplex& space, Side side, int degree, double time_step,
                    double unit) {
    const double limit = longest_step(space, side, degree);
    if (!(time_step > 0 && time_step < limit))
        throw InvalidInput(fmt::format("a time step of {:.6g} is given: expected one above 0 and "
                                       "below {:.6g}, beyond which waves grow",
                                       unit * time_step, unit * limit));
    return time_step;
}

LeapfrogOptions in_unit_of(const Discretization& mesh, LeapfrogOptions options) {
    options.time_step /= mesh.unit();
    options.loss *= mesh.unit();
    options.upper_loss *= mesh.unit();
    options.layer.width /= mesh.unit();
    return options;
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

double stable_step(const CellComplex& complex, const HodgeStars& stars, Side side, int degree) {
    return longest_step(built_in(complex, stars, side, degree), side, degree);
}

double stable_step(const Discretization& mesh, const BoundaryConditions& conditions, Side side,
                   int degree) {
    return mesh.unit() * longest_step(conditioned(mesh, conditions, side, degree), side, degree);
}

Leapfrog::Leapfrog(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
                   const LeapfrogOptions& options)
    : Leapfrog(complex, built_in(complex, stars, side, degree), side, degree, options, nullptr) {}

Leapfrog::Leapfrog(const Discretization& mesh, const BoundaryConditions& conditions, Side side,
                   int degree, const LeapfrogOptions& options)
    : Leapfrog(mesh.complex(), conditioned(mesh, conditions, side, degree), side, degree,
               in_unit_of(mesh, options), &mesh) {}

Leapfrog::Leapfrog(const CellComplex& whole, const ConditionedComplex& space, Side side, int degree,
                   const LeapfrogOptions& options, const Discretization* mesh)
    : unit_(mesh ? mesh->unit() : 1),
      time_step_(checked_step(space, side, degree, options.time_step, unit_)),
      energy_power_((side == Side::primal ? 1 : -1) *
                    (whole.dimension() - 2 * degrees(whole, side, degree).E)),
      d_(derivative(space, side, degree)),
      inverse_mass_(side == Side::primal
                        ? Operator::inverse_star(space.stars[degrees(whole, side, degree).E])
                        : Operator::star(space.stars[degrees(whole, side, degree).E])),
      E_(field(whole, space, side, degrees(whole, side, degree).E)),
      B_(field(whole, space, side, degrees(whole, side, degree).B)) {
    const Degrees on = degrees(whole, side, degree);
    LayerParts parts;
    if (options.layer.width != 0) {
        if (!mesh)
            throw InvalidInput("an absorbing layer needs to know where the cells are: give the "
                               "mesh and its conditions");
        parts = layer_parts(*mesh, space, d_.matrix(), on.E, on.B, options.layer, time_step_);
        layer_ = parts.kind;
        E_.layer = parts.of_E;
        B_.layer = parts.of_B;
    }
    const auto lose = [&](Field& field, const Vector& given, const Vector& in_layer, int k,
                          const char* what) {
        if (given.size() > 0)
            check_loss(what, given, field.whole);
        field.loss = sum(given.size() > 0 ? field.restricted(given, what) : Vector(), in_layer);
        const HodgeStar& star = space.stars[k];
        if (field.loss.size() == 0 || star.is_diagonal())
            return;
        field.lost = loss_matrix(star, field.loss);
        field.mid = std::make_shared<HodgeStar>(
            space.stars.volumes(), k, SparseMatrix(star.matrix() + time_step_ / 2 * field.lost));
        if (side == Side::dual)
            field.star_of = std::make_shared<HodgeStar>(star);
    };
    lose(E_, options.loss, parts.E_loss, on.E, "E");
    lose(B_, options.upper_loss, parts.B_loss, on.B, "B");
}

Leapfrog::Field Leapfrog::field(const CellComplex& whole, const ConditionedComplex& space,
                                Side side, int k) {
    return {space.relative.cells[k], whole.size(k), polydec::mass(space.stars[k], side)};
}

Vector Leapfrog::Field::restricted(const Vector& values, const char* what) const {
    check_as_many(fmt::format("values of {}", what), values.size(), whole);
    return std::ssize(kept) == whole ? values : Vector(values(kept));
}

void Leapfrog::Field::put_back(Vector&& of_kept, Vector& values) const {
    if (std::ssize(kept) == whole) {
        values = std::move(of_kept);
        return;
    }
    values.setZero();
    values(kept) = of_kept;
}

/// By the midpoint rule: the loss is that of the mean of the values before and after. Dual values
/// are stars of primal ones, which lose as primal ones do.
void Leapfrog::Field::advance(Vector& values, Vector rate, double time_step) const {
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

WaveState Leapfrog::at_rest(const Vector& given) const {
    WaveState result{Vector(E_.whole), Vector(B_.whole)};
    Vector E = E_.restricted(given, "E");
    B_.put_back(unit_ * (time_step_ / 2 * (d_ * E)), result.B);
    E_.put_back(std::move(E), result.E);
    return result;
}

void Leapfrog::step(WaveState& state, const WaveSources& sources) const {
    Vector E = E_.restricted(state.E, "E"), B = B_.restricted(state.B, "B") / unit_;
    const auto source = [](const Field& field, const Vector& given, const char* what) {
        return given.size() > 0 ? field.restricted(given, what) : Vector();
    };
    const Vector E_source = unit_ * source(E_, sources.E, "the source of E");
    const Vector B_source = source(B_, sources.B, "the source of B");

    Vector change = d_ * E;
    B_.layer.add(E, state.B_memory, change);
    B_.advance(B, sum(-change, B_source), time_step_);

    const Vector flow = B_.mass * B;
    change = d_.transposed() * flow;
    E_.layer.add(flow, state.E_memory, change);
    E_.advance(E, sum(inverse_mass_ * change, E_source), time_step_);
    E_.put_back(std::move(E), state.E);
    B_.put_back(unit_ * B, state.B);
}

void Leapfrog::step(Vector& E, Vector& B) const {
    if (!E_.layer.is_empty() || !B_.layer.is_empty())
        throw InvalidInput("an absorbing layer has a memory: give the whole state to each step");
    WaveState state{E, B};
    step(state);
    E = std::move(state.E);
    B = std::move(state.B);
}

double Leapfrog::measured_energy(const Vector& E, const Vector& B) const {
    const Vector e = E_.restricted(E, "E"), b = B_.restricted(B, "B") / unit_;
    const Vector next = b - time_step_ * (d_ * e);
    return (e.dot(E_.mass * e) + b.dot(B_.mass * next)) / 2;
}

double Leapfrog::energy(const Vector& E, const Vector& B) const {
    return in_input_units(Vector::Constant(1, measured_energy(E, B)), unit_, energy_power_,
                          "the energy")[0];
}

std::optional<double> Leapfrog::relative_energy(const WaveState& state,
                                                const WaveState& other) const {
    const double now = measured_energy(state.E, state.B);
    const double then = measured_energy(other.E, other.B);
    return then > 0 ? std::optional(now / then) : std::nullopt;
}

} // namespace polydec
