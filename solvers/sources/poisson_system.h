// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"
#include "solvers/sources/boundary_forms.h"
#include "solvers/sources/constrained_system.h"

#include <memory>
#include <string>

namespace polydec {

/// The factorized equations of a space. All values are in the unit of the cells.
class PoissonSystem {
public:
    virtual ~PoissonSystem() = default;

    struct Found {
        Vector form;    ///< of the space
        Vector flux;    ///< primal, of (k-1)-cells
        Vector removed; ///< of the space
        SolveReport report;
        Compatibility compatibility = {};
    };

    /// f is a form of the space.
    virtual Found solve(const Vector& f, const BoundaryForms& data,
                        const Vector& harmonic) const = 0;
    virtual DenseMatrix harmonic_forms() const = 0;
};

/// For k = 0, with the values at the 0-cells as unknowns.
std::unique_ptr<const PoissonSystem> system_of_values(const FormSpace& space,
                                                      const std::string& engine);

/// For k = n on two-sided cells and a diagonal star_(n-1), with the density on each n-cell as
/// unknown. Differences of densities over duals are the fluxes.
std::unique_ptr<const PoissonSystem> system_of_densities(const FormSpace& space,
                                                         const std::string& engine);

/// The same with the flux through each facet as an additional unknown, for any star_(n-1). The
/// space must keep every n-cell, as it does if the star is a matrix.
std::unique_ptr<const PoissonSystem> system_of_fluxes(const FormSpace& space,
                                                      const std::string& engine);

/// For all k, with the form and its codifferential as unknowns.
std::unique_ptr<const PoissonSystem> system_of_forms(const FormSpace& space,
                                                     const std::string& engine);

} // namespace polydec
