// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/absorbing_layer.h"
#include "solvers/time/fixed_steps.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace polydec {

/// What waves meet on their way beside the stars, in which the materials are that they are fast or
/// slow in (see weighted_stars). Times and lengths are in units of a mesh's input.
struct WaveOptions {
    double time_step = 0; ///< below stable_step; 0: part_of_stable_step of it
    /// Rates of decay of E and of B by themselves, at least 0, one for each value, or none: for
    /// Maxwell's equations conductivity over permittivity (see cell_means). 1 / time.
    Vector loss = {}, upper_loss = {};
    std::optional<AbsorbingLayer> layer = {};
    Vector B = {}; ///< half a step before the start; none: E is at rest
    /// Added to the rates of E, at the middles of steps, and of B, at their beginnings: for
    /// Maxwell's equations minus the current over the permittivity.
    std::function<Vector(double time)> source = {}, upper_source = {};
    std::string label = {}; ///< of what the sources compute, for checkpoints
};

constexpr double part_of_stable_step = 0.9;

/// Waves of j-forms of either side by leapfrog steps: with E a j-form at whole times and B a
/// (j+1)-form at half times, B -= dt d E and E += dt delta B, so that E has the second time
/// derivative -delta d E. For primal 1-forms in space this is Maxwell's equations with the electric
/// field on edges and the magnetic flux through faces; on a merged Kuhn grid it is exactly the
/// scheme of Yee 1966. For 0-forms it is the scalar wave equation in any dimension. Dual forms are
/// stars of primal ones: the same matrices, transposed. What the conditions fix of E and B is 0: an
/// essential condition on primal 1-forms in space is a perfect conductor, a natural one a symmetry
/// (or magnetic) wall. Losses are taken by the midpoint rule, so
/// that steps stay of second order and stable. A star that is a matrix is factorized once, and each
/// step solves with it.
class Waves final : public FixedSteps {
public:
    /// From E at the time 0, a value for each cell. Throws InvalidInput like FormSpace::check; if
    /// there is no degree j+1; for Robin's condition; if star_j is not positive or star_(j+1) has a
    /// negative entry; of dual forms unless the stars of both are positive; for a time step that is
    /// not below stable_step; for losses that are negative or not as many as values; like
    /// layer_parts.
    Waves(const FormSpace& space, const Vector& start, const WaveOptions& options = {});

    /// E now, and B half a step before.
    std::vector<Cochain> forms() const override;

    /// What the sources give at the start is part of it as well.
    std::optional<Fingerprint> fingerprint() const override;

    /// Half of <E, E> + <B, B'>, B' being the B after the next half of a step without sources and
    /// losses: conserved to rounding by every such step. Positive for stable steps. Units length^(n
    /// - 2k) of primal k-forms E, length^(2k - n) of duals of k-cells. Throws InvalidInput where it
    /// is no number of double precision.
    double energy() const;

    /// As a part of that at the start, whatever the size of the mesh; none where there was none.
    std::optional<double> relative_energy() const;

    /// What the layer has become: stretched or conducting; automatic where there is none.
    LayerKind layer() const;

private:
    struct Scheme;
    Waves(std::shared_ptr<const Scheme> scheme, const Vector& start, const WaveOptions& options);
    void step(std::vector<Vector>& state) const override;

    std::shared_ptr<const Scheme> scheme_;
    WaveOptions options_;
    std::vector<Vector> start_;
};

/// 2 / sqrt of the largest eigenvalue of delta d on the forms of a space: steps must be shorter.
/// Units length, of a mesh's input. Throws InvalidInput like Waves, SolverFailure if the root of a
/// star that is a matrix takes more memory than there is; infinity if d is zero.
double stable_step(const FormSpace& space);

} // namespace polydec
