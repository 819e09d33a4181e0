// SPDX-License-Identifier: MIT
#pragma once

#include "dec/form_space.h"
#include "solvers/sources/boundary_forms.h"
#include "solvers/sources/constrained_system.h"

#include <memory>
#include <string>

namespace polydec {

/// The equations of a space, factorized. All is in the unit of the cells.
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

/// For k = 0, with the value at each 0-cell as unknowns.
std::unique_ptr<const PoissonSystem> system_of_values(const FormSpace& space,
                                                      const std::string& engine);

/// For k = n on cells of two sides, with the density on each n-cell as unknowns: their differences
/// over the duals are the fluxes, where star_(n-1) is diagonal.
std::unique_ptr<const PoissonSystem> system_of_densities(const FormSpace& space,
                                                         const std::string& engine);

/// The same with the flux through each facet as an unknown besides, by any star_(n-1); no n-cell
/// may be left out of the space, as none is where the star is a matrix.
std::unique_ptr<const PoissonSystem> system_of_fluxes(const FormSpace& space,
                                                      const std::string& engine);

/// For all k, with the form and its codifferential as unknowns.
std::unique_ptr<const PoissonSystem> system_of_forms(const FormSpace& space,
                                                     const std::string& engine);

} // namespace polydec
