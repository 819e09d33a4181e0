// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/absorbing_layer.h"
#include "solvers/time/diffusion.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Losses, absorbing layers and sources of waves. Materials, which set the wave speed, are in the
/// stars (see weighted_stars). Times and lengths are in the input's units.
struct WaveOptions {
    double time_step = 0; ///< below stable_step; 0: part_of_stable_step of it
    /// Rates of decay of E and of B, in 1 / time, at least 0, one per value, or none. For Maxwell's
    /// equations: conductivity over permittivity (see cell_means).
    Vector loss = {}, upper_loss = {};
    std::optional<AbsorbingLayer> layer = {};
    Vector B = {}; ///< half a step before the start; none: E is at rest
    /// Added to the rates of E, at the middles of steps, and of B, at the starts of steps. For
    /// Maxwell's equations: minus the current over the permittivity.
    std::function<Vector(double time)> source = {}, upper_source = {};
    std::string label = {}; ///< names what the sources compute, for checkpoints
};

constexpr double part_of_stable_step = 0.9;

/// Waves of j-forms of either side by leapfrog steps. E is a j-form at whole time steps, B a
/// (j+1)-form at half steps: B -= dt d E and E += dt delta B, so that the second time derivative of
/// E is -delta d E. For primal 1-forms in space this is Maxwell's equations with the electric field
/// on edges and the magnetic flux through faces; on a merged Kuhn grid it is exactly Yee's scheme
/// (1966). For 0-forms it is the scalar wave equation in any dimension. Dual forms are stars of
/// primal ones, with the same matrices, transposed. Values of E and B fixed by conditions are 0: an
/// essential condition on primal 1-forms in space is a perfect conductor, a natural one a symmetry
/// (or magnetic) wall. The midpoint rule treats losses, so that steps stay second-order and stable.
/// A star that is a matrix is factorized once and solved with in each step.
class Waves final : public FixedSteps {
public:
    /// Starts from E at time 0, one value per cell. Throws InvalidInput like FormSpace::check and
    /// layer_parts; without degree j+1; for a Robin condition; if star_j is not positive or
    /// star_(j+1) has a negative entry; for dual forms unless both stars are positive; for a time
    /// step not below stable_step; for losses that are negative or of a wrong number.
    Waves(const FormSpace& space, const Vector& start, const WaveOptions& options = {});

    /// E now, and B half a step earlier.
    std::vector<Cochain> forms() const override;

    /// Includes the values of the sources at the start.
    std::optional<Fingerprint> fingerprint() const override;

    /// The energy, half of <E, E> + <B, B'>, where B' is B after the next half step without sources
    /// and losses. Every such step conserves it to rounding. Positive for stable steps. Units
    /// length^(n - 2k) for primal k-forms E, length^(2k - n) for duals of k-cells. Throws
    /// InvalidInput if it overflows double precision.
    double energy() const;

    /// The energy over its value at the start, also where energy() overflows; none if that was 0.
    std::optional<double> relative_energy() const;

    /// The kind of layer in use: stretched or conducting; automatic without a layer.
    LayerKind layer() const;

    /// Losses that are too fast for these steps: above 2 / time_step, values change sign in each
    /// step instead of dying away.
    std::vector<std::string> warnings() const override;

private:
    struct Scheme;
    Waves(std::shared_ptr<const Scheme> scheme, const Vector& start, const WaveOptions& options);
    void step(std::vector<Vector>& state) const override;
    StepPlan limit() const override;

    std::shared_ptr<const Scheme> scheme_;
    WaveOptions options_;
    std::vector<Vector> start_;
};

/// The stability limit of time steps: 2 / sqrt of the largest eigenvalue of delta d on the forms of
/// a space. Units length, in the input's units. Throws InvalidInput like Waves, SolverFailure if
/// the root of a star that is a matrix exceeds memory. Infinity if d is zero.
double stable_step(const FormSpace& space);

} // namespace polydec
