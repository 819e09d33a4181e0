// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/certified_eigensolver.h"
#include "base/progress.h"
#include "dec/boundary/form_space.h"

#include <optional>

namespace polydec {

struct SpectrumOptions {
    Index count = 10;
    std::string linear_solver = "auto";
    std::string eigen_solver = "auto"; ///< or the name of an engine
    Certification certification = Certification::required;
    Progress progress = {}; ///< called with a description at each step
    /// Called whenever there are more vectors, with the vectors found so far, in the solver's own
    /// scale, so that the caller can save them (see Checkpoint). `start` resumes from the vectors
    /// of an earlier run. The certificate is computed anew, so the result is correct whatever these
    /// are.
    std::function<void(const DenseMatrix&)> found = {};
    DenseMatrix start = {};
};

/// Smallest eigenpairs of a Laplace-de Rham operator.
struct Spectrum {
    Side side;
    int degree;
    Vector eigenvalues; ///< ascending, with multiplicity; length^-2 in the input's units
    Vector radii;       ///< bounds on the distance to the exact eigenvalues
    /// Columns: forms of the space, of norm 1 in the star, in units of the input; 0 where fixed.
    /// None, with a warning, if they are outside the range of double precision.
    DenseMatrix modes;
    Vector residuals; ///< |A x - lambda M x| / |M x|
    Certificate certificate;
    std::string linear_solver;
    std::string eigen_solver;
    /// Eigenvalues hidden by rounding: the radius exceeds 1e-6 of the value and of the distance to
    /// the next one.
    std::vector<Index> rough = {};
    /// Estimated relative distance of the largest eigenvalue from that of the shape itself, where
    /// shape_spectrum encloses it: on surfaces from the mean size of the cells, else 0. Not a
    /// bound.
    std::optional<double> coarseness = {};
    /// About rough values, spurious negative ones, and better engines that are not installed.
    std::vector<std::string> warnings = {};
};

/// The `count` smallest eigenpairs of the Laplacian on a space, proved complete. Dual j-forms are
/// treated as primal (n-j)-forms, which have the same eigenvalues, with the star between their
/// modes.
///
/// Each eigenvalue comes with a radius: the i-th smallest eigenvalue of the mesh lies within
/// radii[i] of eigenvalues[i]. The radius covers the iteration, all rounding from the volumes to
/// the values, and rounding in the volumes themselves, as laplacian_pencil.h states. It assumes
/// that the computed inertia is correct (see CertifiedEigensolver) and that points or lengths are
/// exact to the last digit. Throws InvalidInput if fewer eigenvalues exist, if start vectors have a
/// wrong size, or, naming the cells, if the mass star of these forms is not positive or a star to
/// be inverted has a zero; SolverFailure if the eigenpairs cannot be found or certified.
Spectrum spectrum(const FormSpace& space, const SpectrumOptions& options = {});

/// Converts a spectrum in dimension n from a mesh's unit of length to the units of its input.
/// Values at rounding level relative to the largest may underflow; radii grow by the loss. May add
/// a warning about modes.
void use_input_units(Spectrum& spectrum, int n, double unit);

/// Where to find the eigenvalues of the shape itself, and whether the mesh is coarse for the last
/// ones; empty without coarseness.
std::string advice_of_shape(const Spectrum& spectrum);

/// A warning about values hidden by rounding, if there are any.
std::vector<std::string> warning_of_rough_values(const std::vector<Index>& rough);

/// Smallest eigenpairs of delta d on coexact primal k-forms, e.g. curl curl on divergence-free
/// fields (k = 1: the modes of a cavity with essential walls). The kernel of delta d alone is as
/// large as the rank of d_(k-1). So the solver computes the certified spectrum of the Laplacian,
/// with exact and coexact forms, and selects the coexact ones. Under natural conditions nothing
/// flows through the boundary: the normal part is 0 there (for k = 0 the Neumann condition). Under
/// essential conditions the tangential part is 0 (Dirichlet). The certificate is for the Laplacian:
/// it also counts exact and harmonic forms.
///
/// The option `count` counts coexact pairs; `found` receives vectors of the Laplacian, from which
/// `start` resumes. Throws like spectrum, and InvalidInput, before any work, for dual forms, a
/// Robin condition, or too few coexact forms; degree n has none.
Spectrum coexact_spectrum(const FormSpace& space, const SpectrumOptions& options = {});

} // namespace polydec
