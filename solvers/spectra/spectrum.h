// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/certified_eigensolver.h"
#include "dec/form_space.h"

namespace polydec {

struct SpectrumOptions {
    Index count = 10;
    std::string linear_solver = "auto";
    std::string eigen_solver = "auto"; ///< or the name of an engine
    Certification certification = Certification::required;
    std::function<void(std::string_view)> progress = {}; ///< told what is being done, at each step
    /// Told of the vectors found so far, in a scale of the solver's own, whenever there are more,
    /// so that they can be kept (see Checkpoint); and those of an earlier run, to go on from. The
    /// answer is proved anew, so that it is right whatever these are.
    std::function<void(const DenseMatrix&)> found = {};
    DenseMatrix start = {};
};

/// Smallest eigenpairs of a Laplace-de Rham operator.
struct Spectrum {
    Side side;
    int degree;
    Vector eigenvalues; ///< ascending, with multiplicity; length^-2, of a mesh in its input's units
    Vector radii;       ///< of each: how far the exact one is at most
    DenseMatrix
        modes;        ///< columns: forms of the space, of norm 1 in the star; 0 where it fixes them
    Vector residuals; ///< |A x - lambda M x| / |M x|
    Certificate certificate;
    std::string linear_solver;
    std::string eigen_solver;
    /// Values that rounding hides: their radius is above 1e-6 of them and of the distance to the
    /// next ones.
    std::vector<Index> rough = {};
    std::vector<std::string> warnings = {}; ///< of rough values, and of spurious negative ones
};

/// The `count` smallest eigenpairs of the Laplacian on a space, proved complete. Dual j-forms are
/// treated as primal (n-j)-forms, which have the same eigenvalues, with the star between their
/// modes.
///
/// Each eigenvalue comes with a radius: the i-th smallest eigenvalue of the mesh lies within
/// radii[i] of eigenvalues[i]. That covers the iteration, all rounding on the way from the volumes
/// to the values, and rounding in the volumes themselves as laplacian_pencil.h states it; it takes
/// the inertia counted for right (see CertifiedEigensolver), and points or lengths to be known to
/// their last digits.
/// Throws InvalidInput if there are not so many eigenvalues, or, naming the cells, if the star that
/// is the mass of these forms is not positive or a star that must be inverted has a zero;
/// SolverFailure if the eigenpairs cannot be had or proved, InvalidInput for vectors to start with
/// of another size.
Spectrum spectrum(const FormSpace& space, const SpectrumOptions& options = {});

/// What is measured in length^-2, of a mesh that is measured in a unit, in those of its input. What
/// is rounding beside the largest number may vanish; radii then grow by what is lost there.
void use_input_units(Spectrum& spectrum, double unit);

/// A warning of values that rounding hides, if there are any.
std::vector<std::string> warning_of_rough_values(const std::vector<Index>& rough);

} // namespace polydec
