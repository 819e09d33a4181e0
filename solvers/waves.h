// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/fixed_steps.h"
#include "solvers/leapfrog.h"

#include <functional>
#include <optional>
#include <string>

namespace polydec {

struct WaveOptions {
    double time_step = 0; ///< below stable_step; 0: part_of_stable_step of it
    /// Without, the built-in ones.
    std::optional<BoundaryConditions> conditions = {};
    Vector loss = {}, upper_loss = {}; ///< as of LeapfrogOptions, and the layer
    AbsorbingLayer layer = {};
    Vector B = {}; ///< half a step before the start; none: E is at rest
    /// Added to the rates of E, at the middles of steps, and of B, at their beginnings: for
    /// Maxwell's equations minus the current over the permittivity.
    std::function<Vector(double time)> source = {}, upper_source = {};
    std::string label = {}; ///< of what the sources compute, for checkpoints
};

constexpr double part_of_stable_step = 0.9;

/// A wave that runs by Leapfrog: E, and B half a step before. What the conditions fix of E is 0.
class Waves final : public FixedSteps {
public:
    /// Throws InvalidInput like Leapfrog and stable_step, and for a form of other cells.
    Waves(const Discretization& mesh, const Cochain& start, const WaveOptions& options = {});

    /// The same on any cells, under the built-in conditions, without a layer.
    Waves(const CellComplex& complex, const HodgeStars& stars, const Cochain& start,
          const WaveOptions& options = {});

    std::vector<Cochain> forms() const override;

    /// What the sources give at the start is part of it as well.
    std::optional<Fingerprint> fingerprint() const override;

    /// Of what is there now, and as a part of that at the start: see Leapfrog.
    double energy() const;
    std::optional<double> relative_energy() const;

    const Leapfrog& leapfrog() const { return leapfrog_; }

private:
    Waves(Leapfrog leapfrog, const Cochain& start, WaveOptions options,
          std::function<Fingerprint()> cells);
    void step(std::vector<Vector>& state) const override;

    Leapfrog leapfrog_;
    Side side_;
    int degree_;
    WaveOptions options_;
    std::vector<Vector> start_;
    std::function<Fingerprint()> cells_;
};

} // namespace polydec
