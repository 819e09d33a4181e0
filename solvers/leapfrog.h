// SPDX-License-Identifier: MIT
#pragma once

#include "dec/conditioned_complex.h"
#include "dec/discretization.h"
#include "dec/forms/operator.h"
#include "solvers/absorbing_layer.h"

#include <memory>
#include <optional>
#include <vector>

namespace polydec {

/// What waves meet on their way beside the stars, in which the materials are that they are fast or
/// slow in (see weighted_stars).
struct LeapfrogOptions {
    double time_step = 0; ///< and all times and lengths in units of a mesh's input
    /// Rates of decay of E and of B by themselves, at least 0, one for each value, or none: for
    /// Maxwell's equations conductivity over permittivity (see cell_means). 1 / time.
    Vector loss = {}, upper_loss = {};
    AbsorbingLayer layer = {}; ///< of no width: none
};

/// What is added to the rate of E at the middle of a step, and to that of B at its beginning, one
/// for each value; or nothing.
struct WaveSources {
    Vector E = {}, B = {};
};

/// All that is known of a wave at one time.
struct WaveState {
    Vector E;                            ///< at a time t
    Vector B;                            ///< half a step before
    Vector E_memory = {}, B_memory = {}; ///< of an absorbing layer; none: nothing has come there
};

/// Waves of j-forms of either side by leapfrog steps: with E a j-form at whole times and B a
/// (j+1)-form at half times, B -= dt d E and E += dt delta B, so that E has the second time
/// derivative -delta d E. For primal 1-forms in space this is Maxwell's equations with the electric
/// field on edges and the magnetic flux through faces; on a merged Kuhn grid it is exactly the
/// scheme of Yee 1966. For 0-forms it is the scalar wave equation in any dimension. Dual forms are
/// stars of primal ones: the same matrices, transposed. Losses are taken by the midpoint rule, so
/// that steps stay of second order and stable. A star that is a matrix is factorized once, and each
/// step solves with it.
class Leapfrog {
public:
    /// On a complex as it is: relative to its boundary, primal E vanishes there (a perfect
    /// conductor, a clamped membrane), else nothing flows out.
    /// Throws InvalidInput if there are no degrees j and j+1; if star_j is not positive or
    /// star_(j+1) has a negative entry; of dual forms unless the stars of both are positive; for a
    /// time step that is not positive and below stable_step; for losses that are negative or not as
    /// many as values; for a layer.
    Leapfrog(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
             const LeapfrogOptions& options);
    Leapfrog(const CellComplex& complex, const HodgeStars& stars, int degree, double time_step)
        : Leapfrog(complex, stars, Side::primal, degree, {.time_step = time_step}) {}
    Leapfrog(const Discretization& mesh, int degree, double time_step)
        : Leapfrog(mesh, built_in_conditions(Side::primal), Side::primal, degree,
                   {.time_step = time_step}) {}

    /// Under homogeneous conditions on the boundary, those of conditioned_complex: E and B have
    /// values for all cells, and those that the conditions fix are 0 after every step. An essential
    /// condition on primal 1-forms in space is a perfect conductor, a natural one a symmetry (or
    /// magnetic) wall. Throws like the above, like conditioned_complex and AbsorbingLayer.
    Leapfrog(const Discretization& mesh, const BoundaryConditions& conditions, Side side,
             int degree, const LeapfrogOptions& options);

    /// E as the conditions have it, at rest: its B half a step before. Throws InvalidInput
    /// likewise.
    WaveState at_rest(const Vector& E) const;

    /// One step. Throws InvalidInput for other numbers of values than there are cells.
    void step(WaveState& state, const WaveSources& sources = {}) const;

    /// The same without sources, where there is no absorbing layer, which throws InvalidInput.
    void step(Vector& E, Vector& B) const;

    /// Half of <E, E> + <B, B'>, B' being the B after the next half of a step without sources and
    /// losses: conserved to rounding by every such step. Positive for stable steps. Units length^(n
    /// - 2k) of primal k-forms E, length^(2k - n) of duals of k-cells. Throws likewise, and where
    /// it is no number of double precision.
    double energy(const Vector& E, const Vector& B) const;

    /// The energy of a state over that of another, whatever the size of the mesh; none where the
    /// other has none.
    std::optional<double> relative_energy(const WaveState& state, const WaveState& other) const;

    double time_step() const { return unit_ * time_step_; }

    /// What the layer has become: stretched or conducting; automatic where there is none.
    LayerKind layer() const { return layer_; }

private:
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

    Leapfrog(const CellComplex& whole, const ConditionedComplex& space, Side side, int degree,
             const LeapfrogOptions& options, const Discretization* mesh);

    double measured_energy(const Vector& E, const Vector& B) const;

    static Field field(const CellComplex& whole, const ConditionedComplex& space, Side side, int k);

    double unit_, time_step_; // in this unit, as all behind it but E and B of a step
    int energy_power_;        // of length
    Operator d_, inverse_mass_;
    Field E_, B_;
    LayerKind layer_ = LayerKind::automatic;
};

/// 2 / sqrt of the largest eigenvalue of delta d on forms: steps must be shorter. Units length, of
/// a mesh's input. Throws InvalidInput like Leapfrog, SolverFailure if the root of a star that is a
/// matrix takes more memory than there is; infinity if d is zero.
double stable_step(const CellComplex& complex, const HodgeStars& stars, Side side, int degree);
double stable_step(const Discretization& mesh, const BoundaryConditions& conditions, Side side,
                   int degree);
inline double stable_step(const CellComplex& complex, const HodgeStars& stars, int degree) {
    return stable_step(complex, stars, Side::primal, degree);
}
inline double stable_step(const Discretization& mesh, int degree) {
    return stable_step(mesh, built_in_conditions(Side::primal), Side::primal, degree);
}

} // namespace polydec
