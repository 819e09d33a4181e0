// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "dec/conditioned_complex.h"
#include "dec/input_units.h"

#include <memory>
#include <optional>

namespace polydec::python {

/// Cells with their stars, all that most operators and solvers take: those of a mesh, the simplices
/// that were given, those on which forms obey conditions, or cells of one's own.
class Calculus {
public:
    CellComplex complex;
    /// That whose cells they are, which knows more of conditions on the boundary.
    std::optional<Discretization> mesh = {};

    Calculus(CellComplex cells, HodgeStars stars, double unit = 1)
        : complex(std::move(cells)), stars_(std::move(stars)), unit_(unit) {}
    explicit Calculus(const Discretization& of)
        : complex(of.complex()), mesh(of), stars_(of.stars()), unit_(of.unit()) {}

    /// In the units of the input. Throws InvalidInput where they are no numbers.
    const HodgeStars& stars() const {
        return in_input_->get([this] { return in_input_units(stars_, unit_); });
    }

private:
    HodgeStars stars_; // in the unit of the mesh
    double unit_;
    std::shared_ptr<const Lazy<HodgeStars>> in_input_ = std::make_shared<Lazy<HodgeStars>>();
};

/// The mesh with this star of k-forms, which is in the units of the input.
Discretization with_star_of_input(const Discretization& mesh, int k, const SparseMatrix& star);

/// None: the built-in ones.
using GivenConditions = std::optional<BoundaryConditions>;

/// The cells on which forms obey conditions.
ConditionedComplex conditioned(const Calculus& of, Side side, int degree,
                               const BoundaryConditions& conditions);

} // namespace polydec::python
